// SPDX-License-Identifier: BSD-3-Clause
// Cost and benefit of each ingredient of the model.
#include <fmt/format.h>

#include "reports/figures/words.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {

std::string ablation_table(const Summary& summary, const AnalysisSpec& scene) {
    Table table(
        {"ingredient left out", "dx [m]", "core-seconds, without / with", "change of the error", "needed"},
        "compact");
    for (const AblationRow& row : summary.ablation) {
        if (row.scene != scene.scene) continue;
        table.add({text(row.ingredient), value(row.dx, "-", 4), value(row.core_s_ratio),
                   text(row.error_change ? signed_number(*row.error_change) : "—"),
                   markup(row.needed ? "<span class=\"badge good\">needed</span>"
                                     : "<span class=\"badge warn\">not shown to be needed</span>")});
    }
    if (table.empty())
        return paragraph("There is no ablation study of this scene; `wetdeck ablate` runs one.", "soft");
    const std::string error =
        scene.error_quantity.empty() ? "the scene's error" : quantity_words(scene, scene.error_quantity);
    return table.html() +
           paragraph(
               "Each row is a run without one ingredient of the model. Change of the error: " + error +
                   " without the ingredient minus " + error +
                   " with it; a dash where a run did not complete or its variant does not have this "
                   "quantity. An ingredient is needed if without it the run becomes unstable, a quantity is "
                   "not reached, the error of a quantity with an expected value grows by more than a quarter "
                   "of its tolerance, or another quantity changes by more than its range over the particle "
                   "spacings.",
               "soft");
}

}  // namespace wetdeck::report
