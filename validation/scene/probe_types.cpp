// SPDX-License-Identifier: BSD-3-Clause
// The types of probes: the keys that each reads from its table of the scene file, and its sampling.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "validation/scene/front_probe.hpp"
#include "validation/scene/probe.hpp"
#include "validation/scene/probe_places.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

template <class F>
auto profile(F f) {
    return [f](const Simulation& s, std::vector<double>& out) {
        const std::vector<double> values = f(s);
        out.insert(out.end(), values.begin(), values.end());
    };
}

Probe pressure_gauge(const TomlTable& table, const Disc& disc, const PressureGauge& gauge, ProbePlace place) {
    Probe probe;
    probe.series.description =
        fmt::format("gauge pressure, chord-weighted mean over a disc of {} m at ({}, {}) m; {}",
                    disc.diameter, disc.centre.x(), disc.centre.y(), table.text_or("note", ""));
    probe.place = place;
    probe.notes = disc.notes;
    probe.check = [gauge](double particle_spacing) { gauge.check(particle_spacing); };
    probe.sample = scalar_reading([gauge](const Simulation& s) { return gauge.sample(s); });
    return probe;
}

Probe wall_pressure(const TomlTable& table, const Scene& scene) {
    const FacePlace wall = nearest_wall(scene.tank, point(table, "centre"));
    const Vec2 low = scene.tank.low, high = scene.tank.high;
    const Disc disc =
        read_disc(table, scene, wall, Vec2::Zero(),
                  fmt::format("expected x = {:.6g} or {:.6g}, or y = {:.6g} or {:.6g} in the tank", low.x(),
                              high.x(), low.y(), high.y()));
    const Vec2 half = 0.5 * disc.diameter * wall.along;
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        if (const auto body = covered_for_good(scene, disc.centre + share * half))
            table.fail("centre",
                       fmt::format("lies where {}, which never moves, covers {}", *body, wall.name));
    }
    return pressure_gauge(table, disc, {disc.centre, wall.normal, disc.diameter},
                          {disc.centre - half, disc.centre + half});
}

Probe water_depth_at(const TomlTable& table, const Scene& scene) {
    const double x = table.number("x"), width = table.positive("width");
    if (x < scene.tank.low.x() || x > scene.tank.high.x())
        table.fail("x", fmt::format("{:.6g} m is outside the tank, expected {:.6g} to {:.6g} m", x,
                                    scene.tank.low.x(), scene.tank.high.x()));
    Probe probe;
    probe.series.description = fmt::format("depth of water at x = {} m over a width of {} m", x, width);
    probe.place = {{x, scene.tank.low.y()}, {x, scene.tank.high.y()}, true};
    probe.sample = scalar_reading([x, width](const Simulation& s) { return water_depth(s, x, width); });
    return probe;
}

Probe body_pressure(const TomlTable& table, const Scene& scene) {
    const std::size_t number = body_number(table, scene);
    const BodySpec& body = scene.bodies[number];
    const FacePlace face = nearest_face(body.drawn, body.origin + point(table, "centre"));
    const Disc disc = read_disc(table, scene, face, body.origin,
                                fmt::format("expected a point on the outline of {}", body.name));
    return pressure_gauge(table, disc, {body.in_body_frame(disc.centre), face.normal, disc.diameter, number},
                          {body.at_start(disc.centre), body.at_start(disc.centre)});
}

Probe tank_face_pressure(const TomlTable& table, const Scene& scene) {
    check_wall_line(table, scene);
    const Vec2 from = point(table, "from"), to = point(table, "to");
    const std::size_t count = point_count(table);
    std::vector<FacePoint> points;  // each in the middle of its share
    for (const double share : midpoints(0, 1, count)) {
        const Vec2 place = from + share * (to - from);
        points.push_back({place, nearest_wall(scene.tank, place).normal});
    }
    Probe probe;
    probe.series.abscissa = midpoints(0, (to - from).norm(), count);
    probe.place = {from, to};
    probe.sample = profile([points](const Simulation& s) { return face_pressures(s, points); });
    return probe;
}

Probe face_pressure(const TomlTable& table, const Scene& scene) {
    if (on_tank(table, scene)) return tank_face_pressure(table, scene);
    const Face face = read_face(table, scene);
    const BodySpec& body = scene.bodies[face.body];
    const std::size_t count = point_count(table);
    std::vector<FacePoint> points;  // each in the middle of its share, in the frame of the mass centre
    for (const double share : midpoints(0, 1, count)) {
        const Vec2 place = face.from + share * (face.to - face.from);
        points.push_back({body.in_body_frame(place), nearest_face(body.drawn, body.origin + place).normal});
    }
    Probe probe;
    probe.series.abscissa = midpoints(0, (face.to - face.from).norm(), count);
    probe.place = face.place;
    probe.notes = face.notes;
    probe.sample = profile([points, number = face.body](const Simulation& s) {
        std::vector<FacePoint> now;
        for (const FacePoint& point : points) now.push_back(placed(point, s.bodies()[number]));
        return face_pressures(s, now);
    });
    return probe;
}

/// The largest mean over a patch of the face, wherever it lies.
Probe patch_pressure(const TomlTable& table, const Scene& scene) {
    const double length = table.positive("length");
    Probe face = face_pressure(table, scene);
    const double step = face.series.abscissa[1] - face.series.abscissa[0];
    const double whole = step * static_cast<double>(face.series.abscissa.size());
    if (length < step * (1 - 1e-9) || length > whole * (1 + 1e-9))
        table.fail("length", fmt::format("is {:.6g} m, expected {:.6g} m, the share of one point, to {:.6g} "
                                         "m, the whole line",
                                         length, step, whole));
    face.series.abscissa.clear();
    face.sample = scalar_reading([points = face.sample, shares = length / step](const Simulation& s) {
        std::vector<double> pressures;
        points(s, pressures);
        return largest_mean(pressures, shares);
    });
    return face;
}

/// Whether a ray from a point meets a box.
bool ray_meets(Vec2 from, Vec2 direction, const Box& box) {
    double enters = 0, leaves = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
        const double a = (box.low[axis] - from[axis]) / direction[axis];
        const double b = (box.high[axis] - from[axis]) / direction[axis];
        enters = std::max(enters, std::fmin(a, b));
        leaves = std::min(leaves, std::fmax(a, b));
    }
    return enters < leaves;
}

/// Whether water lies in front of a face at the start.
bool sees_water(const Face& face, Vec2 outwards, const Scene& scene) {
    for (const double share : midpoints(0, 1, 64)) {
        const Vec2 point = face.place.begin + share * (face.place.end - face.place.begin);
        for (const Box& box : scene.water_boxes)
            if (ray_meets(point, outwards, box)) return true;
    }
    return false;
}

/// In front of the face is the fluid, whichever end the file names first.
Probe air_film(const TomlTable& table, const Scene& scene) {
    const Face face = read_face(table, scene);
    const BodySpec& body = scene.bodies[face.body];
    Vec2 from = body.in_body_frame(face.from), to = body.in_body_frame(face.to);
    const Vec2 middle = body.origin + 0.5 * (face.from + face.to);
    const Vec2 normal = nearest_face(body.drawn, middle).normal;
    if (normal.dot(Vec2(to.y() - from.y(), from.x() - to.x())) < 0) std::swap(from, to);
    Probe probe;
    probe.place = face.place;
    probe.notes = face.notes;
    if (!sees_water(face, body.body.axes() * normal, scene))
        probe.doubts.push_back(
            fmt::format("{}: no water is in front of the face at the start: air_film reads "
                        "the tank's diagonal while that is so",
                        table.place_of("from")));
    probe.sample = scalar_reading(
        [=, number = face.body](const Simulation& s) { return gap_to_water(s, number, from, to); });
    return probe;
}

Probe free_surface(const TomlTable& table, const Scene& scene) {
    const double low = table.number("low"), high = table.number("high");
    if (!(low < high)) table.fail("low", "expected low below high");
    for (const char* key : {"low", "high"}) {
        const double x = table.number(key);
        if (x < scene.tank.low.x() || x > scene.tank.high.x())
            table.fail(key, fmt::format("{:.6g} m is outside the tank, expected {:.6g} to {:.6g} m", x,
                                        scene.tank.low.x(), scene.tank.high.x()));
    }
    const std::size_t count = point_count(table);
    Probe probe;
    probe.series.abscissa = midpoints(low, high, count);
    probe.sample = profile([=](const Simulation& s) { return water_top(s, low, high, count); });
    return probe;
}

}  // namespace

std::span<const ProbeType> probe_types() {
    static const std::vector<ProbeType> table{
        {"front",
         "m",
         "coordinate of the farthest water: largest x, or as `direction` (right, left, up, down) says",
         {},
         read_front,
         {"direction", "x_range", "y_range"}},
        {"wall_pressure",
         "Pa",
         "gauge pressure on the floor, a side or the roof of the tank, chord-weighted mean over a disc",
         {"centre", "diameter"},
         wall_pressure},
        {"water_depth",
         "m",
         "depth of water at x over the part of a width that lies in the tank",
         {"x", "width"},
         water_depth_at},
        {"body_pressure",
         "Pa",
         "gauge pressure on a face of a body, chord-weighted mean over a disc",
         {"centre", "diameter"},
         body_pressure,
         {"body"}},
        {"face_pressure",
         "Pa",
         "gauge pressure along a face of a body, or of the tank, by arc length from its first end [m]",
         {"from", "to", "points"},
         face_pressure,
         {"body"}},
        {"patch_pressure",
         "Pa",
         "largest mean of the gauge pressure over a patch of that length [m], wherever it lies on the line",
         {"from", "to", "points", "length"},
         patch_pressure,
         {"body"}},
        {"air_film",
         "m",
         "gap between the face and the nearest water in front of it",
         {"from", "to"},
         air_film,
         {"body"}},
        {"free_surface",
         "m",
         "height of the highest water, by x [m]; spray counts",
         {"low", "high", "points"},
         free_surface},
    };
    return table;
}

}  // namespace wetdeck
