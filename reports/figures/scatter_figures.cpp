// SPDX-License-Identifier: BSD-3-Clause
// Predicted over measured values, by class of quantities.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/figures/figures.hpp"
#include "reports/page/html.hpp"
#include "validation/metrics/statistics.hpp"

namespace wetdeck::report {
namespace {

using Points = std::vector<const ScatterPoint*>;

bool not_measured(const ScatterPoint& point) {
    return !point.counted &&
           (point.kind == ReferenceKind::peer_simulation || point.kind == ReferenceKind::stated);
}

bool drawable(const ScatterPoint& point) {
    const bool measured = point.counted && describe(*point.kind).validates;
    return (measured || not_measured(point)) && point.predicted * point.expected > 0;
}

/// Those against measurements of the class to which it belongs.
const ClassStatistics* statistics_of(const Summary& summary, const std::string& name) {
    for (const ClassStatistics& each : summary.statistics)
        if (each.quantity_class == statistics_class(name) && describe(each.against).validates) return &each;
    return nullptr;
}

/// A straight line through the origin over the range, with a band of two standard deviations if `sigma` is
/// known.
void add_ray(Figure& figure, const Window& range, double factor, std::optional<double> sigma,
             const std::string& label, const std::string& colour) {
    PlotSeries ray =
        line(label, {{range.begin, range.end}, {factor * range.begin, factor * range.end}}, colour);
    ray.style = Style::dashed;
    ray.width = 1.4;
    if (sigma && *sigma > 0) {
        PlotSeries band = ray;
        band.style = Style::band;
        band.label = label + ", ± 2 sigma";
        for (const double y : ray.data.y) {
            band.low.push_back(y * std::exp(-2 * *sigma));
            band.high.push_back(y * std::exp(2 * *sigma));
        }
        figure.series.insert(figure.series.begin(), std::move(band));
    }
    figure.series.push_back(std::move(ray));
}

Figure scatter_figure(const Points& points, const ClassStatistics* statistics) {
    const ScatterPoint& first = *points.front();
    Figure figure;
    figure.name = "suite-scatter-" + first.quantity_class;
    figure.title = "Predicted against measured: " + first.quantity_class;
    figure.x = {"measured, magnitude", first.unit, true, {}};
    figure.y = {"predicted, magnitude", first.unit, true, {}};
    Window range{HUGE_VAL, 0};
    for (const ScatterPoint* p : points) {
        const double expected = std::abs(p->expected), predicted = std::abs(p->predicted);
        range.begin = std::min({range.begin, expected / 1.5, predicted / 1.5});
        range.end = std::max({range.end, expected * 1.5, predicted * 1.5});
    }
    figure.x.range = figure.y.range = range;
    add_ray(figure, range, 1, statistics != nullptr ? statistics->sigma_data : std::nullopt,
            "perfect agreement", "#111111");
    if (statistics != nullptr && statistics->bias) {
        add_ray(figure, range, *statistics->bias,
                statistics->sigma_model ? statistics->sigma_model : statistics->scatter,
                "bias " + number(*statistics->bias), "#b5391f");
        figure.caption = fmt::format(
            "{} {} of {}. The band around the bias is {}.", statistics->count,
            statistics->count == 1 ? "point" : "points", statistics->quantity_class,
            statistics->sigma_model ? "the scatter of the model"
                                    : "the total scatter, because the uncertainty of the data is unknown");
    }
    std::map<std::pair<std::string, bool>, PlotSeries> groups;
    for (const ScatterPoint* p : points) {
        PlotSeries& s = groups[{p->scene, p->counted}];
        s.data.x.push_back(std::abs(p->expected));
        s.data.y.push_back(std::abs(p->predicted));
    }
    std::map<std::string, std::size_t> scenes;
    for (auto& [key, s] : groups) {
        const std::size_t place = scenes.emplace(key.first, scenes.size()).first->second;
        s.style = Style::points;
        s.colour = variant_colour(place);
        s.marker = static_cast<Marker>(place % 4);
        s.filled = key.second;
        s.point_size = 8;
        s.label = key.first + (key.second ? "" : ", other simulation or stated value, not counted");
        figure.series.push_back(std::move(s));
    }
    return figure;
}

}  // namespace

std::vector<Figure> scatter_figures(const Summary& summary) {
    std::map<std::string, Points> classes;
    for (const ScatterPoint& point : summary.scatter) {
        if (drawable(point)) classes[point.quantity_class].push_back(&point);
    }
    std::vector<Figure> figures;
    for (const auto& [name, points] : classes)
        figures.push_back(scatter_figure(points, statistics_of(summary, name)));
    return figures;
}

}  // namespace wetdeck::report
