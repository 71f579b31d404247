// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

bool zero_is_possible(const ValidationRow& row) {
    return std::abs(row.error) <= confidence * row.u_known;
}

bool spacing_dominates(const ValidationRow& row) {
    return row.u_num && *row.u_num > std::hypot(row.u_input.value_or(0), row.u_data.value_or(0));
}

/// Largest error that the user allows, in the unit of the quantity.
std::optional<double> allowed(const ValidationRow& row) {
    if (!row.required) return std::nullopt;
    return *row.required * std::abs(row.reference);
}

bool fit(const ValidationRow& row) {
    const auto most = allowed(row);
    return most && row.interval && std::max(-(*row.interval)[0], (*row.interval)[1]) <= *most;
}

bool unfit(const ValidationRow& row) {
    const auto most = allowed(row);
    return most && row.interval && ((*row.interval)[0] > *most || (*row.interval)[1] < -*most);
}

std::string verdict_of(const ValidationRow& row) {
    if (fit(row)) return "validated";
    if (zero_is_possible(row)) {
        if (spacing_dominates(row)) return "refine first";
        return row.u_known > 0 ? "within the uncertainty" : "unknown";
    }
    if (!row.u_val) return "unknown";
    return row.error > 0 ? "too high" : "too low";
}

std::string with_unit(double value, const ValidationRow& row) {
    return row.unit == "-" || row.unit.empty() ? fmt::format("{:.3g}", value)
                                               : fmt::format("{:.3g} {}", value, row.unit);
}

/// " (12 %)" of the reference; empty where that is zero.
std::string share(double value, const ValidationRow& row) {
    return row.reference == 0 ? "" : fmt::format(" ({:.2g} %)", 100 * std::abs(value / row.reference));
}

std::string missing(const ValidationRow& row) {
    std::vector<std::string> names;
    if (!row.u_num) names.emplace_back("u_num");
    if (!row.u_input) names.emplace_back("u_input");
    if (!row.u_data) names.emplace_back("u_data");
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string largest_part(const ValidationRow& row) {
    const std::pair<double, const char*> parts[] = {
        {row.u_num.value_or(0), "the spacing (u_num): finer particles would help most"},
        {row.u_input.value_or(0), "the inputs (u_input): better known inputs would help most"},
        {row.u_data.value_or(0), "the data (u_data): a better measurement would help most"}};
    return std::max_element(std::begin(parts), std::end(parts),
                            [](const auto& a, const auto& b) { return a.first < b.first; })
        ->second;
}

/// At which value of an assumed uncertainty zero would become possible, or impossible.
std::string turning_value(const ValidationRow& row, const std::string& name) {
    const double part = (name == "u_data" ? row.u_data : row.u_input).value_or(0);
    const double square = std::pow(row.error / confidence, 2) - (std::pow(*row.u_val, 2) - part * part);
    if (!(square > 0)) return fmt::format("{} is assumed, and no value of it would change this", name);
    const double turn = std::sqrt(square);
    return fmt::format("{} is assumed to be {}{}: this would change {} {}{}", name, with_unit(part, row),
                       share(part, row), turn > part ? "above" : "below", with_unit(turn, row),
                       share(turn, row));
}

std::string fitness(const ValidationRow& row) {
    if (!row.required) return "";
    return fmt::format(" Fit for an accuracy of {:.3g} %: {}.", 100 * *row.required,
                       fit(row)     ? "yes"
                       : unfit(row) ? "no"
                                    : "not shown");
}

}  // namespace

void conclude(ValidationRow& row) {
    row.verdict = verdict_of(row);
    const bool negative = row.reference < 0;  // "higher" would be a slower fall
    const char* side = negative        ? row.error > 0 ? "smaller in magnitude" : "larger in magnitude"
                       : row.error > 0 ? "higher"
                                       : "lower";
    row.sentence = fmt::format("The simulation gives {}, the measurement {}: {}{} {}.",
                               with_unit(row.simulated, row), with_unit(row.reference, row),
                               with_unit(std::abs(row.error), row), share(row.error, row), side);
    if (!row.u_val) {
        row.sentence += fmt::format(" {} unknown: the error of the model cannot be bounded.", missing(row));
        return;
    }
    row.sentence += fmt::format(
        " With 95 % confidence the model's error lies between {:.3g} and {}{}. Most of this uncertainty is "
        "that of {}.",
        (*row.interval)[0], with_unit((*row.interval)[1], row),
        zero_is_possible(row) ? ", so that none is shown" : "", largest_part(row));
    for (const std::string& name : row.assumed) row.sentence += fmt::format(" {}.", turning_value(row, name));
    row.sentence += fitness(row);
}

}  // namespace wetdeck
