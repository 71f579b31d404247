// SPDX-License-Identifier: BSD-3-Clause
// Bodies: outlines, masses and motions at the start.
#include <fmt/format.h>

#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

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
    try {
        return mirrored_section(std::move(corners));
    } catch (const InputError& error) {
        table.fail("outline", error.what());
    }
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

}  // namespace

void read_bodies(const TomlTable& root, Scene& scene) {
    for (int number = 1;; ++number) {
        const std::string name = number == 1 ? "body" : fmt::format("body_{}", number);
        const std::optional<TomlTable> table = root.optional_table(name);
        if (!table) break;
        scene.bodies.push_back(read_body(*table, name, scene));
    }
}

}  // namespace wetdeck
