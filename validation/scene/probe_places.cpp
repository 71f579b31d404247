// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/probe_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace wetdeck {
namespace {

/// Of the tank in the key `body` of a probe that may lie on either.
constexpr const char* tank_name = "tank";

std::vector<std::string> body_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const BodySpec& body : scene.bodies) names.push_back(body.name);
    return names;
}

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

}  // namespace

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

bool on_tank(const TomlTable& table, const Scene& scene) {
    if (!table.has("body")) return scene.bodies.empty();
    std::vector<std::string> names = body_names(scene);
    names.emplace_back(tank_name);
    return table.choice("body", names) == tank_name;
}

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

}  // namespace wetdeck
