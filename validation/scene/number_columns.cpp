// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/number_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/core/errors.hpp"
#include "validation/metrics/column_titles.hpp"
#include "validation/metrics/units.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr std::uintmax_t largest_file = 20'000'000;  // [bytes]

/// A column and what its numbers are multiplied by.
struct ScaledColumn {
    NumberColumn column;
    double factor = 1;
};

ScaledColumn column_in(std::string_view cell, const TextLines& lines) {
    const ColumnTitle title = title_in(cell);
    ScaledColumn found{{std::string(title.name), std::string(title.unit), {}}};
    if (title.name.empty()) lines.fail("a column has no title");
    if (begins_as_number(title.name))
        lines.fail(fmt::format("'{}' is a number, expected a line of titles first, as in 't [s], y [m]'",
                               title.name));
    if (!title.has_unit && cell.find('[') != std::string_view::npos)
        lines.fail(fmt::format("'{}' is no title, expected one as in 't [s]'", cell));
    if (!title.has_unit) return found;
    try {
        found.factor = unit_named(found.column.unit).factor;
    } catch (const InputError& error) {
        lines.fail(error.what());
    }
    return found;
}

}  // namespace

std::vector<NumberColumn> parse_columns(const std::string& name, const std::string& text) {
    TextLines lines(name, text);
    std::vector<ScaledColumn> titles;
    std::optional<char> separator;
    while (lines.next()) {
        const std::string_view line = trimmed(without_comment(lines.line()));
        if (line.empty()) continue;
        const bool first = titles.empty();
        // titles hold spaces before their brackets
        const char found = line.find(';') != line.npos             ? ';'
                           : line.find(',') != line.npos           ? ','
                           : first && line.find('\t') != line.npos ? '\t'
                                                                   : ' ';
        std::vector<std::string_view> cells = cells_of(line, found == '\t' ? ' ' : found);
        drop_empty_end(cells, titles.size());
        if (first) {
            for (const std::string_view cell : cells) titles.push_back(column_in(cell, lines));
            for (std::size_t k = 0; k < titles.size(); ++k)
                for (std::size_t j = 0; j < k; ++j)
                    if (titles[k].column.name == titles[j].column.name)
                        lines.fail(fmt::format("two columns are named '{}'", titles[k].column.name));
            continue;
        }
        if (cells.size() != titles.size())
            lines.fail(fmt::format("holds {} numbers, expected {}", cells.size(), titles.size()));
        if (separator.value_or(found) != found)
            lines.fail(fmt::format("numbers between {}, between {} in the lines before",
                                   separator_name(found), separator_name(*separator)));
        separator = found;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const std::optional<double> number = number_in(cells[k]);
            if (!number || !std::isfinite(*number))
                lines.fail(fmt::format("'{}' is no finite number{}", cells[k], reading_hint(cells[k])));
            titles[k].column.values.push_back(titles[k].factor * *number);
        }
    }
    std::vector<NumberColumn> columns;
    for (ScaledColumn& title : titles) columns.push_back(std::move(title.column));
    if (columns.empty() || columns.front().values.empty())
        throw DataError(fmt::format("{}: holds no numbers", name));
    return columns;
}

std::vector<NumberColumn> read_columns(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw InputError(fmt::format("{}: no such file", file.string()));
    if (std::filesystem::file_size(file, error) > largest_file)
        throw InputError(fmt::format("{}: larger than {} bytes", file.string(), largest_file));
    return parse_columns(file.string(), read_whole_file(file));
}

}  // namespace wetdeck
