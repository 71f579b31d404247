// SPDX-License-Identifier: BSD-3-Clause
// Bias and scatter of each class of quantities over all scenes.
#include <fmt/format.h>

#include "reports/figures/figures.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "reports/parts/parts.hpp"

namespace wetdeck::report {
namespace {

std::string statistics_table(const Summary& summary) {
    Table table({"class", "against", "points", "bias factor", "95 % interval", "scatter s",
                 "sigma of the data", "sigma of the model"},
                "compact");
    for (const ClassStatistics& row : summary.statistics) {
        const bool interval = row.bias_low && row.bias_high;
        table.add(
            {markup(escape(row.quantity_class), "name"), text(describe(row.against).heading),
             whole(static_cast<double>(row.count)), value(row.bias),
             text(interval ? number(*row.bias_low) + " to " + number(*row.bias_high) : "none, one point"),
             value(row.scatter), row.sigma_data ? value(row.sigma_data) : text("unknown"),
             row.sigma_model ? value(row.sigma_model) : text(row.scatter ? "at most s" : "—")});
    }
    return table.empty()
               ? paragraph("No completed run has a measured or exact value to compare with.", "soft")
               : table.html();
}

std::string points_table(const Summary& summary, bool counted) {
    Table table({"class", "scene", "quantity", "compared with", "expected", "predicted",
                 counted ? "uncertainty of the data" : "reason"},
                "compact");
    for (const ScatterPoint& p : summary.scatter) {
        if (p.counted != counted) continue;
        table.add({text(p.quantity_class),
                   markup(named_words(scene_words(summary, p.scene), p.scene) + ", " + escape(p.variant)),
                   named(quantity_words(summary, p.scene, p.quantity), p.quantity), text(p.against),
                   value(p.expected, p.unit), value(p.predicted, p.unit),
                   counted ? text(p.u_data ? number(100 * *p.u_data) + " %" : "unknown") : text(p.dropped)});
    }
    return table.empty() ? paragraph("None.", "soft") : table.html();
}

}  // namespace

void add_statistics_part(Page& page, const Summary& summary) {
    page.section(2, "Suite statistics");
    page.add(paragraph(
        "Bias and scatter of each class of quantities over all scenes, from the finest completed run of each "
        "scene's default variant, compared with measurements; and from the finest run of every variant, "
        "compared with exact or analytic solutions, which says how well the equations are solved and not how "
        "well they describe water. Motion: positions, velocities, angles, accelerations. Bias factor: mean "
        "ratio of predicted to expected values. Scatter s: standard deviation of ln(predicted / measured), "
        "which contains the "
        "uncertainty of the data and the error of the model; the two are separated where the uncertainty of "
        "the data is known. Few points give wide intervals."));
    page.add(statistics_table(summary));
    page.add_figures(scatter_figures(summary));
    page.add(details("Points in the statistics", points_table(summary, true)));
    page.add(details("Points left out of the statistics, with the reason", points_table(summary, false)));
}

}  // namespace wetdeck::report
