// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/expected_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/scene/faces.hpp"
#include "validation/scene/wet_bodies.hpp"

namespace wetdeck {
namespace {

constexpr double tolerance = 1e-9;  // of lengths [m]
constexpr int instants_looked_at = 200;

bool in_column(const Box& box, double x) {
    return box.low.x() <= x && x <= box.high.x();
}

/// Top of the water at or below a height in a column, or the floor.
double support_below(const Scene& scene, double x, double height) {
    double top = scene.tank.low.y();
    for (const Box& box : scene.water_boxes)
        if (in_column(box, x) && box.high.y() <= height + tolerance) top = std::max(top, box.high.y());
    return top;
}

double highest_step(const Scene& scene) {
    double low = scene.tank.high.y(), high = scene.tank.low.y();
    for (const double x : column_middles(scene)) {
        const double level = support_below(scene, x, scene.tank.high.y());
        low = std::min(low, level);
        high = std::max(high, level);
    }
    return std::max(0.0, high - low);
}

/// How far water falls to what is below it.
double deepest_fall(const Scene& scene) {
    double deepest = 0;
    for (const Box& box : scene.water_boxes)
        for (const double x : column_middles(scene))
            if (in_column(box, x))
                deepest = std::max(deepest, box.low.y() - support_below(scene, x, box.low.y()));
    return deepest;
}

/// Top of the water below a body, or the floor.
double level_below(const Scene& scene, const Box& extent) {
    double level = scene.tank.low.y();
    for (const Box& box : scene.water_boxes)
        if (box.low.x() < extent.high.x() && extent.low.x() < box.high.x())
            level = std::max(level, box.high.y());
    return level;
}

/// Downwards, of a body that is free to fall [m/s^2].
double falling_acceleration(const Scene& scene, const RigidBody& body) {
    if (!body.free[1] || !(body.mass > 0)) return 0;
    return std::max(0.0, -scene.model.gravity.y() - body.applied_force.y() / body.mass);
}

bool has_given_motion(const RigidBody& body) {
    return body.guide.pivot || body.motion_of(0) || body.motion_of(1) || body.motion_of(2);
}

double speed_of_body(const Scene& scene, const BodySpec& spec) {
    const Box extent = extent_of(spec.outline);
    double radius = 0;
    for (const Vec2& corner : spec.outline) radius = std::max(radius, (corner - spec.body.position).norm());
    RigidBody body = spec.body;
    body.radius = radius;
    const double height = std::max(0.0, extent.low.y() - level_below(scene, extent));
    return std::max(largest_given_speed(scene, body),
                    std::sqrt(body.velocity.squaredNorm() + 2 * falling_acceleration(scene, body) * height) +
                        radius * std::abs(body.angular_velocity));
}

/// The outline after a time at the velocities and motions that are given; degrees of freedom that are free
/// stay.
Outline moved(const BodySpec& spec, double time) {
    RigidBody body = spec.body;
    body.start();
    for (int k = 0; k < 2; ++k)
        if (!body.free[static_cast<std::size_t>(k)]) body.position[k] += time * body.velocity[k];
    if (!body.free[2]) body.angle += time * body.angular_velocity;
    if (body.guided()) body.drift(0, time);
    Outline outline;
    for (const Vec2& corner : spec.local_outline()) outline.push_back(body.placed(corner));
    return outline;
}

/// Whether some part of the motion is given and not zero.
bool driven(const RigidBody& body) {
    return (!body.free[0] && body.velocity.x() != 0) || (!body.free[1] && body.velocity.y() != 0) ||
           (!body.free[2] && body.angular_velocity != 0) || has_given_motion(body);
}

/// A motion that is given in part counts for the faces across that part alone.
Box faces_reached(const RigidBody& body, Box tank) {
    const double far = 1e6 * (tank.high - tank.low).norm();
    for (int k = 0; k < 2; ++k) {
        if (!body.free[static_cast<std::size_t>(k)]) continue;
        tank.low[k] -= far;
        tank.high[k] += far;
    }
    return tank;
}

}  // namespace

double largest_given_speed(const Scene& scene, const RigidBody& body) {
    double largest = 0;
    for (int k = 0; k <= instants_looked_at && has_given_motion(body); ++k) {
        const double time = k * scene.end_time / instants_looked_at;
        const auto speed = [&](int degree) {
            return body.motion_of(degree) ? body.motion_of(degree)(time).velocity : 0;
        };
        largest = std::max(largest, std::hypot(speed(0), speed(1)) + body.radius * std::abs(speed(2)));
    }
    return largest;
}

std::vector<double> column_middles(const Scene& scene) {
    std::vector<double> ends = {scene.tank.low.x(), scene.tank.high.x()};
    for (const Box& box : scene.water_boxes) ends.insert(ends.end(), {box.low.x(), box.high.x()});
    std::sort(ends.begin(), ends.end());
    std::vector<double> middles;
    for (std::size_t k = 1; k < ends.size(); ++k)
        if (ends[k] - ends[k - 1] > tolerance) middles.push_back(0.5 * (ends[k] + ends[k - 1]));
    return middles;
}

std::optional<WaterEntry> water_entry(const Scene& scene, const BodySpec& spec) {
    if (starts_in_water(scene, spec)) return std::nullopt;
    const Box extent = extent_of(spec.outline);
    const double level = level_below(scene, extent), height = extent.low.y() - level;
    if (level <= scene.tank.low.y() || height < 0) return std::nullopt;
    const double down = -spec.body.velocity.y(), acceleration = falling_acceleration(scene, spec.body);
    const double speed = std::sqrt(std::max(0.0, down * std::abs(down) + 2 * acceleration * height));
    if (!(speed > 0)) return std::nullopt;
    WaterEntry entry{speed, 2 * height / (speed + down), level, spec.outline.front()};
    for (const Vec2& corner : spec.outline)
        if (corner.y() < entry.keel.y()) entry.keel = corner;
    return entry;
}

ExpectedSpeed fastest_expected_speed(const Scene& scene) {
    const double g = scene.model.gravity.norm();
    ExpectedSpeed fastest{std::sqrt(g * highest_step(scene)), "of the water that collapses"};
    const auto consider = [&fastest](double speed, const std::string& of) {
        if (speed > fastest.speed) fastest = {speed, of};
    };
    consider(std::sqrt(2 * g * deepest_fall(scene)), "of the water that falls");
    for (const BodySpec& spec : scene.bodies)
        consider(speed_of_body(scene, spec), fmt::format("of {}", spec.name));
    return fastest;
}

std::vector<Outline> positions_given(const Scene& scene, const BodySpec& spec) {
    std::vector<Outline> positions;
    if (!has_given_motion(spec.body) || spec.release_at_contact) return positions;
    const double release = spec.body.guide.release_time;
    const double end = release > 0 ? std::min(release, scene.end_time) : scene.end_time;
    for (const int third : {1, 2, 3}) positions.push_back(moved(spec, third * end / 3));
    return positions;
}

std::optional<std::string> collision_of_given_motion(const Scene& scene, const BodySpec& spec) {
    if (!driven(spec.body)) return std::nullopt;
    const Box faces = faces_reached(spec.body, scene.tank);
    const bool lets_go = spec.body.guide.release_time > 0;
    for (int k = 1; k <= instants_looked_at; ++k) {
        const double time = k * scene.end_time / instants_looked_at;
        if (lets_go && (spec.release_at_contact || time > spec.body.guide.release_time)) break;
        const Outline outline = moved(spec, time);
        if (!inside(outline, faces))
            return fmt::format("leads it out of the tank at about {:.3g} s, before the end at {:.3g} s", time,
                               scene.end_time);
        for (const BodySpec& other : scene.bodies)
            if (&other != &spec && !other.body.moves() && overlap(outline, other.outline))
                return fmt::format("leads it into {} at about {:.3g} s", other.name, time);
    }
    return std::nullopt;
}

std::vector<std::string> motions_out_of_tank(const Scene& scene) {
    std::vector<std::string> found;
    for (const BodySpec& spec : scene.bodies)
        if (const auto collision = collision_of_given_motion(scene, spec))
            found.push_back(fmt::format("the motion given for {} {}", spec.name, *collision));
    return found;
}

}  // namespace wetdeck
