// SPDX-License-Identifier: BSD-3-Clause
// Bodies: outlines, poses, motions at the start. Their masses are read in body_mass.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/core/errors.hpp"
#include "validation/scene/body_mass.hpp"
#include "validation/scene/faces.hpp"
#include "validation/scene/motion_section.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/sections.hpp"
#include "validation/scene/springs_section.hpp"

namespace wetdeck {
namespace {

Vec2 point_or(const TomlTable& table, const std::string& key, Vec2 fallback) {
    return table.has(key) ? point(table, key) : fallback;
}

void read_freedom(const TomlTable& table, RigidBody& body) {
    static const std::vector<std::string> names = {"x", "y", "rotation"};
    body.free = {false, false, false};
    if (!table.has("free")) return;
    for (const std::string& name : table.texts("free")) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) table.fail("free", fmt::format("'{}' is none of x, y, rotation", name));
        body.free[static_cast<std::size_t>(found - names.begin())] = true;
    }
}

/// A circle about the origin, as a polygon of even sides with its lowest corner under the centre.
Outline read_circle(const TomlTable& circle) {
    constexpr double most_corners = 1000;
    const double radius = 0.5 * circle.positive("diameter"), corners = circle.number_or("corners", 96);
    if (corners < 8 || corners > most_corners || corners != std::floor(corners))
        circle.fail("corners", fmt::format("expected a whole number from 8 to {}", most_corners));
    circle.finish();
    Outline outline;
    for (double k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        outline.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
    }
    return outline;
}

/// In the frame of the file. Of a mirrored body one half is given, from the keel to the deck.
Outline read_corners(const TomlTable& table) {
    if (table.is_table("outline")) return read_circle(table.table("outline"));
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

TankFace nearest_tank_face(const Outline& outline, const Box& tank) {
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
/// body. Solids may touch the tank and each other.
void check_place(const TomlTable& table, const BodySpec& spec, const Scene& scene) {
    constexpr double tolerance = 1e-9, least_shared_area = 1e-12;
    const TankFace face = nearest_tank_face(spec.outline, scene.tank);
    if (face.gap < -tolerance)
        table.fail("outline",
                   fmt::format("reaches outside the tank: {:.4g} m beyond the {}", -face.gap, face.name));
    const bool may_touch = spec.solid || (scene.model.contact.on() && spec.body.moves());
    if (face.gap <= tolerance && !may_touch)
        table.fail(
            "outline",
            fmt::format("touches the tank's {}: leave a gap of less than half a spacing, which no "
                        "particle enters (0.001 m, say){}",
                        face.name, spec.body.moves() ? ", or switch contact on with a table [contact]" : ""));
    for (const BodySpec& other : scene.bodies) {
        const bool both_solid = spec.solid && other.solid;
        if (both_solid ? shared_area(spec.outline, other.outline) > least_shared_area
                       : overlap(spec.outline, other.outline))
            table.fail("outline", "overlaps that of " + other.name);
    }
}

/// Throws for a point outside the bounding box of the outline, in whose frame it is given, and of those that
/// are joined to it.
void check_mass_centre(const TomlTable& table, Vec2 centre, const std::vector<Outline>& joined,
                       const BodySpec& spec) {
    auto [low, high] = extent_of(spec.drawn);
    for (const Outline& outline : joined) {
        const Box extent = extent_of(outline);
        low = low.cwiseMin(extent.low);
        high = high.cwiseMax(extent.high);
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

/// The outline in the frame of the file, moved to its origin.
void read_outline_of(const TomlTable& table, BodySpec& spec) {
    spec.drawn = read_corners(table);
    for (Vec2& corner : spec.drawn) corner += spec.origin;
    try {
        check_outline(spec.drawn);
    } catch (const InputError& error) {
        table.fail("outline", error.what());
    }
}

/// velocity_x and velocity_y, or a speed and the direction of entry from straight down towards x.
void read_velocity(const TomlTable& table, RigidBody& body) {
    body.velocity = {table.number_or("velocity_x", 0), table.number_or("velocity_y", 0)};
    body.angular_velocity = table.number_or("angular_velocity", 0);
    if (!table.has("speed")) {
        if (table.has("direction")) table.fail("direction", "is that of 'speed', which is missing");
        return;
    }
    if (table.has("velocity_x") || table.has("velocity_y"))
        table.fail("speed", "takes the place of velocity_x and velocity_y, which are given too");
    const double speed = table.number("speed"), direction = read_angle(table, "direction", 0);
    if (speed < 0) table.fail("speed", "expected zero or a positive speed [m/s]");
    body.velocity = speed * Vec2(std::sin(direction), -std::cos(direction));
}

/// When the free motions are let go: at a time, or at the first contact with water.
void read_release(const TomlTable& table, BodySpec& spec) {
    if (!table.has("release")) return;
    double& time = spec.body.guide.release_time;
    if (!spec.body.yields()) table.fail("release", "lets nothing go: no motion is in 'free'");
    if (table.holds_text("release") && table.text("release") == "contact") {
        spec.release_at_contact = true;
        time = std::numeric_limits<double>::infinity();
        return;
    }
    time = table.holds_text("release") ? 0 : table.number("release");
    if (!(time > 0)) table.fail("release", "expected \"contact\" or a positive time [s]");
}

/// Given motions, hinge, springs, release.
void read_guide(const TomlTable& table, const Scene& scene, BodySpec& spec) {
    RigidBody& body = spec.body;
    const GivenMotions given = read_motions(table, scene.end_time, scene.model.water.eos.sound_speed);
    body.guide.motion = given.motion;
    if (table.has("pivot")) body.guide.pivot = spec.in_body_frame(point(table, "pivot"));
    read_release(table, spec);
    read_springs(table, spec);
    for (const char* key : {"motion", "pivot", "release", "springs"}) spec.guide += table.text_of(key);
    static const char* const names[] = {"x", "y", "rotation"};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!body.guide.motion[k]) continue;
        if (body.free[k] && !(body.guide.release_time > 0))
            table.fail("motion", fmt::format("gives {0}, and 'free' lets forces move it: take {0} out of "
                                             "'free', or give a 'release'",
                                             names[k]));
    }
    if (!body.guide.pivot) return;
    if (body.free[0] || body.free[1])
        table.fail("pivot", "holds the body along x and y, which are in 'free'");
    if (!body.velocity.isZero())
        table.fail("pivot", "stays or moves as 'motion' says: expected no velocity of the body");
}

void read_pose(const TomlTable& table, BodySpec& spec) {
    spec.body.angle = read_angle(table, "angle", 0);
    if (std::abs(spec.body.angle) > 2 * std::numbers::pi)
        table.fail("angle", fmt::format("is {:.4g} rad, more than a turn: degrees are written \"8 deg\"",
                                        spec.body.angle));
    spec.outline.clear();
    for (const Vec2& corner : spec.drawn)
        spec.outline.push_back(spec.body.angle == 0 ? corner : spec.body.placed(corner - spec.drawn_centre));
}

std::string body_name(int number) {
    return number == 1 ? "body" : fmt::format("body_{}", number);
}

/// Of two areas together.
AreaMoments sum_of(const AreaMoments& a, const AreaMoments& b) {
    const double area = a.area + b.area;
    const Vec2 centroid = (a.area * a.centroid + b.area * b.centroid) / area;
    return {area, centroid,
            a.second_moment + a.area * (a.centroid - centroid).squaredNorm() + b.second_moment +
                b.area * (b.centroid - centroid).squaredNorm()};
}

/// The table of body number 1, 2, ... if there is one.
std::optional<TomlTable> body_table(const TomlTable& root, int number) {
    return root.optional_table(body_name(number));
}

/// The outlines of the bodies that are joined to this one, as drawn.
std::vector<Outline> outlines_joined_to(const TomlTable& root, const std::string& name) {
    std::vector<Outline> outlines;
    for (int number = 2; const std::optional<TomlTable> table = body_table(root, number); ++number) {
        if (!table->has("joined_to") || table->text("joined_to") != name) continue;
        BodySpec spec;
        spec.origin = point(*table, "position");
        read_outline_of(*table, spec);
        outlines.push_back(spec.drawn);
    }
    return outlines;
}

/// An outline that moves with a body before it, which has the mass of both.
BodySpec read_joined(const TomlTable& table, const std::string& name, const Scene& scene) {
    BodySpec spec;
    spec.name = name;
    const std::string carrier_name = table.text("joined_to");
    const auto carrier = std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const BodySpec& other) {
        return other.name == carrier_name && !other.body.joined_to;
    });
    if (carrier == scene.bodies.end())
        table.fail("joined_to",
                   fmt::format("'{}' is no body before this one that carries itself", carrier_name));
    if (scene.model.contact.on())
        table.fail("joined_to", "bodies that are joined have no contacts: take out the table [contact]");
    spec.origin = point(table, "position");
    read_outline_of(table, spec);
    RigidBody& body = spec.body;
    body.free = {false, false, false};
    body.joined_to = static_cast<std::size_t>(carrier - scene.bodies.begin());
    spec.drawn_centre = area_moments(spec.drawn).centroid;
    const auto turned = [&](Vec2 at) { return carrier->body.placed(at - carrier->drawn_centre); };
    body.position = turned(spec.drawn_centre);
    body.angle = carrier->body.angle;
    for (const Vec2& corner : spec.drawn) spec.outline.push_back(turned(corner));
    spec.guide = table.text_of("joined_to");
    table.finish();
    check_place(table, spec, scene);
    return spec;
}

BodySpec read_body(const TomlTable& root, const TomlTable& table, const std::string& name,
                   const Scene& scene) {
    if (table.has("joined_to")) return read_joined(table, name, scene);
    BodySpec spec;
    spec.name = name;
    spec.origin = point(table, "position");
    read_outline_of(table, spec);
    RigidBody& body = spec.body;
    read_freedom(table, body);
    AreaMoments moments = area_moments(spec.drawn);
    const std::vector<Outline> joined = outlines_joined_to(root, name);
    for (const Outline& more : joined) moments = sum_of(moments, area_moments(more));
    const Vec2 centroid = moments.centroid - spec.origin;
    body.position = spec.origin + point_or(table, "mass_centre", centroid);
    if (table.has("mass_centre")) check_mass_centre(table, body.position - spec.origin, joined, spec);
    spec.drawn_centre = body.position;
    read_mass(table, moments, spec);
    read_pose(table, spec);
    read_velocity(table, body);
    body.applied_force = point_or(table, "applied_force", Vec2::Zero());
    body.applied_torque = table.number_or("applied_torque", 0);
    read_guide(table, scene, spec);
    table.finish();
    check_place(table, spec, scene);
    return spec;
}

BodySpec read_solid(const TomlTable& table, const std::string& name, const Scene& scene) {
    BodySpec spec;
    spec.solid = true;
    spec.name = table.text_or("name", name);
    for (const BodySpec& other : scene.bodies)
        if (other.name == spec.name) table.fail("name", fmt::format("'{}' is taken", spec.name));
    if (spec.name == "tank") table.fail("name", "'tank' is that of the tank");
    spec.origin = point_or(table, "position", Vec2::Zero());
    read_outline_of(table, spec);
    spec.outline = spec.drawn;
    spec.body.free = {false, false, false};
    spec.body.position = spec.drawn_centre = area_moments(spec.drawn).centroid;
    table.finish();
    check_place(table, spec, scene);
    return spec;
}

}  // namespace

void read_bodies(const TomlTable& root, Scene& scene) {
    for (int number = 1; const std::optional<TomlTable> table = body_table(root, number); ++number)
        scene.bodies.push_back(read_body(root, *table, body_name(number), scene));
    int number = 0;
    for (const TomlTable& table : root.tables("solids")) {
        ++number;
        const std::string name = number == 1 ? "solid" : fmt::format("solid_{}", number);
        scene.bodies.push_back(read_solid(table, name, scene));
    }
}

void add_tank_walls(const TomlTable& tank, const Outline& outline, Scene& scene) {
    int number = 0;
    for (Outline& part : parts_outside(scene.tank, outline)) {
        ++number;
        BodySpec spec;
        spec.solid = true;
        spec.name = number == 1 ? "tank_wall" : fmt::format("tank_wall_{}", number);
        spec.outline = spec.drawn = std::move(part);
        spec.body.free = {false, false, false};
        spec.body.position = spec.drawn_centre = area_moments(spec.drawn).centroid;
        check_place(tank, spec, scene);
        scene.bodies.push_back(std::move(spec));
    }
}

}  // namespace wetdeck
