// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/scene_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/core/errors.hpp"
#include "validation/openfoam/scene_case.hpp"
#include "validation/scene/bottom.hpp"
#include "validation/scene/faces.hpp"

namespace wetdeck {
namespace {

constexpr double tiny = 1e-9;  // [m]
constexpr double flattest = 5 * std::numbers::pi / 180, steepest = 60 * std::numbers::pi / 180;
constexpr double flat_share_of_beam = 0.1;

bool near(double a, double b) {
    return std::abs(a - b) < tiny * std::max({1.0, std::abs(a), std::abs(b)});
}

void check_tank(const Scene& scene) {
    const Model& model = scene.model;
    if (scene.tank_motion.moves()) refuse_for_foam(scene, "its tank moves");
    if (model.gravity.x() != 0 || model.gravity.y() > 0) refuse_for_foam(scene, "gravity is not downwards");
    if (model.periodic_x || model.central_frequency != 0)
        refuse_for_foam(scene, "its domain is no closed tank");
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
}

/// The mesh leaves room for a cell or two around the body.
void check_room(const Scene& scene, const FoamBody& body) {
    const Box &tank = scene.tank, &extent = body.extent;
    if (extent.low.x() <= tank.low.x() || extent.high.x() >= tank.high.x() ||
        extent.low.y() <= tank.low.y() || extent.high.y() >= tank.high.y())
        refuse_for_foam(scene, "its body touches the tank");
}

/// A rectangle along the axes, or nothing.
bool is_rectangle(const Outline& outline, const Box& extent) {
    return outline.size() == 4 && std::all_of(outline.begin(), outline.end(), [&](Vec2 p) {
               return (near(p.x(), extent.low.x()) || near(p.x(), extent.high.x())) &&
                      (near(p.y(), extent.low.y()) || near(p.y(), extent.high.y()));
           });
}

/// The right side of an upright wedge from its keel to its beam, or nothing.
std::optional<Vec2> wedge_side(const Outline& outline, const FoamBody& body) {
    const std::size_t n = outline.size(),
                      at = static_cast<std::size_t>(std::find(outline.begin(), outline.end(), body.keel) -
                                                    outline.begin());
    Vec2 left = outline[(at + 1) % n] - body.keel, right = outline[(at + n - 1) % n] - body.keel;
    if (left.x() > right.x()) std::swap(left, right);
    if (!near(left.x(), -right.x()) || !near(left.y(), right.y())) return std::nullopt;
    if (!near(body.keel.x() + right.x(), body.extent.high.x())) return std::nullopt;
    const double deadrise = std::atan2(right.y(), right.x());
    if (deadrise < flattest || deadrise > steepest) return std::nullopt;
    return right;
}

/// Whether sides that follow each other, each flatter than 4 degrees, face down over a tenth of the beam: the
/// lowest part of a circle takes 7 hundredths.
bool has_flat_part(const Outline& outline, const Box& extent) {
    const double onwards = counter_clockwise(outline) ? 1 : -1;
    const double least = flat_share_of_beam * (extent.high.x() - extent.low.x());
    const std::size_t n = outline.size();
    double width = 0;
    for (std::size_t k = 0; k < 2 * n; ++k) {  // twice around: a run may pass the first corner
        const Vec2 side = outline[(k + 1) % n] - outline[k % n];
        const double across = onwards * side.x();
        const bool flat = across > 0 && std::abs(side.y()) < across * std::tan(flattest_deadrise_of_wedge);
        width = flat ? width + across : 0;
        if (width >= least) return true;
    }
    return false;
}

/// Whether the underside, from the left end of the beam to the right one, falls again after it has risen.
bool is_hollow(const Outline& outline) {
    const double onwards = counter_clockwise(outline) ? 1 : -1;
    const std::size_t n = outline.size();
    std::size_t start = 0;
    for (std::size_t k = 0; k < n; ++k)
        if (outline[k].x() < outline[start].x() ||
            (outline[k].x() == outline[start].x() && outline[k].y() < outline[start].y()))
            start = k;
    bool risen = false;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 from = outline[(onwards > 0 ? start + i : start + n - i) % n],
                   to = outline[(onwards > 0 ? start + i + 1 : start + 2 * n - i - 1) % n];
        if (to.x() < from.x() - tiny) break;
        if (to.y() > from.y() + tiny) risen = true;
        if (risen && to.y() < from.y() - tiny) return true;
    }
    return false;
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
    body.keel =
        *std::min_element(outline.begin(), outline.end(), [](Vec2 a, Vec2 b) { return a.y() < b.y(); });
    check_water(scene, body);
    check_room(scene, body);
    const double middle = 0.5 * (body.extent.low.x() + body.extent.high.x());
    const bool centred = near(middle, 0.5 * (scene.tank.low.x() + scene.tank.high.x()));
    if (centred && is_rectangle(outline, body.extent)) {
        body.shape = FoamBody::Shape::plate;
        body.keel.x() = middle;
    } else if (const auto side = wedge_side(outline, body); centred && side) {
        body.shape = FoamBody::Shape::wedge;
        body.deadrise = std::atan2(side->y(), side->x());
        body.side = side->norm();
    } else {
        body.flat = has_flat_part(outline, body.extent);
        body.hollow = is_hollow(outline);
    }
    return body;
}

}  // namespace wetdeck
