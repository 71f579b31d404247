// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/setup/body_outline.hpp"
#include "solver/time/time_step.hpp"

namespace wetdeck {
namespace {

double lowest(const Outline& outline) {
    const auto below = [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); };
    return std::min_element(outline.begin(), outline.end(), below)->y();
}

/// Of the bodies when they have fallen to the water, and of the water when its column has collapsed [m/s].
double fastest_speed(const Scene& scene) {
    const double g = scene.model.gravity.norm();
    double fastest = 0;
    for (const Box& box : scene.water_boxes) {
        const bool fills_tank = (box.high - box.low).x() >= 0.99 * (scene.tank.high - scene.tank.low).x();
        if (!fills_tank) fastest = std::max(fastest, std::sqrt(g * (box.high - box.low).y()));
    }
    for (const BodySpec& body : scene.bodies) {
        const double fall = std::max(0.0, lowest(body.outline) - scene.initial.surface);
        const double falling = body.body.free[1] ? 2 * g * fall : 0;
        fastest = std::max(fastest, std::sqrt(body.body.velocity.squaredNorm() + falling));
    }
    return fastest;
}

}  // namespace

std::vector<std::string> doubtful(const Scene& scene) {
    std::vector<std::string> found;
    const TaitEquationOfState& eos = scene.model.water.eos;
    const double speed = fastest_speed(scene);
    if (eos.sound_speed < 9.9 * speed) {
        found.push_back(fmt::format(
            "water.sound_speed is {:.4g} m/s, less than ten times the fastest speed to expect, {:.3g} m/s: "
            "the water would be compressed by about {:.2g} %",
            eos.sound_speed, speed, 100 * speed * speed / (eos.sound_speed * eos.sound_speed)));
    }
    const TaitEquationOfState& air = scene.model.air.eos;
    if (scene.air && air.background_pressure > 0.5 * air.coefficient()) {
        found.push_back(fmt::format(
            "model.background_pressure is {:.4g} Pa, more than half of the air's own stiffness rho "
            "c^2/gamma, {:.3g} Pa: it would tear light air apart",
            air.background_pressure, air.coefficient()));
    }
    for (const Probe& probe : scene.probes)
        found.insert(found.end(), probe.doubts.begin(), probe.doubts.end());
    for (const BodySpec& body : scene.bodies) {
        const auto wet = [&](const Vec2& corner) {
            return std::any_of(scene.water_boxes.begin(), scene.water_boxes.end(), [&](const Box& box) {
                return (corner - box.low).minCoeff() > 0 && (box.high - corner).minCoeff() > 0;
            });
        };
        if (std::any_of(body.outline.begin(), body.outline.end(), wet))
            found.push_back(fmt::format("{} starts in the water", body.name));
        const double ratio = body.body.mass / (area_moments(body.outline).area * eos.reference_density);
        if (ratio > 30 || ratio < 1.0 / 60)
            found.push_back(
                fmt::format("{} has {:.2g} times the mass of the water it would displace: is it "
                            "per metre of width?",
                            body.name, ratio));
    }
    return found;
}

std::optional<std::string> doubtful_step(const Scene& scene, double particle_spacing) {
    const double h = scene.model.smoothing_ratio * particle_spacing;
    const TimeStep stable = stable_time_step(scene.model, h, {0, 0}, true, scene.air);
    if (step_of(scene.model, stable).criterion != LimitingCriterion::fixed_beyond) return std::nullopt;
    return fmt::format(
        "model.fixed_step is {:.3g} s, {:.3g} times the stable step of {:.3g} s at the spacing {:.4g} m: the "
        "run may "
        "become unstable or be wrong without a sign",
        scene.model.fixed_step, scene.model.fixed_step / stable.size, stable.size, particle_spacing);
}

}  // namespace wetdeck
