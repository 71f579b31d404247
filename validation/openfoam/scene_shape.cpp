// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/scene_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"
#include "validation/openfoam/scene_case.hpp"
#include "validation/scene/faces.hpp"

namespace wetdeck {
namespace {

constexpr double tiny = 1e-9;  // [m]
constexpr double flattest = 5 * std::numbers::pi / 180, steepest = 60 * std::numbers::pi / 180;

bool near(double a, double b) {
    return std::abs(a - b) < tiny * std::max({1.0, std::abs(a), std::abs(b)});
}

void check_tank(const Scene& scene) {
    const Model& model = scene.model;
    if (scene.tank_motion.moves()) refuse_for_foam(scene, "its tank moves");
    if (model.gravity.x() != 0 || model.gravity.y() > 0) refuse_for_foam(scene, "gravity is not downwards");
    if (model.periodic_x || model.central_frequency != 0)
        refuse_for_foam(scene, "its domain is no closed tank");
    if (scene.symmetry) refuse_for_foam(scene, "it is a half by [symmetry]; the whole scene is needed");
    for (const Vec2& velocity : scene.water_velocities)
        if (velocity.norm() > 0) refuse_for_foam(scene, "its water moves at the start");
    for (const BodySpec& body : scene.bodies)
        if (body.solid) refuse_for_foam(scene, "it has solids in the tank, or a tank that is no rectangle");
}

void check_motion(const Scene& scene, const BodySpec& spec) {
    const RigidBody& body = spec.body;
    const bool free = std::any_of(body.free.begin(), body.free.end(), [](bool f) { return f; });
    if (free || !spec.guide.empty() || spec.release_at_contact)
        refuse_for_foam(scene,
                        "its body does not move at a constant speed (a variant with constant velocity, or "
                        "--set body.free=[] with the speed at the water)");
    if (body.velocity.x() != 0 || body.velocity.y() >= 0 || body.angular_velocity != 0)
        refuse_for_foam(scene, "its body does not move straight down");
}

void check_water(const Scene& scene, const FoamBody& body) {
    const Box& tank = scene.tank;
    if (scene.water_boxes.size() != 1 || !near(scene.water_boxes[0].low.x(), tank.low.x()) ||
        !near(scene.water_boxes[0].high.x(), tank.high.x()) ||
        !near(scene.water_boxes[0].low.y(), tank.low.y()))
        refuse_for_foam(scene, "its water is not one level over the whole tank");
    if (scene.water_boxes[0].high.y() > body.keel.y() + tiny)
        refuse_for_foam(scene, "its body is in the water at the start");
    if (!near(body.keel.x(), 0.5 * (tank.low.x() + tank.high.x())))
        refuse_for_foam(scene, "its body is not in the middle of the tank");
}

/// A rectangle along the axes, or nothing.
bool is_rectangle(const Outline& outline, const Box& extent) {
    return outline.size() == 4 && std::all_of(outline.begin(), outline.end(), [&](Vec2 p) {
               return (near(p.x(), extent.low.x()) || near(p.x(), extent.high.x())) &&
                      (near(p.y(), extent.low.y()) || near(p.y(), extent.high.y()));
           });
}

}  // namespace

void refuse_for_foam(const Scene& scene, const std::string& why) {
    throw InputError(
        fmt::format("scene '{}', variant '{}', cannot be written for OpenFOAM: {}; supported are {}",
                    scene.name(), scene.variant, why, foam_supported));
}

std::optional<FoamBody> foam_body(const Scene& scene) {
    check_tank(scene);
    if (scene.bodies.empty()) return std::nullopt;
    if (scene.bodies.size() > 1) refuse_for_foam(scene, "it has several bodies");
    const BodySpec& spec = scene.bodies.front();
    check_motion(scene, spec);
    const Outline& outline = spec.outline;
    FoamBody body;
    body.extent = extent_of(outline);
    body.speed = -spec.body.velocity.y();
    body.keel = {0.5 * (body.extent.low.x() + body.extent.high.x()), body.extent.low.y()};
    check_water(scene, body);
    if (is_rectangle(outline, body.extent)) return body;
    const auto lowest =
        std::min_element(outline.begin(), outline.end(), [](Vec2 a, Vec2 b) { return a.y() < b.y(); });
    const std::size_t n = outline.size(), at = static_cast<std::size_t>(lowest - outline.begin());
    const Vec2 keel = outline[at], left = outline[(at + 1) % n] - keel,
               right = outline[(at + n - 1) % n] - keel;
    if (!near(keel.x(), body.keel.x()) || !near(left.x(), -right.x()) || !near(left.y(), right.y()))
        refuse_for_foam(scene,
                        "its section is neither a rectangle nor a symmetric wedge with straight sides");
    const double deadrise = std::atan2(right.y(), std::abs(right.x()));
    if (deadrise < flattest || deadrise > steepest)
        refuse_for_foam(scene, "the deadrise of its wedge is not between 5 and 60 degrees");
    body.deadrise = deadrise;
    body.side = right.norm();
    return body;
}

}  // namespace wetdeck
