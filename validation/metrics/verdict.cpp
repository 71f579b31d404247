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
    return row.u_grid && *row.u_grid > std::hypot(row.u_scatter.value_or(0), row.u_input.value_or(0),
                                                  row.u_data.value_or(0));
}

/// How a verdict is worded against one kind of reference.
struct Words {
    const char* theirs;      ///< who gives the reference
    const char* bounded;     ///< what lies in the interval
    const char* none_shown;  ///< where zero is possible
    const char* possible;    ///< verdict: zero is possible
    const char* above;       ///< verdict: the simulation is higher
    const char* below;       ///< verdict: it is lower
    const char* data;        ///< what would help against u_data
};

const Words& words_of(std::optional<ReferenceKind> kind) {
    static constexpr Words measured{"the measurement",
                                    "the error of the model",
                                    "so that no error is shown",
                                    "within the uncertainty",
                                    "too high",
                                    "too low",
                                    "that of the measurement (u_data): a better one would help most"};
    static constexpr Words exact{"the exact solution",
                                 "the error of the solution",
                                 "so that no error is shown",
                                 "agrees",
                                 "higher",
                                 "lower",
                                 "that of the exact solution"};
    static constexpr Words other{"the other computation",
                                 "the difference between both",
                                 "so that they agree within what both can tell",
                                 "agrees",
                                 "higher",
                                 "lower",
                                 "that of the other computation (u_data): a finer one would help most"};
    static constexpr Words stated{"the value stated in a publication",
                                  "the difference between both",
                                  "so that they agree within what both can tell",
                                  "agrees",
                                  "higher",
                                  "lower",
                                  "that of the stated value (u_data)"};
    if (!kind || describe(*kind).validates) return measured;
    if (*kind == ReferenceKind::stated) return stated;
    return describe(*kind).exact ? exact : other;
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

std::string verdict_of(const ValidationRow& row, const Words& words) {
    if (fit(row)) return "validated";
    if (zero_is_possible(row)) {
        if (spacing_dominates(row)) return "refine first";
        return row.u_known > 0 ? words.possible : "unknown";
    }
    if (!error_is_shown(row)) return "unknown";
    return row.error > 0 ? words.above : words.below;
}

std::string with_unit(double value, const ValidationRow& row) {
    return row.unit == "-" || row.unit.empty() ? fmt::format("{:.3g}", value)
                                               : fmt::format("{:.3g} {}", value, row.unit);
}

/// " (12 %)" of the reference; empty where that is zero.
std::string share(double value, const ValidationRow& row) {
    return row.reference == 0 ? "" : fmt::format(" ({:.2g} %)", 100 * std::abs(value / row.reference));
}

/// On which side of the reference the simulation is. Of a negative reference "higher" would be a slower fall.
const char* side_of(const ValidationRow& row) {
    const bool larger = (row.error > 0) == (row.reference >= 0);
    if (row.unit == "s") return row.error > 0 ? "later" : "earlier";
    if (row.unit == "m/s") return larger ? "faster" : "slower";
    if (row.reference < 0) return larger ? "larger in magnitude" : "smaller in magnitude";
    return larger ? "higher" : "lower";
}

std::string missing(const ValidationRow& row) {
    std::vector<std::string> names;
    if (!row.u_num) names.emplace_back("u_num");
    if (!row.u_input) names.emplace_back("u_input");
    if (!row.u_data) names.emplace_back("u_data");
    return fmt::format("{}", fmt::join(names, ", "));
}

struct Part {
    double size;
    const char* name;
    std::string help;
};

/// The largest part of the uncertainty, and what would make it smaller.
Part largest_part(const ValidationRow& row, const Words& words) {
    const Part parts[] = {
        {row.u_grid.value_or(0), "spacing", "that of the spacing (u_grid): finer particles would help most"},
        {row.u_scatter.value_or(0), "arrangement",
         "the scatter among arrangements of the particles (u_scatter): the mean of several replicates would "
         "help most"},
        {row.u_input.value_or(0), "inputs",
         fmt::format("that of the inputs (u_input): a better known {} would help most", row.largest_input)},
        {row.u_data.value_or(0), "reference", words.data}};
    return *std::max_element(std::begin(parts), std::end(parts),
                             [](const Part& a, const Part& b) { return a.size < b.size; });
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

bool error_is_shown(const ValidationRow& row) {
    return row.u_val && !zero_is_possible(row);
}

void conclude(ValidationRow& row) {
    const Words& words = words_of(row.kind);
    row.verdict = verdict_of(row, words);
    row.sentence = fmt::format("The simulation gives {}, {} {}: {}{} {}.", with_unit(row.simulated, row),
                               words.theirs, with_unit(row.reference, row),
                               with_unit(std::abs(row.error), row), share(row.error, row), side_of(row));
    const Part largest = largest_part(row, words);
    if (largest.size > 0) row.largest_part = largest.name;
    if (!row.u_val) {
        row.sentence += fmt::format(" {} unknown: {} cannot be bounded.", missing(row), words.bounded);
        return;
    }
    row.sentence += fmt::format(" With 95 % confidence {} lies between {:.3g} and {}{}.", words.bounded,
                                (*row.interval)[0], with_unit((*row.interval)[1], row),
                                zero_is_possible(row) ? fmt::format(", {}", words.none_shown) : "");
    if (largest.size > 0) row.sentence += fmt::format(" Most of this uncertainty is {}.", largest.help);
    for (const std::string& name : row.assumed) row.sentence += fmt::format(" {}.", turning_value(row, name));
    row.sentence += fitness(row);
}

}  // namespace wetdeck
