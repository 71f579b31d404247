// SPDX-License-Identifier: BSD-3-Clause
// The verdicts of all scenes in one table, and what would help most.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "reports/parts/outcomes.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/verdict.hpp"

namespace wetdeck::report {
namespace {

/// Core-seconds of all spacings of the variant: what the value and its u_num took.
double cost(const Summary& summary, const ValidationRow& row) {
    double sum = 0;
    for (const RunSummary& run : summary.runs)
        if (run.record.scene == row.scene && run.record.variant == row.variant && counts(run))
            sum += run.record.cost.core_s;
    return sum;
}

std::string interval_text(const ValidationRow& row) {
    if (!row.interval) return "not bounded";
    const auto [low, high] = *row.interval;
    if (row.reference == 0) return signed_number(low) + " to " + signed_number(high);
    const double unit = 100 / std::abs(row.reference);
    return fmt::format("{} to {} %", signed_number(unit * low), signed_number(unit * high));
}

std::string verdicts_table(const Summary& summary, const std::vector<ValidationRow>& rows) {
    Table table({"scene", "quantity", "simulation", "reference", "error", "95 % interval of the error",
                 "verdict", "core-seconds", "what would help most"},
                "compact");
    for (const ValidationRow& row : rows) {
        const AnalysisSpec scene = scene_named(summary, row.scene);
        const std::string unit = unit_words(scene, row);
        const std::string of_variant = fmt::format(
            "{}<br><span class=\"soft\">{}</span>",
            named_words(scene_label(row.scene), scene_words(summary, row.scene)), escape(row.variant));
        table.add(
            {markup(of_variant), named(quantity_words(scene, row.quantity), row.quantity),
             value(row.simulated, unit),
             markup(fmt::format("{}<br><span class=\"soft\">{}</span>",
                                escape(number_with_unit(row.reference, unit)), escape(kind_words(row.kind)))),
             row.reference == 0 ? value(row.error, unit)
                                : text(signed_number(100 * row.error / std::abs(row.reference)) + " %"),
             text(interval_text(row)),
             markup("<b>" + escape(verdict_words(scene, row)) + "</b>" +
                    (row.assumed.empty() ? "" : "<br><span class=\"soft\">by judgement</span>")),
             value(cost(summary, row)), text(error_is_shown(row) ? "decided" : what_would_help(row))});
    }
    return table.html();
}

/// "within the uncertainty 12, too high 5, ..."
template <class Of>
std::string counted(const std::vector<ValidationRow>& rows, Of&& of) {
    std::map<std::string, int> counts;
    for (const ValidationRow& row : rows) ++counts[of(row)];
    std::vector<std::pair<int, std::string>> sorted;
    for (const auto& [name, count] : counts) sorted.emplace_back(-count, name);
    std::sort(sorted.begin(), sorted.end());
    std::string out;
    for (const auto& [count, name] : sorted)
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", name, -count);
    return out;
}

}  // namespace

std::string what_would_help(const ValidationRow& row) {
    if (row.verdict == "unknown" && !row.u_num) return "a third spacing";
    if (row.largest_part == "spacing") return "finer spacing";
    if (row.largest_part == "arrangement") return "mean of replicates";
    if (row.largest_part == "inputs") return "better known " + row.largest_input;
    if (row.largest_part == "reference") return "better reference data";
    return "—";
}

void add_verdicts_part(Page& page, const Summary& summary) {
    if (summary.validation.empty() && summary.agreement.empty()) return;
    page.section(2, "Verdicts");
    page.add(paragraph(
        "Each value at its finest spacing beside its reference, with the interval in which the error of the "
        "simulation lies with a confidence of 95 %: what spacing, arrangement of the particles, inputs and "
        "reference leave open. Core-seconds: of all spacings of the variant. By judgement: a part of the "
        "uncertainty is assumed; the scene's own table says which, why, and at which value the verdict would "
        "change."));
    if (!summary.validation.empty()) {
        page.add("<h3>Against measurements</h3>\n" + verdicts_table(summary, summary.validation));
        std::vector<ValidationRow> open;
        for (const ValidationRow& row : summary.validation)
            if (!error_is_shown(row)) open.push_back(row);
        page.add(paragraph(fmt::format("Verdicts: {}.", counted(summary.validation,
                                                                [&](const ValidationRow& row) {
                                                                    return verdict_words(
                                                                        scene_named(summary, row.scene), row);
                                                                })) +
                           (open.empty() ? ""
                                         : fmt::format(" Where an error is not shown, most would help: {}.",
                                                       counted(open, what_would_help)))));
    }
    if (!summary.agreement.empty())
        page.add(details("Against exact solutions and other computations",
                         verdicts_table(summary, summary.agreement)));
}

}  // namespace wetdeck::report
