// SPDX-License-Identifier: BSD-3-Clause
// The cost of an accuracy, and other codes.
#include <fmt/format.h>

#include "reports/figures/words.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

Cell run_cell(const std::optional<SpeedErrorPoint>& point) {
    if (!point) return text("none");
    return markup(fmt::format("{}, {}<br><span class=\"soft\">{} core-seconds, error {} %</span>",
                              escape(point->variant), escape(spacing_text(point->dx)), number(point->core_s),
                              number(100 * point->error.value_or(0))));
}

}  // namespace

std::string cheapest_table(const Summary& summary) {
    std::string out;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        Table table({"quantity", "cheapest within 5 %", "cheapest within 10 %", "smallest error"}, "compact");
        for (const CheapestRow& row : summary.cheapest) {
            if (row.scene != scene.scene) continue;
            table.add({markup(fmt::format("<b>{}</b><br><span class=\"soft\">{}</span>",
                                          named_words(quantity_words(scene, row.quantity), row.quantity),
                                          escape(row.against)),
                              "wide"),
                       run_cell(row.within_5), run_cell(row.within_10), run_cell(row.best)});
        }
        if (!table.empty()) out += details(scene.title.empty() ? scene.scene : scene.title, table.html());
    }
    if (out.empty()) return "";
    return "<h4>Cheapest runs within 5 % and 10 %</h4>\n" + out +
           paragraph(
               "Error of a value: relative to the expected value. Error of a curve: rms difference divided "
               "by "
               "the range of the reference. A single run may meet a bound by chance: check that finer "
               "spacings meet it too.",
               "soft");
}

std::string peer_points_table(const Summary& summary) {
    Table table({"scene", "other code", "compared with", "error", "core-seconds", "conditions"}, "compact");
    for (const PeerPoint& point : summary.peers) {
        table.add({named(scene_words(summary, point.scene), point.scene), text(point.name),
                   text(point.reference), value(point.error),
                   point.core_s ? value(point.core_s) : text("not stated"),
                   markup(escape(point.conditions.empty() ? "not stated" : point.conditions), "wide")});
    }
    if (table.empty()) return "";
    return "<h4>Other codes with the same measure of error</h4>\n" + table.html() +
           paragraph(
               "Their curves are compared with the same measurement over the same interval as in the "
               "diagram. Costs on other machines and for other domains can be compared in order of "
               "magnitude only; a code without a stated cost is drawn as a horizontal line.",
               "soft");
}

}  // namespace wetdeck::report
