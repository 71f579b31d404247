// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/quantity_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

constexpr std::size_t most_lines = 8;

/// A unit that suits the size of a value: kilopascals, milliseconds.
struct SuitedUnit {
    std::string name;
    double size;
};

SuitedUnit suited_unit(const std::string& unit, double value) {
    const bool of_force = unit == "Pa" || unit == "N" || unit == "N/m";
    if (of_force && std::abs(value) >= 1000) return {"k" + unit, 1000};
    if (unit == "s" && value != 0 && std::abs(value) < 1) return {"ms", 0.001};
    return {unit == "-" ? "" : unit, 1};
}

std::string in_unit(double value, const SuitedUnit& unit) {
    return fmt::format("{:.4g}{}{}", value / unit.size, unit.name.empty() ? "" : " ", unit.name);
}

std::string sentence(const QuantityResult& q) {
    if (!q.value) return q.note.empty() ? "not reached" : q.note;
    const SuitedUnit unit =
        suited_unit(q.unit, std::max(std::abs(*q.value), std::abs(q.expected.value_or(0))));
    std::string text = in_unit(*q.value, unit);
    if (q.expected) text += fmt::format(", expected {}", in_unit(*q.expected, unit));
    if (q.expected && q.tolerance) text += fmt::format(" within {:.4g}", *q.tolerance / unit.size);
    if (q.within) text += *q.within ? ": within" : ": outside";
    return text;
}

}  // namespace

std::vector<std::string> quantity_lines(const AnalysisSpec& spec, const RunRecord& record,
                                        ReferenceShelf& references) {
    std::vector<QuantityResult> results;
    std::size_t widest = 0;
    for (const QuantitySpec& quantity : spec.quantities) {
        results.push_back(evaluate_quantity(quantity, record, references));
        widest = std::max(widest, quantity.name.size());
    }
    std::stable_partition(results.begin(), results.end(),
                          [](const QuantityResult& q) { return q.expected.has_value(); });
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < std::min(results.size(), most_lines); ++k)
        lines.push_back(fmt::format("  {:{}}  {}", results[k].name, widest, sentence(results[k])));
    if (results.size() > most_lines)
        lines.push_back(fmt::format("  and {} more in the report", results.size() - most_lines));
    return lines;
}

}  // namespace wetdeck
