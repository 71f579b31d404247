// SPDX-License-Identifier: BSD-3-Clause
// Error over cost of the runs of a scene, with other codes.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/figures/figures.hpp"
#include "reports/figures/reference_names.hpp"
#include "reports/figures/words.hpp"

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

using Points = std::vector<const SpeedErrorPoint*>;

/// The points that a logarithmic diagram can show, by variant and from coarse to fine.
std::map<std::string, Points> points_by_variant(const Summary& summary, const std::string& scene) {
    std::map<std::string, Points> variants;
    for (const SpeedErrorPoint& point : summary.speed_error) {
        if (point.scene == scene && point.error && *point.error > 0 && point.core_s > 0)
            variants[point.variant].push_back(&point);
    }
    for (auto& entry : variants) {
        std::sort(entry.second.begin(), entry.second.end(),
                  [](const auto* a, const auto* b) { return a->dx > b->dx; });
    }
    return variants;
}

PlotSeries variant_series(const Points& points, const std::string& label, const std::string& colour) {
    PlotSeries series = line(label, {}, colour);
    series.style = Style::line_and_points;
    for (const SpeedErrorPoint* point : points) {
        series.data.x.push_back(point->core_s);
        series.data.y.push_back(*point->error);
        series.point_labels.push_back(spacing_text(point->dx));
    }
    return series;
}

/// Rings around the Pareto-optimal points.
PlotSeries pareto_series(const std::map<std::string, Points>& variants) {
    PlotSeries rings = line("Pareto-optimal", {}, "#111111");
    rings.style = Style::points;
    rings.filled = false;
    rings.point_size = 13;
    for (const auto& entry : variants) {
        for (const SpeedErrorPoint* point : entry.second) {
            if (!point->pareto) continue;
            rings.data.x.push_back(point->core_s);
            rings.data.y.push_back(*point->error);
        }
    }
    return rings;
}

}  // namespace

Figure speed_error_figure(const Summary& summary, const AnalysisSpec& scene) {
    const std::map<std::string, Points> by_variant = points_by_variant(summary, scene.scene);
    std::set<std::string> targets;
    bool relative = false;
    for (const auto& entry : by_variant) {
        for (const SpeedErrorPoint* point : entry.second) {
            targets.insert(point->against);
            relative = relative || point->relative;
        }
    }
    Figure figure;
    figure.name = scene.scene + "-speed-error";
    figure.title = scene.scene + ": speed against error";
    const std::string words = quantity_words(scene, scene.error_quantity);
    figure.identifier = scene.error_quantity;
    figure.caption =
        fmt::format("Error of the {}{}.", words, targets.size() == 1 ? " against " + *targets.begin() : "");
    figure.x = {"cost", "core-seconds", true, {}};
    figure.y = {(relative ? "relative error: " : "error: ") + words,
                relative ? "-" : unit_of_quantity(scene, scene.error_quantity),
                true,
                {}};
    const std::vector<std::string> variants = variants_of(runs_of(summary, scene));
    for (const auto& [variant, points] : by_variant) {
        const auto place = std::find(variants.begin(), variants.end(), variant) - variants.begin();
        const std::string target = targets.size() > 1 ? ", against " + points.front()->against : "";
        figure.series.push_back(
            variant_series(points, variant + target, variant_colour(static_cast<std::size_t>(place))));
    }
    if (PlotSeries rings = pareto_series(by_variant); !rings.data.x.empty())
        figure.series.push_back(std::move(rings));
    if (!figure.series.empty()) add_peers(figure, summary, scene.scene);
    return figure;
}

}  // namespace wetdeck::report
