// SPDX-License-Identifier: BSD-3-Clause
// Variants beside each other: fields at one time, series in one figure.
#include "reports/figures/figures.hpp"
#include "reports/page/html.hpp"
#include "reports/page/player.hpp"
#include "reports/parts/parts.hpp"

namespace wetdeck::report {

void add_side_by_side_part(Page& page, const AnalysisSpec& scene, const Runs& runs,
                           const ReportInputs& inputs) {
    bool first = true;
    for (const SideBySide& entry : scene.side_by_side) {
        const auto pictures = inputs.side_by_side.find({scene.scene, entry.title});
        const bool pictured = pictures != inputs.side_by_side.end() && pictures->second.size() > 1;
        const Figure figure = side_by_side_figure(scene, entry, runs);
        if (!pictured && figure.series.size() < 2) continue;
        if (first) page.section(2, "Variants side by side", scene.scene);
        first = false;
        page.anchor(scene.scene + "-" + slug(entry.title), entry.title);
        page.add("<h4>" + escape(entry.title) + "</h4>\n");
        if (pictured) page.add(picture_grid(pictures->second));
        if (figure.series.size() > 1) page.add(page.figure(figure));
    }
}

}  // namespace wetdeck::report
