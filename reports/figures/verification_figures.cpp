// SPDX-License-Identifier: BSD-3-Clause
// Computed and exact curves of a problem, and its errors over resolution.
#include <fmt/format.h>

#include "reports/figures/figures.hpp"
#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

/// Errors over resolution, with the slope in the legend; the bounds are not drawn, they would hide points.
std::optional<Figure> error_figure(const VerificationProblem& problem) {
    Figure figure;
    figure.name = "verification-" + problem.name + "-errors";
    figure.title = problem.title + ": errors";
    figure.caption = "Errors over resolution; the legend gives the slope of the fitted line.";
    figure.x = {"resolution", "-", true, {}};
    figure.y = {"error", "-", true, {}};
    for (const VerificationRow& row : problem.rows) {
        if (row.resolution.size() < 2 || !row.order) continue;
        PlotSeries series =
            line(fmt::format("{}, slope {}", row.claim.quantity, number(*row.order, 2)),
                 {{row.resolution.rbegin(), row.resolution.rend()}, {row.error.rbegin(), row.error.rend()}},
                 variant_colour(figure.series.size()));
        series.style = Style::line_and_points;
        figure.series.push_back(std::move(series));
    }
    if (figure.series.empty()) return std::nullopt;
    return figure;
}

Figure curve_figure(const VerificationProblem& problem, const VerificationFigure& curves) {
    Figure figure;
    figure.name = "verification-" + problem.name + "-" + curves.title;
    figure.title = curves.title;
    figure.caption = "Dashed: exact solution.";
    figure.x = {curves.x_label, curves.x_unit, false, {}};
    figure.y = {curves.y_label, curves.y_unit, false, {}};
    for (const auto& [label, curve] : curves.computed) {
        const std::string colour = run_colour(0, figure.series.size(), curves.computed.size());
        figure.series.push_back(line(label, curve, colour));
    }
    if (!curves.exact.x.empty()) {
        PlotSeries exact = line("exact", curves.exact, "#000000");
        exact.style = Style::dashed;
        figure.series.push_back(std::move(exact));
    }
    return figure;
}

}  // namespace

std::vector<Figure> verification_figures(const VerificationProblem& problem) {
    std::vector<Figure> figures;
    for (const VerificationFigure& curves : problem.figures) figures.push_back(curve_figure(problem, curves));
    if (auto errors = error_figure(problem)) figures.push_back(std::move(*errors));
    return figures;
}

}  // namespace wetdeck::report
