// SPDX-License-Identifier: BSD-3-Clause
// Convergence of quantities and of whole curves with the particle spacing.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/figures/figures.hpp"
#include "reports/figures/words.hpp"
#include "validation/metrics/curve_convergence.hpp"

namespace wetdeck::report {
namespace {

/// The expected value with its tolerance, as a band over all spacings.
void add_expected(Figure& figure, const AnalysisSpec& scene, const std::string& quantity, double dx_max) {
    for (const QuantitySpec& spec : scene.quantities) {
        if (spec.name != quantity || !spec.expected) continue;
        const double spread = spec.tolerance.value_or(0);
        PlotSeries band;
        band.style = Style::band;
        band.label = "expected value with tolerance";
        band.colour = "#6b7681";
        band.data = {{0, dx_max}, {*spec.expected, *spec.expected}};
        band.low.assign(2, *spec.expected - spread);
        band.high.assign(2, *spec.expected + spread);
        figure.series.push_back(std::move(band));
    }
}

}  // namespace

std::vector<Figure> convergence_figures(const Summary& summary, const AnalysisSpec& scene) {
    std::map<std::string, std::vector<const ConvergenceRow*>> by_quantity;
    for (const ConvergenceRow& row : summary.convergence) {
        if (row.scene == scene.scene && row.dx.size() > 1 && row.dx.size() == row.value.size()) {
            by_quantity[row.qoi].push_back(&row);
        }
    }
    const std::vector<std::string> variants = variants_of(runs_of(summary, scene));
    std::vector<Figure> figures;
    for (const auto& [quantity, rows] : by_quantity) {
        Figure figure;
        figure.name = fmt::format("{}-convergence-{}", scene.scene, quantity);
        figure.identifier = quantity;
        figure.title = fmt::format("{}: {}, by spacing", scene.scene, quantity_words(scene, quantity));
        figure.x = {"particle spacing dx", "m", false, {}};
        figure.y = {quantity_words(scene, quantity), unit_of_quantity(scene, quantity), false, {}};
        double dx_max = 0;
        for (const ConvergenceRow* row : rows)
            dx_max = std::max(dx_max, *std::max_element(row->dx.begin(), row->dx.end()));
        figure.x.range = Window{-0.02 * dx_max, 1.05 * dx_max};  // down to zero spacing
        add_expected(figure, scene, quantity, dx_max);
        for (const ConvergenceRow* row : rows) {
            const auto place = std::find(variants.begin(), variants.end(), row->variant) - variants.begin();
            PlotSeries s;
            s.style = Style::line_and_points;
            s.label = row->variant + ", " + row->verdict;
            s.data = {row->dx, row->value};
            s.colour = variant_colour(static_cast<std::size_t>(place));
            PlotSeries limit = s;
            figure.series.push_back(std::move(s));
            if (!row->extrapolated) continue;
            limit.style = Style::points;
            limit.filled = false;
            limit.point_size = 9;
            limit.label = row->variant + ", extrapolated";
            limit.data = {{0}, {*row->extrapolated}};
            figure.series.push_back(std::move(limit));
        }
        figures.push_back(std::move(figure));
    }
    return figures;
}

std::vector<Figure> curve_convergence_figures(const Summary& summary, const AnalysisSpec& scene) {
    std::vector<Figure> figures;
    for (const std::string& variant : variants_of(runs_of(summary, scene))) {
        Figure figure;
        figure.name = fmt::format("{}-{}-curve-convergence", scene.scene, variant);
        figure.title =
            fmt::format("{}, {}: differences between curves at neighbouring spacings", scene.scene, variant);
        figure.caption =
            "Root mean square difference to the next finer spacing, divided by the range of the curve.";
        figure.x = {"finer of the two spacings", "m", true, {}};
        figure.y = {"rms difference / range", "-", true, {}};
        std::size_t place = 0;
        for (const CurveConvergenceRow& row : summary.curve_convergence) {
            if (row.scene != scene.scene || row.variant != variant) continue;
            const std::vector<double> differences = relative_differences(row);
            if (differences.size() < 2) continue;
            PlotSeries s;
            s.style = Style::line_and_points;
            s.label = series_words(scene, row.series) + ", " + row.verdict;
            s.marker = static_cast<Marker>(place / 5 % 4);
            s.colour = variant_colour(place++);
            s.data = {{row.dx.begin() + 1, row.dx.end()}, differences};
            figure.series.push_back(std::move(s));
        }
        if (!figure.series.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace wetdeck::report
