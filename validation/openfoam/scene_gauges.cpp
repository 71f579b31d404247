// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/scene_gauges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "validation/openfoam/cell_finder.hpp"
#include "validation/scene/faces.hpp"

namespace wetdeck {
namespace {

constexpr int points_of_disc = 5;
constexpr std::size_t rays_of_film = 9, most_rays = 50;  // of a face, of a surface
constexpr double surface_rows = 100;                     // of a surface over the run
constexpr double below_level = 0.25;  // depth of the rays of a surface, over that of the water

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

/// A point, or its mirror image on the computed half.
Vec2 on_half(Vec2 point, std::optional<double> axis) {
    if (axis) point.x() = *axis + std::abs(point.x() - *axis);
    return point;
}

FoamGauge gauge_of(const Probe& probe, FoamGauge::Kind kind) {
    FoamGauge gauge;
    gauge.kind = kind;
    gauge.series = probe.series.name;
    gauge.unit = probe.series.unit;
    gauge.description = probe.series.description;
    gauge.object = "gauge_" + probe.series.name;
    return gauge;
}

void pressure_gauge(const Probe& probe, std::optional<double> axis, SceneCase& written) {
    FoamGauge gauge = gauge_of(probe, FoamGauge::Kind::pressure);
    FoamProbes probes{gauge.object, "p", {}};
    for (int k = 0; k < points_of_disc; ++k) {
        const double s = -0.8 + 1.6 * k / (points_of_disc - 1);  // over the radius
        const Vec2 point =
            on_half(probe.place->begin + 0.5 * (1 + s) * (probe.place->end - probe.place->begin), axis);
        probes.points.push_back(written.foam.mesh.centre(nearest_cell(written.foam.mesh, point)));
        gauge.weights.push_back(std::sqrt(1 - s * s));
    }
    double sum = 0;
    for (const double weight : gauge.weights) sum += weight;
    for (double& weight : gauge.weights) weight /= sum;
    written.foam.probes.push_back(std::move(probes));
    written.gauges.push_back(std::move(gauge));
}

void face_gauge(const Probe& probe, std::optional<double> axis, SceneCase& written) {
    FoamGauge gauge = gauge_of(probe, FoamGauge::Kind::profile);
    FoamProbes probes{gauge.object, "p", {}};
    gauge.abscissa = probe.series.abscissa;
    const Vec2 begin = probe.place->begin, along = (probe.place->end - begin).normalized();
    for (const double s : gauge.abscissa)
        probes.points.push_back(
            written.foam.mesh.centre(nearest_cell(written.foam.mesh, on_half(begin + s * along, axis))));
    gauge.weights.assign(probes.points.size(), 1);
    written.foam.probes.push_back(std::move(probes));
    written.gauges.push_back(std::move(gauge));
}

/// Adds the cells along a ray to a gauge. False where the ray meets no cell.
bool add_ray(const PlaneMesh& mesh, const std::vector<CellFinder::Passed>& ray, FoamGauge& gauge,
             FoamProbes& probes) {
    if (ray.empty()) return false;
    for (const CellFinder::Passed& passed : ray) {
        probes.points.push_back(mesh.centre(passed.cell));
        gauge.places.push_back(gauge.kind == FoamGauge::Kind::surface ? probes.points.back().y()
                                                                      : passed.distance);
    }
    gauge.rays.push_back(ray.size());
    return true;
}

/// False where no water can come in front of the face.
bool film_gauge(const Probe& probe, const Scene& scene, std::optional<double> axis, const CellFinder& finder,
                SceneCase& written) {
    FoamGauge gauge = gauge_of(probe, FoamGauge::Kind::film);
    FoamProbes probes{gauge.object, "alpha.water", {}};
    const Vec2 begin = probe.place->begin, end = probe.place->end;
    const double level = scene.water_boxes.front().high.y(), thin = 0.05 * written.cell;
    const Vec2 normal = nearest_face(scene.bodies.front().outline, 0.5 * (begin + end)).normal;
    if (normal.y() > -0.1) return false;
    std::set<Vec2, bool (*)(const Vec2&, const Vec2&)> beginnings(
        [](const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
    for (std::size_t k = 0; k < rays_of_film; ++k) {
        const Vec2 point =
            begin + (static_cast<double>(k) + 0.5) / static_cast<double>(rays_of_film) * (end - begin);
        const Vec2 seen = on_half(point, axis);
        if (!beginnings.insert(seen).second) continue;
        const Vec2 outwards = seen == point ? normal : Vec2(-normal.x(), normal.y());
        const double length = (point.y() - level) / -normal.y() + 4 * written.cell;
        add_ray(written.foam.mesh, finder.along(seen, outwards, length, thin), gauge, probes);
    }
    if (gauge.rays.empty()) return false;
    written.foam.probes.push_back(std::move(probes));
    written.gauges.push_back(std::move(gauge));
    return true;
}

/// False where a ray meets no cell.
bool surface_gauge(const Probe& probe, const Scene& scene, std::optional<double> axis,
                   const CellFinder& finder, SceneCase& written) {
    FoamGauge gauge = gauge_of(probe, FoamGauge::Kind::surface);
    FoamProbes probes{gauge.object, "alpha.water", {}};
    double level = scene.tank.low.y();
    for (const Box& box : scene.water_boxes) level = std::max(level, box.high.y());
    const bool at_rest = written.foam.stream.isZero();
    const double low = at_rest ? scene.tank.low.y() : level - below_level * (level - scene.tank.low.y());
    const std::vector<double>& all = probe.series.abscissa;
    const std::size_t stride = (all.size() + most_rays - 1) / most_rays;
    for (std::size_t k = stride / 2; k < all.size(); k += stride) {
        const Vec2 top = on_half({all[k], scene.tank.high.y()}, axis);
        const auto ray = finder.along(top, {0, -1}, top.y() - low, 0.25 * written.cell);
        if (!add_ray(written.foam.mesh, ray, gauge, probes)) return false;
        gauge.abscissa.push_back(all[k]);
    }
    gauge.rise = written.foam.stream.y();
    probes.interval = std::max(scene.sample_interval, written.foam.end_time / surface_rows);
    written.foam.probes.push_back(std::move(probes));
    written.gauges.push_back(std::move(gauge));
    return true;
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

void line_gauge(const Probe& probe, FoamGauge::Kind kind, Vec2 point, SceneCase& written) {
    const bool front = kind == FoamGauge::Kind::front;
    FoamGauge gauge = gauge_of(probe, kind);
    FoamProbes probes{gauge.object, "alpha.water", {}};
    for (const std::size_t c : line_of_cells(written.foam.mesh, point, front ? 1 : 0)) {
        const auto corners = written.foam.mesh.corners(c);
        probes.points.push_back(written.foam.mesh.centre(c));
        gauge.places.push_back(probes.points.back().x());
        gauge.weights.push_back(corners[2].y() - corners[0].y());
    }
    written.foam.probes.push_back(std::move(probes));
    written.gauges.push_back(std::move(gauge));
}

/// The name of a probe's type; empty for gauges over a disc and depths, which describe themselves.
std::string type_of(const Probe& probe) {
    for (const ProbeType& type : probe_types())
        if (probe.series.description == type.records) return type.name;
    return {};
}

/// Whether a probe lies on a face that is at rest in the case.
bool at_rest(const Probe& probe, const Scene& scene) {
    if (!probe.place) return false;
    if (scene.bodies.empty()) return true;
    const Outline& outline = scene.bodies.front().outline;
    return nearest_face(outline, 0.5 * (probe.place->begin + probe.place->end)).distance < 1e-3;
}

/// Adds the gauge of a probe; why there is none, or nothing.
std::string add_gauge(const Probe& probe, const Scene& scene, std::optional<double> axis,
                      const CellFinder& finder, SceneCase& written) {
    const std::string type = type_of(probe);
    const bool tank = written.shape == "tank", scalar = probe.series.abscissa.empty();
    if (type == "free_surface")
        return surface_gauge(probe, scene, axis, finder, written) ? "" : "a part of it lies outside the mesh";
    if (tank && scalar && probe.series.name == "front") {
        line_gauge(probe, FoamGauge::Kind::front, scene.tank.low, written);
        return "";
    }
    if (tank && scalar && probe.place && probe.place->through_fluid && probe.series.unit == "m") {
        line_gauge(probe, FoamGauge::Kind::depth, probe.place->begin, written);
        return "";
    }
    if (type == "patch_pressure") return "OpenFOAM has no mean over a patch that goes where it is largest";
    if (!at_rest(probe, scene))
        return tank ? "not among what cases have"
                    : "it is fixed to the tank, which moves past the body at rest";
    if (type == "air_film")
        return film_gauge(probe, scene, axis, finder, written) ? "" : "no water comes in front of its face";
    if (type == "face_pressure") {
        face_gauge(probe, axis, written);
        return "";
    }
    if (probe.series.unit != "Pa" || !scalar) return "not among what cases have";
    pressure_gauge(probe, axis, written);
    return "";
}

struct GaugeNote {
    FoamGauge::Kind kind;
    const char* text;
};

constexpr GaugeNote gauge_notes[] = {
    {FoamGauge::Kind::pressure,
     "Pressure gauges: mean over five points of the disc, each the value of the cell nearest to it, half a "
     "cell off the wall."},
    {FoamGauge::Kind::profile,
     "Pressures along a face: of the cells nearest to its points, half a cell off the wall."},
    {FoamGauge::Kind::film,
     "Gap under a face: the least one along nine rays square to it, to where the share of water rises to a "
     "half, linearly between cells; wetdeck takes the nearest of all water particles."},
    {FoamGauge::Kind::surface,
     "Free surface: where the share of water first rises to a half from above, at up to fifty places and a "
     "hundred times; spray thinner than a cell does not count."},
    {FoamGauge::Kind::front,
     "Front: where the share of water in the lowest row of cells falls through a half; wetdeck takes its "
     "foremost water particle."},
    {FoamGauge::Kind::depth, "Depth of water: of one column of cells, not of the width of the gauge."},
};

}  // namespace

void add_gauges(const Scene& scene, std::optional<double> axis, SceneCase& written) {
    const CellFinder finder(written.foam.mesh);
    std::vector<std::string> left_out;
    for (const Probe& probe : scene.probes)
        if (const std::string why = add_gauge(probe, scene, axis, finder, written); !why.empty())
            left_out.push_back(fmt::format("{} ({})", probe.series.name, why));
    for (const GaugeNote& note : gauge_notes)
        if (std::any_of(written.gauges.begin(), written.gauges.end(),
                        [&](const FoamGauge& g) { return g.kind == note.kind; }))
            written.differences.emplace_back(note.text);
    if (!left_out.empty())
        written.differences.push_back(fmt::format("Not written: the probes {}.", fmt::join(left_out, ", ")));
}

}  // namespace wetdeck
