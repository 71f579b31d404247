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
    return details("picture", fmt::format("<img src=\"{}\" alt=\"{}, {}\" loading=\"lazy\">",
                                          data_address("image/png", found->second), escape(row.stress_case),
                                          escape(row.setting)));
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
    Table table({"case", "setting", "outcome", "note"});
    for (const StressRow& row : summary.stress) {
        table.add({text(row.stress_case), text(row.setting),
                   markup(row.survived ? "<span class=\"badge good\">survived</span>"
                                       : "<span class=\"badge bad\">did not survive</span>"),
                   markup(escape(row.note) + death_picture(row, inputs), "wide")});
    }
    page.add(table.html());
}

}  // namespace wetdeck::report
