// SPDX-License-Identifier: BSD-3-Clause
// The motion of a tank, seen from the tank: with the sway X(t), the heave Y(t) and the roll theta(t) about a
// centre C, fluid and bodies in it get, besides gravity g,
//
//     f(r, v, t) = R(-theta) (g - A) - g - alpha z x (r - C) + omega^2 (r - C) - 2 omega z x v,
//
// with A = (X'', Y''), omega = theta', alpha = theta'', and z x (x, y) = (-y, x).
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "solver/bodies/motion.hpp"
#include "solver/core/vec2.hpp"

namespace wetdeck {

/// What the motion of the tank does at one time.
struct FrameForces {
    Vec2 uniform = Vec2::Zero();      ///< R(-theta) (g - A) - g [m/s^2]
    Vec2 centre = Vec2::Zero();       ///< C, in the tank [m]
    double angular_velocity = 0;      ///< omega [rad/s]
    double angular_acceleration = 0;  ///< alpha [rad/s^2]

    /// f of what is at a position and moves with a velocity, both in the tank [m/s^2].
    Vec2 at(Vec2 position, Vec2 velocity) const {
        const Vec2 r = position - centre;
        const double w = angular_velocity, alpha = angular_acceleration;
        return uniform + w * w * r +
               Vec2(alpha * r.y() + 2 * w * velocity.y(), -alpha * r.x() - 2 * w * velocity.x());
    }
};

/// The motion of a tank.
struct MovingFrame {
    std::array<Motion, 3> motion;  ///< sway, heave, roll: displacements in the earth's frame; none: at rest
    Vec2 centre = Vec2::Zero();    ///< of the roll, in the tank at the start [m]

    /// Whether any motion is given.
    bool moves() const {
        return std::any_of(motion.begin(), motion.end(),
                           [](const Motion& m) { return static_cast<bool>(m); });
    }
    /// The forces at a time [s] under gravity [m/s^2].
    FrameForces forces(double time, Vec2 gravity) const {
        std::array<MotionState, 3> now;
        for (std::size_t k = 0; k < 3; ++k)
            if (motion[k]) now[k] = motion[k](time);
        const Vec2 acceleration(now[0].acceleration, now[1].acceleration);
        const Eigen::Rotation2Dd back(-now[2].displacement);
        return {back * (gravity - acceleration) - gravity, centre, now[2].velocity, now[2].acceleration};
    }
};

}  // namespace wetdeck
