// SPDX-License-Identifier: BSD-3-Clause
// Bodies: outlines, masses and motions at the start.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

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

/// A face of the tank, and how far it is from the body: negative beyond it [m].
struct TankFace {
    const char* name;
    double gap;
};

TankFace nearest_face(const Outline& outline, const Box& tank) {
    TankFace nearest{"", std::numeric_limits<double>::infinity()};
    for (const Vec2& corner : outline) {
        const Vec2 low = corner - tank.low, high = tank.high - corner;
        for (const TankFace& face : {TankFace{"floor", low.y()}, TankFace{"roof", high.y()},
                                     TankFace{"left wall", low.x()}, TankFace{"right wall", high.x()}}) {
            if (face.gap < nearest.gap) nearest = face;
        }
    }
    return nearest;
}

/// Throws where the body starts outside the tank, in contact with it without a law of contact, or in another
/// body.
void check_place(const TomlTable& table, const BodySpec& spec, const Scene& scene) {
    constexpr double tolerance = 1e-9;
    const TankFace face = nearest_face(spec.outline, scene.tank);
    if (face.gap < -tolerance)
        table.fail("outline",
                   fmt::format("reaches outside the tank: {:.4g} m beyond the {}", -face.gap, face.name));
    const bool may_touch = scene.model.contact.on() && spec.body.moves();
    if (face.gap <= tolerance && !may_touch)
        table.fail(
            "outline",
            fmt::format("touches the tank's {}: leave a gap of less than half a spacing, which no "
                        "particle enters (0.001 m, say){}",
                        face.name, spec.body.moves() ? ", or switch contact on with a table [contact]" : ""));
    for (const BodySpec& other : scene.bodies)
        if (overlap(spec.outline, other.outline)) table.fail("outline", "overlaps that of " + other.name);
}

/// Throws for a point outside the bounding box of the outline, in whose frame it is given.
void check_mass_centre(const TomlTable& table, Vec2 centre, const BodySpec& spec) {
    Vec2 low = spec.outline.front(), high = low;
    for (const Vec2& corner : spec.outline) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    low -= spec.origin;
    high -= spec.origin;
    if ((centre - low).minCoeff() >= -1e-9 && (high - centre).minCoeff() >= -1e-9) return;
    table.fail(
        "mass_centre",
        fmt::format("is ({:.6g}, {:.6g}), expected a point within the outline, from ({:.6g}, {:.6g}) to "
                    "({:.6g}, {:.6g}) m: it is given in the frame of the outline, not of the tank",
                    centre.x(), centre.y(), low.x(), low.y(), high.x(), high.y()));
}

/// Mass and inertia: of even density over the outline unless the file knows better, with Steiner's share for
/// a mass centre beside the centroid.
void read_mass(const TomlTable& table, const AreaMoments& moments, BodySpec& spec) {
    RigidBody& body = spec.body;
    body.mass = body.free[0] || body.free[1] ? table.positive("mass") : table.number_or("mass", 0);
    const Vec2 beside = body.position - moments.centroid;
    spec.even_inertia = body.mass * (moments.second_moment / moments.area + beside.squaredNorm());
    body.inertia = table.number_or("inertia", spec.even_inertia);
    if (!body.free[2] || body.inertia > 0) return;
    if (table.has("inertia")) table.fail("inertia", "expected a positive number [kg m]");
    table.fail("mass", table.has("mass") ? "expected a positive number [kg/m]"
                                         : "missing: a body that is free to turn needs its mass [kg/m], from "
                                           "which its inertia follows, or its inertia [kg m]");
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
    RigidBody& body = spec.body;
    read_freedom(table, body);
    const AreaMoments moments = area_moments(spec.outline);
    const Vec2 centroid = moments.centroid - spec.origin;
    body.position = spec.origin + point_or(table, "mass_centre", centroid);
    if (table.has("mass_centre")) check_mass_centre(table, body.position - spec.origin, spec);
    read_mass(table, moments, spec);
    body.velocity = {table.number_or("velocity_x", 0), table.number_or("velocity_y", 0)};
    body.angular_velocity = table.number_or("angular_velocity", 0);
    body.applied_force = point_or(table, "applied_force", Vec2::Zero());
    body.applied_torque = table.number_or("applied_torque", 0);
    table.finish();
    check_place(table, spec, scene);
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
