// SPDX-License-Identifier: BSD-3-Clause
// Bodies and probes: what moves in the water, and what is recorded of it.
#include <fmt/format.h>

#include <set>

#include "solver/core/errors.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

Vec2 point(const TomlTable& table, const std::string& key) {
    const std::vector<double> values = table.numbers(key, 2);
    return {values[0], values[1]};
}

Vec2 point_or(const TomlTable& table, const std::string& key, Vec2 fallback) {
    return table.has(key) ? point(table, key) : fallback;
}

void read_freedom(const TomlTable& table, RigidBody& body) {
    static const std::vector<std::string> names = {"x", "y", "rotation"};
    body.free = {false, false, false};
    for (const std::string& name : table.texts("free")) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) table.fail("free", fmt::format("'{}' is none of x, y, rotation", name));
        body.free[static_cast<std::size_t>(found - names.begin())] = true;
    }
}

/// In the frame of the file. Of a mirrored body one half is given, from the keel to the deck.
Outline read_corners(const TomlTable& table) {
    Outline corners;
    for (const std::vector<double>& corner : table.number_rows("outline", 2))
        corners.emplace_back(corner[0], corner[1]);
    if (!table.boolean_or("mirrored", false)) return corners;
    for (std::size_t k = corners.size(); k-- > 0;) {
        if (corners[k].x() < 0) table.fail("outline", "of a mirrored body has a corner at x < 0");
        if (corners[k].x() > 0) corners.emplace_back(-corners[k].x(), corners[k].y());
    }
    return corners;
}

BodySpec read_body(const TomlTable& table, const std::string& name, const Scene& scene) {
    BodySpec spec;
    spec.name = name;
    spec.origin = point(table, "position");
    spec.outline = read_corners(table);
    for (Vec2& corner : spec.outline) corner += spec.origin;
    try {
        check_outline(spec.outline);
    } catch (const InputError& error) {
        table.fail("outline", error.what());
    }
    if (!inside(spec.outline, scene.tank)) table.fail("outline", "reaches outside the tank");
    for (const BodySpec& other : scene.bodies) {
        if (overlap(spec.outline, other.outline)) table.fail("outline", "overlaps that of " + other.name);
    }
    RigidBody& body = spec.body;
    read_freedom(table, body);
    const AreaMoments moments = area_moments(spec.outline);
    const Vec2 centroid = moments.centroid - spec.origin;
    body.position = spec.origin + point_or(table, "mass_centre", centroid);
    body.mass = body.free[0] || body.free[1] ? table.positive("mass") : table.number_or("mass", 0);
    // even density over the outline unless the file knows better; Steiner's share for a mass centre beside it
    const Vec2 beside = body.position - moments.centroid;
    const double even = body.mass * (moments.second_moment / moments.area + beside.squaredNorm());
    body.inertia = table.number_or("inertia", even);
    if (body.free[2] && !(body.inertia > 0)) table.fail("inertia", "expected a positive number [kg m]");
    body.velocity = {table.number_or("velocity_x", 0), table.number_or("velocity_y", 0)};
    body.angular_velocity = table.number_or("angular_velocity", 0);
    body.applied_force = point_or(table, "applied_force", Vec2::Zero());
    body.applied_torque = table.number_or("applied_torque", 0);
    table.finish();
    return spec;
}

using Type = ProbeSpec::Type;
const std::vector<std::pair<std::string, Type>> probe_types = {{"front", Type::front},
                                                               {"wall_pressure", Type::wall_pressure},
                                                               {"water_depth", Type::water_depth},
                                                               {"body_pressure", Type::body_pressure},
                                                               {"face_pressure", Type::face_pressure},
                                                               {"air_film", Type::air_film},
                                                               {"free_surface", Type::free_surface}};

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

/// The ends of a face must lie on the outline: a probe inside the body would read nothing.
void read_face(const TomlTable& table, const Scene& scene, ProbeSpec& probe) {
    probe.from = point(table, "from");
    probe.to = point(table, "to");
    if ((probe.to - probe.from).norm() == 0) table.fail("to", "is the same point as 'from'");
    const BodySpec& body = scene.bodies[probe.body];
    for (const char* key : {"from", "to"}) {
        const double off = std::abs(distance_to(body.outline, body.origin + point(table, key)));
        if (off > 1e-6) table.fail(key, fmt::format("lies {:.3g} m off the outline of {}", off, body.name));
    }
}

ProbeSpec read_probe(const TomlTable& table, const Scene& scene) {
    ProbeSpec probe;
    probe.name = table.text("name");
    std::vector<std::string> names;
    for (const auto& [name, type] : probe_types) names.push_back(name);
    const std::string chosen = table.choice("type", names);
    for (const auto& [name, type] : probe_types) {
        if (name == chosen) probe.type = type;
    }
    const auto on_body = [&] { probe.body = body_number(table, scene); };
    switch (probe.type) {
        case Type::front:
            break;
        case Type::wall_pressure:
            probe.centre = point(table, "centre");
            probe.diameter = table.positive("diameter");
            break;
        case Type::water_depth:
            probe.x = table.number("x");
            probe.width = table.positive("width");
            break;
        case Type::body_pressure: {
            on_body();
            probe.centre = point(table, "centre");
            probe.diameter = table.positive("diameter");
            const BodySpec& body = scene.bodies[probe.body];
            const double off = std::abs(distance_to(body.outline, body.origin + probe.centre));
            if (off > 1e-6) table.fail("centre", fmt::format("lies {:.3g} m off the outline", off));
            break;
        }
        case Type::face_pressure:
            on_body();
            read_face(table, scene, probe);
            probe.points = point_count(table);
            break;
        case Type::air_film:
            on_body();
            read_face(table, scene, probe);
            break;
        case Type::free_surface:
            probe.low = table.number("low");
            probe.high = table.number("high");
            if (!(probe.low < probe.high)) table.fail("low", "expected low below high");
            probe.points = point_count(table);
            break;
    }
    probe.note = table.text_or("note", "");
    table.finish();
    return probe;
}

}  // namespace

void read_bodies(const TomlTable& root, Scene& scene) {
    for (int number = 1;; ++number) {
        const std::string name = number == 1 ? "body" : fmt::format("body_{}", number);
        const std::optional<TomlTable> table = root.optional_table(name);
        if (!table) break;
        scene.bodies.push_back(read_body(*table, name, scene));
    }
}

void read_probes(const TomlTable& root, Scene& scene) {
    std::set<std::string> names;
    for (const TomlTable& table : root.tables("probes")) {
        scene.probes.push_back(read_probe(table, scene));
        if (!names.insert(scene.probes.back().name).second) table.fail("name", "is used twice");
    }
}

}  // namespace wetdeck
