// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/standard_uncertainty.hpp"

#include <fmt/format.h>

#include <optional>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {

StandardUncertainty uncertainty_in(const std::string& text) {
    constexpr const char* expected =
        "expected a relative uncertainty such as 0.03 or 3 %, or one with the unit of a column";
    const std::size_t gap = std::min(text.find(' '), text.size());
    const std::optional<double> given = number_in(std::string_view(text).substr(0, gap));
    if (!given || !std::isfinite(*given)) throw InputError(fmt::format("is '{}', {}", text, expected));
    if (*given < 0) throw InputError(fmt::format("is negative, {}", expected));
    const std::string unit{trimmed(std::string_view(text).substr(gap))};
    if (unit.empty() || unit == "%") {
        const double share = unit.empty() ? *given : *given / 100;
        if (share > 1) throw InputError(fmt::format("is {:g} %, {}", 100 * share, expected));
        return {share, ""};
    }
    const Unit named = unit_named(unit);
    return {*given * named.factor, si_name(named.powers)};
}

}  // namespace wetdeck
