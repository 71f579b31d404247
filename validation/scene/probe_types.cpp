// SPDX-License-Identifier: BSD-3-Clause
// The types of probes: the keys that each reads from its table of the scene file, and its sampling.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "validation/scene/faces.hpp"
#include "validation/scene/front_probe.hpp"
#include "validation/scene/probe.hpp"
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

/// Of the tank in the key `body` of a probe that may lie on either.
constexpr const char* tank_name = "tank";

std::vector<std::string> body_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const BodySpec& body : scene.bodies) names.push_back(body.name);
    return names;
}

/// Number of the body that the probe sits on: the first one if the file does not say.
std::size_t body_number(const TomlTable& table, const Scene& scene) {
    const std::vector<std::string> names = body_names(scene);
    if (names.empty()) table.fail("type", "needs a body, the scene has no [body]");
    const std::string name = table.choice("body", names, names.front());
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::size_t point_count(const TomlTable& table) {
    const double points = table.number("points");
    if (!(points >= 2 && points <= 10'000)) table.fail("points", "expected 2 to 10000");
    return static_cast<std::size_t>(points);
}

std::vector<double> midpoints(double low, double high, std::size_t count) {
    std::vector<double> middle;
    for (std::size_t k = 0; k < count; ++k)
        middle.push_back(low + (high - low) * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
    return middle;
}

/// A straight face of a body; all of it lies on the outline, as a probe inside the body would read nothing.
struct Face {
    std::size_t body;
    Vec2 from, to;  ///< in the frame of the outline [m]
    ProbePlace place;
    std::vector<std::string> notes;
};

/// The point of the key where it lies on the face; one within the snapping distance is moved onto it, with a
/// note. `origin` is that of the frame of the key in the frame of the face.
Vec2 on_face(const TomlTable& table, const std::string& key, const FacePlace& face, Vec2 origin,
             const Scene& scene, std::vector<std::string>& notes) {
    const Vec2 given = point(table, key);
    if (face.distance <= face_tolerance || face.distance > snapping_distance(scene)) return given;
    const Vec2 moved = face.foot - origin;
    notes.push_back(fmt::format(
        "{}: ({:.6g}, {:.6g}) m lies {:.3g} m off {}, less than the finest spacing: "
        "taken for ({:.6g}, {:.6g}) m on it",
        table.place_of(key), given.x(), given.y(), face.distance, face.name, moved.x(), moved.y()));
    return moved;
}

Face read_face(const TomlTable& table, const Scene& scene) {
    const std::size_t number = body_number(table, scene);
    const BodySpec& body = scene.bodies[number];
    std::vector<std::string> notes;
    const auto end = [&](const char* key) {
        const FacePlace nearest = nearest_face(body.drawn, body.origin + point(table, key));
        return on_face(table, key, nearest, body.origin, scene, notes);
    };
    const Vec2 from = end("from"), to = end("to");
    if ((to - from).norm() == 0) table.fail("to", "is the same point as 'from'");
    const auto off = [&](Vec2 place) { return std::abs(distance_to(body.drawn, body.origin + place)); };
    for (const auto& [key, place] : {std::pair("from", from), std::pair("to", to)}) {
        if (off(place) > face_tolerance)
            table.fail(key, fmt::format("lies {:.3g} m off the outline of {}", off(place), body.name));
    }
    double farthest = 0;
    for (const double share : midpoints(0, 1, 64))
        farthest = std::max(farthest, off(from + share * (to - from)));
    if (farthest > face_tolerance)
        table.fail("to", fmt::format("the line from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) leaves the outline "
                                     "of {} by {:.3g} m: expected two points of one straight face",
                                     from.x(), from.y(), to.x(), to.y(), body.name, farthest));
    return {number, from, to, {body.at_start(from), body.at_start(to)}, notes};
}

/// A disc on a face, over which a gauge takes its mean.
struct Disc {
    Vec2 centre;  ///< in the frame of the key [m]
    double diameter;
    std::vector<std::string> notes;
};

/// Refuses a centre that lies on no face, and a disc that reaches beyond its end.
/// @param origin  of the frame of the key in the frame of the face
Disc read_disc(const TomlTable& table, const Scene& scene, const FacePlace& face, Vec2 origin,
               const std::string& expected) {
    Disc disc{Vec2::Zero(), table.positive("diameter"), {}};
    disc.centre = on_face(table, "centre", face, origin, scene, disc.notes);
    const Vec2 centre = disc.centre;
    if (face.distance > face_tolerance && disc.notes.empty())
        table.fail("centre", fmt::format("({:.6g}, {:.6g}) m lies {:.3g} m off {}, the nearest face: {}",
                                         centre.x(), centre.y(), face.distance, face.name, expected));
    const double beyond = 0.5 * disc.diameter - face.to_end();
    if (beyond > face_tolerance)
        table.fail(
            "diameter",
            fmt::format("the disc of {:.6g} m at ({:.6g}, {:.6g}) m reaches {:.3g} m beyond the end of "
                        "{}: expected at most {:.6g} m there, or another centre",
                        disc.diameter, centre.x(), centre.y(), beyond, face.name, 2 * face.to_end()));
    return disc;
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

/// Whether a face of the tank is meant: where the file says so, or there is no body.
bool on_tank(const TomlTable& table, const Scene& scene) {
    if (!table.has("body")) return scene.bodies.empty();
    std::vector<std::string> names = body_names(scene);
    names.emplace_back(tank_name);
    return table.choice("body", names) == tank_name;
}

/// Refuses a line that leaves one side of the tank.
void check_wall_line(const TomlTable& table, const Scene& scene) {
    const Vec2 from = point(table, "from"), to = point(table, "to");
    if ((to - from).norm() == 0) table.fail("to", "is the same point as 'from'");
    const FacePlace wall = nearest_wall(scene.tank, 0.5 * (from + to));
    for (const char* key : {"from", "to"}) {
        const Vec2 off = point(table, key) - 0.5 * (from + to);
        const double away = (off - off.dot(wall.along) * wall.along).norm();
        const double beyond =
            std::abs(off.dot(wall.along)) - (off.dot(wall.along) > 0 ? wall.after : wall.before);
        if (std::max({wall.distance, away, beyond}) > face_tolerance)
            table.fail(key,
                       fmt::format("the line from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) is not part of {}: "
                                   "expected two points of one side of the tank",
                                   from.x(), from.y(), to.x(), to.y(), wall.name));
    }
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
