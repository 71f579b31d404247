// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/missing_value_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"

namespace wetdeck {

void MissingValueMarks::see(std::string_view cell, std::size_t column, std::size_t row, std::size_t line) {
    const std::string_view digits = cell.substr(cell.starts_with('-') ? 1 : 0);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::string_view whole = digits.substr(0, point), rest = digits.substr(point);
    if (whole.size() < 3 || whole.find_first_not_of('9') != std::string_view::npos) return;
    if (rest.find_first_not_of(".09") != std::string_view::npos) return;
    marks_.push_back({column, row, line, std::string(cell)});
}

void MissingValueMarks::check(const Reference& reference) const {
    constexpr double far = 20;
    for (const Mark& mark : marks_) {
        const Column& column = reference.columns[mark.column];
        const double marked = column.values[mark.row];
        double largest = 0;
        for (const double value : column.values)
            if (std::isfinite(value) && value != marked) largest = std::max(largest, std::abs(value));
        if (largest == 0 || std::abs(marked) < far * largest) continue;
        throw DataError(
            fmt::format("{}:{}: {} is '{}', far from all other values: if it stands for no value, leave the "
                        "cell empty",
                        reference.path.string(), mark.line, column.name, mark.text));
    }
}

}  // namespace wetdeck
