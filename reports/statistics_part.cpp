// SPDX-License-Identifier: BSD-3-Clause
// Bias and scatter of each class of quantities over all scenes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

using Points = std::vector<const ScatterPoint*>;

bool by_others(const ScatterPoint& point) {
    return !point.counted &&
           (point.kind == ReferenceKind::peer_simulation || point.kind == ReferenceKind::stated);
}

bool drawable(const ScatterPoint& point) {
    return (point.counted || by_others(point)) && point.expected > 0 && point.predicted > 0;
}

const ClassStatistics* statistics_of(const Summary& summary, const std::string& name) {
    for (const ClassStatistics& each : summary.statistics)
        if (each.quantity_class == name) return &each;
    return nullptr;
}

/// A straight line through the origin over the range, with its two-sigma band where there is a width.
void add_line(Figure& figure, const Window& range, double factor, std::optional<double> sigma,
              const std::string& label, const std::string& colour) {
    PlotSeries line;
    line.style = Style::dashed;
    line.colour = colour;
    line.label = label;
    line.width = 1.4;
    line.data = {{range.begin, range.end}, {factor * range.begin, factor * range.end}};
    if (sigma && *sigma > 0) {
        PlotSeries band = line;
        band.style = Style::band;
        band.label = label + ", ± 2 sigma";
        for (const double y : line.data.y) {
            band.low.push_back(y * std::exp(-2 * *sigma));
            band.high.push_back(y * std::exp(2 * *sigma));
        }
        figure.series.insert(figure.series.begin(), std::move(band));
    }
    figure.series.push_back(std::move(line));
}

Figure scatter_figure(const Points& points, const ClassStatistics* statistics) {
    const ScatterPoint& first = *points.front();
    Figure figure;
    figure.name = "suite-scatter-" + first.quantity_class;
    figure.title = "Predicted against measured: " + first.quantity_class;
    figure.x = {"measured", first.unit, true, {}};
    figure.y = {"predicted", first.unit, true, {}};
    Window range{HUGE_VAL, 0};
    for (const ScatterPoint* p : points) {
        range.begin = std::min({range.begin, p->expected / 1.5, p->predicted / 1.5});
        range.end = std::max({range.end, p->expected * 1.5, p->predicted * 1.5});
    }
    figure.x.range = figure.y.range = range;
    add_line(figure, range, 1, statistics != nullptr ? statistics->sigma_data : std::nullopt, "perfect",
             "#111111");
    if (statistics != nullptr && statistics->bias) {
        add_line(figure, range, *statistics->bias,
                 statistics->sigma_model ? statistics->sigma_model : statistics->scatter,
                 "bias " + number(*statistics->bias), "#b5391f");
        figure.caption =
            fmt::format("{} points. The band around the bias is {}.", statistics->count,
                        statistics->sigma_model ? "the scatter of the model"
                                                : "the whole scatter: the data's part in it is unknown");
    }
    std::map<std::pair<std::string, bool>, PlotSeries> groups;
    for (const ScatterPoint* p : points) {
        PlotSeries& s = groups[{p->scene, p->counted}];
        s.data.x.push_back(p->expected);
        s.data.y.push_back(p->predicted);
    }
    std::map<std::string, std::size_t> scenes;
    for (auto& [key, s] : groups) {
        const std::size_t place = scenes.emplace(key.first, scenes.size()).first->second;
        s.style = Style::points;
        s.colour = variant_colour(place);
        s.marker = static_cast<Marker>(place % 4);
        s.filled = key.second;
        s.point_size = 8;
        s.label = key.first + (key.second ? "" : ", by others, not counted");
        figure.series.push_back(std::move(s));
    }
    return figure;
}

std::string statistics_table(const Summary& summary) {
    Table table({"class", "points", "bias factor", "95 % interval", "scatter s", "sigma of the data",
                 "sigma of the model"},
                "compact");
    for (const ClassStatistics& row : summary.statistics) {
        const bool interval = row.bias_low && row.bias_high;
        table.add(
            {markup(escape(row.quantity_class), "name"), whole(static_cast<double>(row.count)),
             value(row.bias),
             text(interval ? number(*row.bias_low) + " to " + number(*row.bias_high) : "one point: none"),
             value(row.scatter), row.sigma_data ? value(row.sigma_data) : text("unknown"),
             row.sigma_model ? value(row.sigma_model) : text(row.scatter ? "at most s" : "—")});
    }
    return table.empty() ? paragraph("No measured value has been met by a sound run yet.", "soft")
                         : table.html();
}

std::string points_table(const Summary& summary, bool counted) {
    Table table({"class", "scene", "quantity", "against", "measured", "predicted",
                 counted ? "u of the data" : "why not"},
                "compact");
    for (const ScatterPoint& p : summary.scatter) {
        if (p.counted != counted) continue;
        table.add({text(p.quantity_class), text(fmt::format("{}, {}", p.scene, p.variant)), text(p.quantity),
                   text(p.against), value(p.expected, p.unit), value(p.predicted, p.unit),
                   counted ? text(p.u_data ? number(100 * *p.u_data) + " %" : "unknown") : text(p.dropped)});
    }
    return table.empty() ? paragraph("None.", "soft") : table.html();
}

}  // namespace

void add_statistics_part(Page& page, const Summary& summary) {
    page.section(2, "Suite statistics");
    page.add(paragraph(
        "One pair of numbers per class of quantity over all scenes, from the finest sound run of each "
        "scene's "
        "default variant against measurements. Bias: the factor by which predictions are high. Scatter s: "
        "standard deviation of ln(predicted / measured), of data and model together; where the uncertainty "
        "of "
        "the data is unknown it is not split. Few points make wide intervals."));
    page.add(statistics_table(summary));
    std::map<std::string, Points> classes;
    for (const ScatterPoint& point : summary.scatter) {
        if (drawable(point)) classes[point.quantity_class].push_back(&point);
    }
    std::vector<Figure> figures;
    for (const auto& [name, points] : classes)
        figures.push_back(scatter_figure(points, statistics_of(summary, name)));
    page.add_figures(figures);
    page.add(details("Points in the statistics", points_table(summary, true)));
    page.add(details("Dropped points, with the reason", points_table(summary, false)));
}

}  // namespace wetdeck::report
