// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/symmetry_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

constexpr double tolerance = 1e-9;  // of lengths [m]

bool same(Vec2 a, Vec2 b) {
    return (a - b).cwiseAbs().maxCoeff() < tolerance;
}

Vec2 mirrored(Vec2 point, double plane) {
    return {2 * plane - point.x(), point.y()};
}

/// Whether each box has its mirror image among the boxes, with a mirrored velocity.
bool symmetric(const std::vector<Box>& boxes, const std::vector<Vec2>& velocities, double plane) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Vec2 low(2 * plane - boxes[k].high.x(), boxes[k].low.y());
        const Vec2 high(2 * plane - boxes[k].low.x(), boxes[k].high.y());
        bool found = false;
        for (std::size_t other = 0; other < boxes.size() && !found; ++other) {
            found = same(boxes[other].low, low) && same(boxes[other].high, high) &&
                    (velocities.empty() || same(velocities[other], {-velocities[k].x(), velocities[k].y()}));
        }
        if (!found) return false;
    }
    return true;
}

bool symmetric(const Outline& outline, double plane) {
    return std::all_of(outline.begin(), outline.end(), [&](const Vec2& corner) {
        return std::any_of(outline.begin(), outline.end(),
                           [&](const Vec2& other) { return same(other, mirrored(corner, plane)); });
    });
}

/// Why a body breaks the symmetry; empty where it does not.
std::string asymmetry(const BodySpec& spec, double plane) {
    const RigidBody& body = spec.body;
    if (!symmetric(spec.outline, plane)) return "its outline";
    if (std::abs(body.position.x() - plane) > tolerance) return "its mass centre";
    if (body.free[0] || body.free[2]) return "its freedom along x or in rotation";
    if (body.velocity.x() != 0 || body.angular_velocity != 0) return "its velocity";
    if (body.motion_of(0) || body.motion_of(2) || body.guide.pivot) return "its motion";
    const auto not_upright = [](const Spring& s) { return s.direction != Spring::Direction::y; };
    if (std::any_of(body.springs.begin(), body.springs.end(), not_upright)) return "a spring";
    return {};
}

}  // namespace

void read_symmetry(const TomlTable& root, Scene& scene) {
    const std::optional<TomlTable> table = root.optional_table("symmetry");
    if (!table) return;
    if (table->holds_text("x") && !table->holds_expression("x")) {
        if (table->text("x") != "none")
            table->fail(
                "x", fmt::format("is '{}', expected the middle of the tank or \"none\"", table->text("x")));
        table->finish();
        return;
    }
    const double plane = table->number("x");
    table->finish();
    const auto refuse = [&](const std::string& what) {
        table->fail(
            "x",
            fmt::format("{} not symmetric about x = {:.6g} m; symmetry.x = \"none\" computes the whole tank",
                        what, plane));
    };
    if (std::abs(plane - 0.5 * (scene.tank.low.x() + scene.tank.high.x())) > tolerance)
        table->fail("x", fmt::format("is {:.6g} m, expected the middle of the tank, {:.6g} m", plane,
                                     0.5 * (scene.tank.low.x() + scene.tank.high.x())));
    if (scene.model.gravity.x() != 0) refuse("gravity is");
    if (!symmetric(scene.water_boxes, scene.water_velocities, plane)) refuse("the boxes of water are");
    if (scene.air && !symmetric(scene.air_boxes, {}, plane)) refuse("the boxes of air are");
    if (scene.initial.law != InitialPressure::Law::hydrostatic) refuse("the pressure at the start is");
    if (scene.tank_motion.motion[0] || scene.tank_motion.motion[2]) refuse("the motion of the tank is");
    if (scene.model.contact.on())
        table->fail("x",
                    "half a tank has no contacts of bodies: take out the table [contact], or set symmetry.x "
                    "= \"none\"");
    if (scene.model.sponge_thickness > 0)
        table->fail(
            "x",
            "half a tank has no sponge layer: set model.sponge_thickness to 0, or symmetry.x to \"none\"");
    for (const BodySpec& spec : scene.bodies)
        if (const std::string what = asymmetry(spec, plane); !what.empty())
            refuse(fmt::format("{}: {} is", spec.name, what));
    scene.symmetry = plane;
}

Scene right_half(const Scene& scene) {
    Scene half = scene;
    const double plane = *scene.symmetry;
    half.model.mirror_x = true;
    half.tank.low.x() = plane;
    const auto cut = [plane](std::vector<Box>& boxes, std::vector<Vec2>* velocities) {
        for (std::size_t k = boxes.size(); k-- > 0;) {
            if (boxes[k].high.x() > plane + tolerance) {
                boxes[k].low.x() = std::max(boxes[k].low.x(), plane);
                continue;
            }
            boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(k));
            if (velocities && !velocities->empty())
                velocities->erase(velocities->begin() + static_cast<std::ptrdiff_t>(k));
        }
    };
    cut(half.water_boxes, &half.water_velocities);
    cut(half.air_boxes, nullptr);
    return half;
}

}  // namespace wetdeck
