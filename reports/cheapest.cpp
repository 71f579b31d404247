// SPDX-License-Identifier: BSD-3-Clause
// What an accuracy costs, here and in other codes.
#include <fmt/format.h>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

Cell configuration(const std::optional<SpeedErrorPoint>& point) {
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
            table.add({markup(fmt::format("<b>{}</b><br><span class=\"soft\">{}</span>", escape(row.quantity),
                                          escape(row.against)),
                              "wide"),
                       configuration(row.within_5), configuration(row.within_10), configuration(row.best)});
        }
        if (!table.empty()) out += details(scene.scene, table.html());
    }
    if (out.empty()) return "";
    return "<h4>Cheapest configuration within 5 % and 10 %</h4>\n" + out +
           paragraph(
               "Errors: of a value relative to what is expected; of a curve, rms difference over the range "
               "of the reference. One run within a bound may be so by chance: see whether finer "
               "spacings stay there.",
               "soft");
}

std::string peer_points_table(const Summary& summary) {
    Table table({"scene", "other code", "against", "error", "core-seconds", "conditions"}, "compact");
    for (const PeerPoint& point : summary.peers) {
        table.add({markup(escape(point.scene), "name"), text(point.name), text(point.reference),
                   value(point.error), point.core_s ? value(point.core_s) : text("not stated"),
                   markup(escape(point.conditions.empty() ? "not stated" : point.conditions), "wide")});
    }
    if (table.empty()) return "";
    return "<h4>Other codes in the same measure</h4>\n" + table.html() +
           paragraph(
               "Their curves against the same record, in the same window, as the error of the diagram. "
               "Costs on other machines and for other domains compare by order of magnitude only; a code "
               "whose cost nobody has stated is drawn as a level line.",
               "soft");
}

}  // namespace wetdeck::report
