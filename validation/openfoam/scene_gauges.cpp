// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/scene_gauges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

constexpr int points_of_disc = 5;

/// The cell whose centre is nearest to a point.
std::size_t nearest_cell(const PlaneMesh& mesh, Vec2 point) {
    std::size_t nearest = 0;
    double least = 1e300;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        const double distance = (mesh.centre(c) - point).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest = c;
    }
    return nearest;
}

FoamGauge pressure_of(const Probe& probe, std::optional<double> axis, SceneCase& written) {
    FoamGauge gauge{FoamGauge::Kind::pressure,
                    probe.series.name,
                    "Pa",
                    probe.series.description,
                    "gauge_" + probe.series.name,
                    {},
                    {}};
    FoamProbes probes{gauge.object, "p", {}};
    for (int k = 0; k < points_of_disc; ++k) {
        const double s = -0.8 + 1.6 * k / (points_of_disc - 1);  // over the radius
        Vec2 point = probe.place->begin + 0.5 * (1 + s) * (probe.place->end - probe.place->begin);
        if (axis) point.x() = *axis + std::abs(point.x() - *axis);
        probes.points.push_back(written.foam.mesh.centre(nearest_cell(written.foam.mesh, point)));
        gauge.weights.push_back(std::sqrt(1 - s * s));
    }
    double sum = 0;
    for (const double weight : gauge.weights) sum += weight;
    for (double& weight : gauge.weights) weight /= sum;
    written.foam.probes.push_back(std::move(probes));
    return gauge;
}

/// The centres of the cells of a row or a column of an even mesh that holds a point.
std::vector<std::size_t> line_of_cells(const PlaneMesh& mesh, Vec2 point, int axis) {
    const double across = mesh.centre(nearest_cell(mesh, point))[axis];
    std::vector<std::size_t> line;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        if (std::abs(mesh.centre(c)[axis] - across) < 1e-9) line.push_back(c);
    std::sort(line.begin(), line.end(), [&](std::size_t a, std::size_t b) {
        return mesh.centre(a)[1 - axis] < mesh.centre(b)[1 - axis];
    });
    return line;
}

FoamGauge line_gauge(const Probe& probe, FoamGauge::Kind kind, Vec2 point, SceneCase& written) {
    const bool front = kind == FoamGauge::Kind::front;
    FoamGauge gauge{kind, probe.series.name, "m", probe.series.description, "gauge_" + probe.series.name, {},
                    {}};
    FoamProbes probes{gauge.object, "alpha.water", {}};
    for (const std::size_t c : line_of_cells(written.foam.mesh, point, front ? 1 : 0)) {
        const auto corners = written.foam.mesh.corners(c);
        probes.points.push_back(written.foam.mesh.centre(c));
        gauge.places.push_back(probes.points.back().x());
        gauge.weights.push_back(corners[2].y() - corners[0].y());
    }
    written.foam.probes.push_back(std::move(probes));
    return gauge;
}

}  // namespace

void add_gauges(const Scene& scene, std::optional<double> axis, SceneCase& written) {
    std::vector<std::string> left_out;
    bool front = false, depth = false;
    for (const Probe& probe : scene.probes) {
        const bool scalar = probe.series.abscissa.empty();
        if (scalar && probe.series.unit == "Pa" && probe.place) {
            written.gauges.push_back(pressure_of(probe, axis, written));
        } else if (written.shape == "tank" && scalar && probe.series.name == "front") {
            written.gauges.push_back(line_gauge(probe, FoamGauge::Kind::front, scene.tank.low, written));
            front = true;
        } else if (written.shape == "tank" && scalar && probe.place && probe.place->through_fluid &&
                   probe.series.unit == "m") {
            written.gauges.push_back(line_gauge(probe, FoamGauge::Kind::depth, probe.place->begin, written));
            depth = true;
        } else {
            left_out.push_back(probe.series.name);
        }
    }
    std::vector<std::string>& differences = written.differences;
    if (std::any_of(written.gauges.begin(), written.gauges.end(),
                    [](const FoamGauge& g) { return g.kind == FoamGauge::Kind::pressure; }))
        differences.emplace_back(
            "Pressure gauges: mean over five points of the disc, each the value of the cell nearest to it, "
            "half a cell off the wall.");
    if (front)
        differences.emplace_back(
            "Front: where the share of water in the lowest row of cells falls through a half; wetdeck takes "
            "its foremost water particle.");
    if (depth)
        differences.emplace_back("Depth of water: of one column of cells, not of the width of the gauge.");
    if (!left_out.empty())
        differences.push_back(fmt::format("Not written: the probes {}.", fmt::join(left_out, ", ")));
}

}  // namespace wetdeck
