// SPDX-License-Identifier: BSD-3-Clause
// What each ingredient of the model costs and buys, and which hard cases are survived.
#include <fmt/format.h>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

std::string death_picture(const StressRow& row, const ReportInputs& inputs) {
    const auto found = inputs.deaths.find(row.picture);
    if (found == inputs.deaths.end()) return "";
    return fmt::format("<br><img src=\"{}\" alt=\"{}, {}\" loading=\"lazy\">",
                       data_address("image/png", found->second), escape(row.stress_case),
                       escape(row.setting));
}

/// Rows of other schemes than the default say so behind the setting.
std::string scheme_of(const StressRow& row) {
    const std::size_t comma = row.setting.rfind(", ");
    const std::string last = comma == std::string::npos ? "" : row.setting.substr(comma + 2);
    return last == "paper" || last == "no dissipation" ? last : "default";
}

bool is_search(const StressRow& row) {
    return row.setting.starts_with("limit of ");
}

std::string survival_table(const std::vector<StressRow>& rows) {
    Table table({"scheme", "settings", "survived"});
    for (const char* scheme : {"default", "no dissipation", "paper"}) {
        std::size_t all = 0, survived = 0;
        for (const StressRow& row : rows) {
            if (is_search(row) || scheme_of(row) != scheme) continue;
            ++all;
            if (row.survived) ++survived;
        }
        if (all > 0)
            table.add({text(scheme), whole(static_cast<double>(all)), whole(static_cast<double>(survived))});
    }
    return table.html();
}

/// The rows that `wanted` takes.
template <class Wanted>
std::string stress_table(const Summary& summary, const ReportInputs& inputs, const Wanted& wanted) {
    Table table({"case", "setting", "outcome", "note"});
    for (const StressRow& row : summary.stress) {
        if (!wanted(row)) continue;
        table.add({text(row.stress_case), text(row.setting),
                   markup(row.survived ? "<span class=\"badge good\">survived</span>"
                                       : "<span class=\"badge bad\">did not survive</span>"),
                   markup(escape(row.note) + death_picture(row, inputs), "wide")});
    }
    return table.empty() ? "" : table.html();
}

}  // namespace

std::string ablation_table(const Summary& summary, const AnalysisSpec& scene) {
    Table table({"left out", "dx [m]", "core-seconds, without over with", "change of the error", "needed"},
                "compact");
    for (const AblationRow& row : summary.ablation) {
        if (row.scene != scene.scene) continue;
        const std::string sign = row.error_change.value_or(0) > 0 ? "+" : "";
        table.add({text(row.ingredient), value(row.dx, "-", 4), value(row.core_s_ratio),
                   text(row.error_change ? sign + number(*row.error_change) : "—"),
                   markup(row.needed ? "<span class=\"badge good\">needed</span>"
                                     : "<span class=\"badge warn\">not shown to be needed</span>")});
    }
    if (table.empty())
        return paragraph("Not run for this scene: `wetdeck ablate` leaves its table here.", "soft");
    return table.html() +
           paragraph(
               "One ingredient left out at a time. Change of the error: " +
                   (scene.error_quantity.empty() ? std::string("the scene's error") : scene.error_quantity) +
                   ", without it minus with it; a dash where a run did not reach its end or its variant has "
                   "no such quantity. Needed at this "
                   "accuracy: unstable without it, or a quantity is not reached, or the error of one with an "
                   "expected value grows by more than a quarter of its tolerance, or one without moves by "
                   "more "
                   "than its range over the spacings.",
               "soft");
}

void add_stress_part(Page& page, const Summary& summary, const ReportInputs& inputs) {
    if (summary.stress.empty()) return;
    page.section(2, "Hard cases");
    page.add(survival_table(summary.stress));
    const auto by_default = [](const StressRow& row) { return scheme_of(row) == "default"; };
    const std::string deaths =
        stress_table(summary, inputs, [&](const StressRow& row) { return by_default(row) && !row.survived; });
    page.add(deaths.empty() ? paragraph("The default scheme survived every setting.")
                            : "<h4>What the default scheme did not survive</h4>\n" + deaths);
    const std::string limits = stress_table(summary, inputs, is_search);
    if (!limits.empty()) page.add("<h4>How far from what is in use the limits lie</h4>\n" + limits);
    page.add(
        details("What the default scheme survived", stress_table(summary, inputs, [&](const StressRow& row) {
                    return by_default(row) && row.survived && !is_search(row);
                })));
    page.add(details("Other schemes",
                     stress_table(summary, inputs, [&](const StressRow& row) { return !by_default(row); })));
}

}  // namespace wetdeck::report
