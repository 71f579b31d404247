// SPDX-License-Identifier: BSD-3-Clause
// Convergence of whole curves: differences between neighbouring spacings.
#include <fmt/format.h>

#include <array>
#include <map>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

using Rows = std::vector<const CurveConvergenceRow*>;

Rows rows_of(const Summary& summary, const std::string& scene, const std::string& variant) {
    Rows rows;
    for (const CurveConvergenceRow& row : summary.curve_convergence) {
        if (row.scene == scene && row.variant == variant) rows.push_back(&row);
    }
    return rows;
}

std::string joined(const std::vector<double>& values, double scale) {
    std::string out;
    for (const double each : values) out += (out.empty() ? "" : " → ") + number(each * scale);
    return out.empty() ? "—" : out;
}

std::string table_of(const Rows& rows) {
    Table table({"curve", "dx [m]", "rms difference to the next finer, % of range", "order",
                 "GCI, % of range", "instants that converge one way", "verdict"},
                "compact");
    for (const CurveConvergenceRow* row : rows) {
        const double percent = row->range > 0 ? 100 / row->range : 0;
        const bool judged = row->dx.size() > 2;
        table.add({markup(escape(row->series), "name"), markup(joined(row->dx, 1), "number"),
                   markup(joined(row->difference, percent), "number"), value(row->order),
                   value(row->gci_fine ? std::optional(*row->gci_fine * percent) : std::nullopt),
                   text(judged ? number(100 * row->monotone_share) + " %" : "—"), text(row->verdict)});
    }
    return table.empty() ? "" : table.html();
}

}  // namespace

std::string curve_convergence_table(const Summary& summary, const AnalysisSpec& scene) {
    std::string out;
    for (const std::string& variant : variants_of(runs_of(summary, scene))) {
        const std::string table = table_of(rows_of(summary, scene.scene, variant));
        if (!table.empty()) out += details("Variant " + variant, table, variant == scene.default_variant);
    }
    if (out.empty()) return "";
    return "<h4>Whole curves</h4>\n" + out +
           paragraph(
               "Over the interval of the first comparison of each series. The order comes from the two "
               "finest differences; without monotonic convergence there is no index and the last "
               "difference is what is known.",
               "soft");
}

std::vector<Figure> curve_convergence_figures(const Summary& summary, const AnalysisSpec& scene) {
    std::vector<Figure> figures;
    for (const std::string& variant : variants_of(runs_of(summary, scene))) {
        Figure figure;
        figure.name = fmt::format("{}-{}-curve-convergence", scene.scene, variant);
        figure.title = fmt::format("{}, {}: curves between neighbouring spacings", scene.scene, variant);
        figure.caption =
            "Root mean square difference to the next finer spacing, over the range of the curve.";
        figure.x = {"finer of the two spacings", "m", true, {}};
        figure.y = {"rms difference / range", "-", true, {}};
        std::size_t place = 0;
        for (const CurveConvergenceRow* row : rows_of(summary, scene.scene, variant)) {
            if (row->difference.size() < 2 || row->range <= 0) continue;
            PlotSeries s;
            s.style = Style::line_and_points;
            s.label = row->series + ", " + row->verdict;
            s.marker = static_cast<Marker>(place / 5 % 4);
            s.colour = variant_colour(place++);
            for (std::size_t k = 0; k < row->difference.size(); ++k) {
                s.data.x.push_back(row->dx[k + 1]);
                s.data.y.push_back(row->difference[k] / row->range);
            }
            figure.series.push_back(std::move(s));
        }
        if (!figure.series.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace wetdeck::report
