// SPDX-License-Identifier: BSD-3-Clause
// The types of probes: the keys that each reads from its table of the scene file, and its sampling.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "validation/scene/probe.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

template <class F>
auto scalar(F f) {
    return [f](const Simulation& s, std::vector<double>& out) { out.push_back(f(s)); };
}

template <class F>
auto profile(F f) {
    return [f](const Simulation& s, std::vector<double>& out) {
        const std::vector<double> values = f(s);
        out.insert(out.end(), values.begin(), values.end());
    };
}

/// Number of the body that the probe sits on: the first one if the file does not say.
std::size_t body_number(const TomlTable& table, const Scene& scene) {
    std::vector<std::string> names;
    for (const BodySpec& body : scene.bodies) names.push_back(body.name);
    if (names.empty()) table.fail("type", "needs a body, the scene has no [body]");
    const std::string name = table.choice("body", names, names.front());
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::size_t point_count(const TomlTable& table) {
    const double points = table.number("points");
    if (!(points >= 2 && points <= 10'000)) table.fail("points", "expected 2 to 10000");
    return static_cast<std::size_t>(points);
}

/// Distance of a point of the body's frame to its outline, where it is more than a rounding error.
std::optional<double> off_outline(const BodySpec& body, Vec2 place) {
    const double distance = std::abs(distance_to(body.outline, body.origin + place));
    return distance > 1e-6 ? std::optional(distance) : std::nullopt;
}

/// Direction of the side of an outline nearest to a point.
Vec2 side_direction(const Outline& outline, Vec2 point) {
    Vec2 best = Vec2::UnitX();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()];
        const double share = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        const double distance = (a + share * (b - a) - point).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        best = (b - a).normalized();
    }
    return best;
}

std::vector<double> midpoints(double low, double high, std::size_t count) {
    std::vector<double> middle;
    for (std::size_t k = 0; k < count; ++k)
        middle.push_back(low + (high - low) * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
    return middle;
}

/// A straight face of a body; its ends lie on the outline, as a probe inside the body would read nothing.
struct Face {
    std::size_t body;
    Vec2 from, to;  ///< in the frame of the outline [m]
    ProbePlace place;
};

Face read_face(const TomlTable& table, const Scene& scene) {
    const std::size_t number = body_number(table, scene);
    const BodySpec& body = scene.bodies[number];
    const Vec2 from = point(table, "from"), to = point(table, "to");
    if ((to - from).norm() == 0) table.fail("to", "is the same point as 'from'");
    for (const char* key : {"from", "to"}) {
        if (const auto off = off_outline(body, point(table, key)))
            table.fail(key, fmt::format("lies {:.3g} m off the outline of {}", *off, body.name));
    }
    return {number, from, to, {body.at_start(from), body.at_start(to)}};
}

Probe pressure_gauge(const TomlTable& table, const PressureGauge& gauge, ProbePlace place) {
    const Vec2 centre = point(table, "centre");
    Probe probe;
    probe.series.description =
        fmt::format("gauge pressure, chord-weighted mean over a disc of {} m at ({}, {}) m; {}",
                    table.positive("diameter"), centre.x(), centre.y(), table.text_or("note", ""));
    probe.place = place;
    probe.check = [gauge](double particle_spacing) { gauge.check(particle_spacing); };
    probe.sample = scalar([gauge](const Simulation& s) { return gauge.sample(s); });
    return probe;
}

Probe front(const TomlTable&, const Scene&) {
    Probe probe;
    probe.sample = scalar(front_position);
    return probe;
}

Probe wall_pressure(const TomlTable& table, const Scene&) {
    const Vec2 centre = point(table, "centre");
    const double diameter = table.positive("diameter");
    const Vec2 half(0, 0.5 * diameter);
    return pressure_gauge(table, {centre, Vec2::UnitY(), diameter}, {centre - half, centre + half});
}

Probe water_depth_at(const TomlTable& table, const Scene& scene) {
    const double x = table.number("x"), width = table.positive("width");
    Probe probe;
    probe.series.description = fmt::format("depth of water at x = {} m over a width of {} m", x, width);
    probe.place = {{x, scene.tank.low.y()}, {x, scene.tank.high.y()}, true};
    probe.sample = scalar([x, width](const Simulation& s) { return water_depth(s, x, width); });
    return probe;
}

Probe body_pressure(const TomlTable& table, const Scene& scene) {
    const std::size_t number = body_number(table, scene);
    const BodySpec& body = scene.bodies[number];
    const Vec2 centre = point(table, "centre");
    const double diameter = table.positive("diameter");
    if (const auto off = off_outline(body, centre))
        table.fail("centre", fmt::format("lies {:.3g} m off the outline", *off));
    const Vec2 along = side_direction(body.outline, body.origin + centre);
    return pressure_gauge(table, {body.in_body_frame(centre), along, diameter, number},
                          {body.at_start(centre), body.at_start(centre)});
}

Probe face_pressure(const TomlTable& table, const Scene& scene) {
    const Face face = read_face(table, scene);
    const std::size_t count = point_count(table);
    std::vector<Vec2> points;  // each in the middle of its share, in the frame of the mass centre
    for (const double share : midpoints(0, 1, count))
        points.push_back(scene.bodies[face.body].in_body_frame(face.from + share * (face.to - face.from)));
    Probe probe;
    probe.series.abscissa = midpoints(0, (face.to - face.from).norm(), count);
    probe.place = face.place;
    probe.sample = profile([points, body = face.body](const Simulation& s) {
        std::vector<Vec2> placed;
        for (const Vec2& point : points) placed.push_back(s.bodies()[body].placed(point));
        return face_pressures(s, placed);
    });
    return probe;
}

Probe air_film(const TomlTable& table, const Scene& scene) {
    const Face face = read_face(table, scene);
    const BodySpec& body = scene.bodies[face.body];
    const Vec2 from = body.in_body_frame(face.from), to = body.in_body_frame(face.to);
    Probe probe;
    probe.place = face.place;
    probe.sample =
        scalar([=, number = face.body](const Simulation& s) { return gap_to_water(s, number, from, to); });
    return probe;
}

Probe free_surface(const TomlTable& table, const Scene&) {
    const double low = table.number("low"), high = table.number("high");
    if (!(low < high)) table.fail("low", "expected low below high");
    const std::size_t count = point_count(table);
    Probe probe;
    probe.series.abscissa = midpoints(low, high, count);
    probe.sample = profile([=](const Simulation& s) { return water_top(s, low, high, count); });
    return probe;
}

}  // namespace

std::span<const ProbeType> probe_types() {
    static const std::vector<ProbeType> table{
        {"front", "m", "largest x that water reaches", {}, front},
        {"wall_pressure",
         "Pa",
         "gauge pressure on a vertical wall, chord-weighted mean over a disc",
         {"centre", "diameter"},
         wall_pressure},
        {"water_depth", "m", "depth of water at x over a width", {"x", "width"}, water_depth_at},
        {"body_pressure",
         "Pa",
         "gauge pressure on a face of a body, chord-weighted mean over a disc",
         {"body", "centre", "diameter"},
         body_pressure},
        {"face_pressure",
         "Pa",
         "gauge pressure along a face, by arc length from its first end [m]",
         {"body", "from", "to", "points"},
         face_pressure},
        {"air_film",
         "m",
         "gap between the face and the nearest water in front of it",
         {"body", "from", "to"},
         air_film},
        {"free_surface",
         "m",
         "height of the highest water, by x [m]; spray counts",
         {"low", "high", "points"},
         free_surface},
    };
    return table;
}

}  // namespace wetdeck
