// SPDX-License-Identifier: BSD-3-Clause
#include "solver/bodies/spring.hpp"

#include <algorithm>
#include <cmath>

#include "solver/bodies/rigid_body.hpp"
#include "solver/core/cross.hpp"

namespace wetdeck {
namespace {

/// Along the straight piece of a table that holds x, or along the nearest.
double interpolated(const Curve& table, double x) {
    const auto after = std::upper_bound(table.x.begin(), table.x.end(), x);
    const auto k = std::clamp<std::ptrdiff_t>(after - table.x.begin(), 1,
                                              static_cast<std::ptrdiff_t>(table.x.size()) - 1);
    const auto i = static_cast<std::size_t>(k);
    const double slope = (table.y[i] - table.y[i - 1]) / (table.x[i] - table.x[i - 1]);
    return table.y[i - 1] + slope * (x - table.x[i - 1]);
}

}  // namespace

double Spring::pull(double elongation, double rate) const {
    if (!table.x.empty()) return interpolated(table, elongation) + damping * rate;
    const double beyond = elongation > play[1]   ? elongation - play[1]
                          : elongation < play[0] ? elongation - play[0]
                                                 : 0;
    const bool plays = play[0] < play[1] && beyond == 0;
    return plays ? 0 : stiffness * beyond + damping * rate;
}

double Spring::largest_stiffness() const {
    double largest = std::abs(stiffness);
    for (std::size_t k = 1; k < table.x.size(); ++k)
        largest = std::max(largest, std::abs((table.y[k] - table.y[k - 1]) / (table.x[k] - table.x[k - 1])));
    return largest;
}

BodyLoad Spring::load(const RigidBody& body, Vec2 velocity, double angular_velocity) const {
    if (direction == Direction::line) {
        const Vec2 arm = body.axes() * on_body, line = on_earth - (body.position + arm);
        const double length = line.norm();
        if (!(length > 0)) return {};
        const Vec2 along = line / length;
        const Vec2 end_velocity = velocity + angular_velocity * Vec2(-arm.y(), arm.x());
        const Vec2 force = pull(length - free_length, -along.dot(end_velocity)) * along;
        return {force, cross(arm, force)};
    }
    if (direction == Direction::rotation)
        return {Vec2::Zero(), -pull(body.angle - body.guide.start_angle - rest, angular_velocity)};
    const int k = direction == Direction::x ? 0 : 1;
    BodyLoad load;
    load.force[k] = -pull(body.position[k] - body.guide.start[k] - rest, velocity[k]);
    return load;
}

double Spring::frequency2(const RigidBody& body) const {
    const double per_mass = (body.free[0] || body.free[1]) && body.mass > 0 ? 1 / body.mass : 0;
    const double inertia = body.turning_inertia();
    const double per_inertia = body.free[2] && inertia > 0 ? 1 / inertia : 0;
    const double k = largest_stiffness();
    if (direction == Direction::rotation) return k * per_inertia;
    const Vec2 hinge = body.guide.pivot.value_or(Vec2::Zero());
    const Vec2 acts = direction == Direction::line ? on_body : Vec2(0, 0);
    return k * (per_mass + (acts - hinge).squaredNorm() * per_inertia);
}

}  // namespace wetdeck
