// SPDX-License-Identifier: BSD-3-Clause
// Where a reader of Yang et al. (2020), Ocean Engineering 199, 107039, finds the counterpart of each figure.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

struct PaperFigure {
    int number;
    const char* shows;
    const char* scene;
    std::array<const char*, 3> places;  ///< anchors of this page; all that exist are linked
    const char* remark;
};

constexpr const char* sketch_only = "The sketch is drawn from the scene file.";
constexpr const char* no_pair =
    "No pair of snapshots: what the switched dissipation does is judged by numbers in the ablation table; "
    "the "
    "default scheme has another dissipation, the paper variant has the switch.";

constexpr std::array<PaperFigure, 22> paper_figures{{
    {3,
     "dam break, six instants of pressure and air speed",
     "dam_break",
     {"section-dam-break-fields"},
     "At the nearest stored frames."},
    {4,
     "dam break at T = 6.17 with and without the switched dissipation",
     "dam_break",
     {"section-dam-break-ablation"},
     no_pair},
    {5,
     "dam break, surge front by spacing",
     "dam_break",
     {"dam-break-two-phase-front", "dam-break-variants-front"},
     "The measured front of Buchner (2002) has not been found: Ritter's front and other simulations are "
     "drawn."},
    {6,
     "dam break, pressure on the right wall",
     "dam_break",
     {"dam-break-two-phase-pressure-019", "dam-break-two-phase-pressure-gauge"},
     "At the paper's point and over the gauge's disc."},
    {7,
     "dam break, change of the total energy",
     "dam_break",
     {"dam-break-two-phase-energy-change"},
     "The energy curve of Cao et al. (2018) has not been found."},
    {8, "sinking rectangle, set-up", "sinking_rectangle", {"set-up-sinking-rectangle"}, sketch_only},
    {9,
     "sinking rectangle, eight instants",
     "sinking_rectangle",
     {"section-sinking-rectangle-fields"},
     "At the nearest stored frames."},
    {10,
     "sinking rectangle, displacements by spacing",
     "sinking_rectangle",
     {"sinking-rectangle-two-phase-body-x", "sinking-rectangle-two-phase-body-y", "sinking-rectangle-body-x"},
     ""},
    {11, "wedge, set-up", "wedge", {"set-up-wedge"}, sketch_only},
    {12, "wedge, snapshots", "wedge", {"section-wedge-fields"}, "At the nearest stored frames."},
    {13,
     "wedge at t = 0.68 s with and without the switched dissipation",
     "wedge",
     {"section-wedge-ablation"},
     no_pair},
    {14,
     "wedge, force and falling speed",
     "wedge",
     {"wedge-variants-body-force-y", "wedge-body-force-y", "wedge-body-velocity-y"},
     ""},
    {15, "wedge, force by spacing", "wedge", {"wedge-two-phase-body-force-y"}, "One line per spacing."},
    {16, "flat plate, set-up", "flat_plate", {"set-up-flat-plate"}, sketch_only},
    {17,
     "flat plate, snapshots",
     "flat_plate",
     {"section-flat-plate-fields"},
     "At the nearest stored frames."},
    {18,
     "flat plate, force with and without air",
     "flat_plate",
     {"flat-plate-variants-body-force-y", "flat-plate-two-phase-body-force-y", "flat-plate-body-force-y"},
     ""},
    {19, "catamaran, set-up", "catamaran", {"set-up-catamaran"}, sketch_only},
    {20,
     "catamaran, acceleration of the three models",
     "catamaran",
     {"catamaran-variants-body-acceleration-y", "catamaran-body-acceleration-y"},
     ""},
    {21,
     "catamaran without air at its two peaks",
     "catamaran",
     {"section-catamaran-fields"},
     "Variant no-air, at the nearest stored frames."},
    {22,
     "catamaran with air at its peak",
     "catamaran",
     {"section-catamaran-fields"},
     "Variant air-model-1, at the nearest stored frames; the pressure of the air is not drawn."},
    {23,
     "catamaran, air model 2 at its peak",
     "catamaran",
     {"section-catamaran-fields"},
     "Variant air-model-2, at the nearest stored frames."},
    {24,
     "catamaran, pressure at P4",
     "catamaran",
     {"catamaran-variants-pressure-p4", "catamaran-air-model-1-pressure-p4"},
     ""},
}};

std::string reason_for_absence(const Summary& summary, std::string_view scene) {
    const bool run = std::any_of(summary.runs.begin(), summary.runs.end(),
                                 [&](const RunSummary& r) { return r.record.scene == scene; });
    return run ? "Absent: the runs of this directory left nothing to draw it from."
               : fmt::format("Absent: no run of the scene {} is in this directory.", scene);
}

}  // namespace

void add_paper_part(Page& page, const Summary& summary) {
    const auto of_paper = [](const RunSummary& run) {
        return std::any_of(paper_figures.begin(), paper_figures.end(),
                           [&](const PaperFigure& figure) { return figure.scene == run.record.scene; });
    };
    if (std::none_of(summary.runs.begin(), summary.runs.end(), of_paper)) return;
    page.section(2, "The paper's figures in this report");
    Table table({"figure", "shows", "place in this report", "remark"});
    for (const PaperFigure& figure : paper_figures) {
        std::string places;
        for (const char* place : figure.places) {
            if (place == nullptr) continue;
            for (const std::string& anchor : page.anchors_like(place)) {
                places += fmt::format("{}<a href=\"#{}\">{}</a>", places.empty() ? "" : "<br>", anchor,
                                      escape(page.title_of(anchor)));
            }
        }
        const std::string absent = places.empty() ? reason_for_absence(summary, figure.scene) : "";
        table.add({text(std::to_string(figure.number)), text(figure.shows),
                   places.empty() ? text(absent) : markup(places), text(figure.remark)});
    }
    page.add(paragraph("Yang et al. (2020), Ocean Engineering 199, 107039, Figures 3 to 24."));
    page.add(table.html());
}

}  // namespace wetdeck::report
