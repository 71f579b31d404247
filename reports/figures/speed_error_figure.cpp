// SPDX-License-Identifier: BSD-3-Clause
// Error over cost of the runs of a scene, with other codes.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/figures/figures.hpp"
#include "reports/figures/reference_names.hpp"

namespace wetdeck::report {
namespace {

/// Adds other codes: a hollow point where the cost is stated, a horizontal line where it is not.
void add_peers(Figure& figure, const Summary& summary, const std::string& scene) {
    const Window costs = data_range(figure, true);
    for (const PeerPoint& peer : summary.peers) {
        if (peer.scene != scene || !(peer.error > 0)) continue;
        const std::string name = reference_name(peer.name, peer.reference);
        PlotSeries s;
        s.colour = "#7d868e";
        s.width = 1.1;
        if (peer.core_s) {
            s.style = Style::points;
            s.filled = false;
            s.marker = Marker::diamond;
            s.point_size = 9;
            s.label = name + " (peer)";
            s.data = {{*peer.core_s}, {peer.error}};
        } else {
            s.style = Style::dashed;
            s.label = name + " (peer, cost not stated)";
            s.data = {{costs.begin, costs.end}, {peer.error, peer.error}};
        }
        figure.series.push_back(std::move(s));
    }
}

}  // namespace

Figure speed_error_figure(const Summary& summary, const AnalysisSpec& scene) {
    std::map<std::string, std::vector<const SpeedErrorPoint*>> by_variant;
    for (const SpeedErrorPoint& point : summary.speed_error) {
        if (point.scene == scene.scene && point.error && *point.error > 0 && point.core_s > 0) {
            by_variant[point.variant].push_back(&point);
        }
    }
    Figure figure;
    figure.name = scene.scene + "-speed-error";
    figure.title = scene.scene + ": speed against error";
    std::set<std::string> targets;
    bool relative = false;
    for (const auto& [variant, points] : by_variant) {
        for (const SpeedErrorPoint* point : points) {
            targets.insert(point->against);
            relative = relative || point->relative;
        }
    }
    figure.caption = fmt::format("Error of {}{}.", scene.error_quantity,
                                 targets.size() == 1 ? " against " + *targets.begin() : "");
    figure.x = {"cost", "core-seconds", true, {}};
    figure.y = {(relative ? "relative error: " : "error: ") + scene.error_quantity,
                relative ? "-" : unit_of_quantity(scene, scene.error_quantity),
                true,
                {}};
    const std::vector<std::string> variants = variants_of(runs_of(summary, scene));
    PlotSeries best;
    best.style = Style::points;
    best.filled = false;
    best.point_size = 13;
    best.colour = "#111111";
    best.label = "Pareto-optimal";
    for (auto& [variant, points] : by_variant) {
        std::sort(points.begin(), points.end(), [](const auto* a, const auto* b) { return a->dx > b->dx; });
        const auto place = std::find(variants.begin(), variants.end(), variant) - variants.begin();
        PlotSeries s;
        s.style = Style::line_and_points;
        s.label = variant + (targets.size() > 1 ? ", against " + points.front()->against : "");
        s.colour = variant_colour(static_cast<std::size_t>(place));
        for (const SpeedErrorPoint* point : points) {
            s.data.x.push_back(point->core_s);
            s.data.y.push_back(*point->error);
            s.point_labels.push_back(spacing_text(point->dx));
            if (!point->pareto) continue;
            best.data.x.push_back(point->core_s);
            best.data.y.push_back(*point->error);
        }
        figure.series.push_back(std::move(s));
    }
    if (!best.data.x.empty()) figure.series.push_back(std::move(best));
    if (!figure.series.empty()) add_peers(figure, summary, scene.scene);
    return figure;
}

}  // namespace wetdeck::report
