// SPDX-License-Identifier: BSD-3-Clause
// A rigid body in the plane: three degrees of freedom, each moved by forces or kept at its velocity, Yang et
// al. (2020), Eqs. (4)-(5) and (20)-(23).
//
//     M dv/dt = F + M g + F_applied,   I domega/dt = T + T_applied
//
// Loads come in two parts: the slow one acts at the first and the last of the short steps that make a long
// one, for all of them, the fast one in each.
//
// The wall pressure (17) holds the body's last acceleration: F = F0 - m a_last, with m the fluid that follows
// the surface at once. Where m is larger than M this would swing up. With the same mass m on both sides,
//
//     (M + m) a = F + M g + F_applied + m a_last,
//
// it settles within a few (M + m)/M long steps, on the same motion; what the body's momentum lacks meanwhile
// is m (a_last - a_first) dt, not a sum over steps, as far as the fast loads are the same throughout a long
// step dt. Only bodies lighter than that fluid get any of it.
// The pose is integrated, never the particles of the surface: they are placed from it, so that nothing
// drifts.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/core/vec2.hpp"

namespace wetdeck {

/// What acts on a body.
struct BodyLoad {
    Vec2 force = Vec2::Zero();  ///< [N/m]
    double torque = 0;          ///< about the mass centre [N]
};

/// One body: what it is, how it moves, what the fluid does to it.
struct RigidBody {
    double mass = 0;                                ///< [kg/m]
    double inertia = 0;                             ///< about the mass centre [kg m]
    std::array<bool, 3> free = {true, true, true};  ///< x, y, rotation; the others keep their velocity
    Vec2 applied_force = Vec2::Zero();              ///< constant, besides weight [N/m]
    double applied_torque = 0;                      ///< constant [N]

    Vec2 position = Vec2::Zero();  ///< of the mass centre [m]
    double angle = 0;              ///< counter-clockwise, never wrapped [rad]
    Vec2 velocity = Vec2::Zero();  ///< of the mass centre [m/s]
    double angular_velocity = 0;   ///< [rad/s]

    Vec2 force = Vec2::Zero();         ///< by the fluid, of the last evaluation [N/m]
    double torque = 0;                 ///< by the fluid, about the mass centre [N]
    BodyLoad slow;                     ///< the part of both that acts in long steps
    BodyLoad slow_push;                ///< the same with m a_last, m g less
    Vec2 acceleration = Vec2::Zero();  ///< of the mass centre [m/s^2]
    double angular_acceleration = 0;   ///< [rad/s^2]

    double attached_mass = 0;     ///< of the fluid that follows the surface at once [kg/m]
    double attached_inertia = 0;  ///< of the same, about the mass centre [kg m]

    Vec2 impulse = Vec2::Zero();  ///< time integral of `force` since the start [N s/m]
    double angular_impulse = 0;   ///< time integral of `torque` [N s]
    double work = 0;              ///< of the fluid on the body since the start [J/m]

    /// Throws InputError if it is free to move without mass or inertia.
    void check() const {
        const bool translates = free[0] || free[1];
        if (translates && !(mass > 0)) throw InputError("a body that is free to move needs a positive mass");
        if (free[2] && !(inertia > 0))
            throw InputError("a body that is free to turn needs a positive inertia");
    }

    /// What stands as m in the equation of motion [kg/m].
    double following_mass() const { return std::max(0.0, attached_mass - mass); }
    /// The same of rotation [kg m].
    double following_inertia() const { return std::max(0.0, attached_inertia - inertia); }

    /// Sets the slow loads by the fluid. The fast ones must be set after them.
    void load_slow(const BodyLoad& load, Vec2 gravity) {
        slow = load;
        slow_push.force = load.force + following_mass() * (acceleration - gravity);
        slow_push.torque = load.torque + following_inertia() * angular_acceleration;
    }

    /// Sets the fast loads by the fluid, and the accelerations that follow from all.
    void load_fast(const BodyLoad& load, Vec2 gravity) {
        force = load.force + slow.force;
        torque = load.torque + slow.torque;
        const Vec2 sum = load.force + slow_push.force + applied_force;
        for (int k = 0; k < 2; ++k) {
            const bool moves = free[static_cast<std::size_t>(k)];
            acceleration[k] = moves ? sum[k] / (mass + following_mass()) + gravity[k] : 0;
        }
        const double twist = load.torque + slow_push.torque + applied_torque;
        angular_acceleration = free[2] ? twist / (inertia + following_inertia()) : 0;
    }

    /// Velocities and impulses over a time [s] with the loads as they are; the slow ones act over that time
    /// as often as their weight says.
    void kick(double duration, double slow_weight) {
        const double longer = (slow_weight - 1) * duration;
        const Vec2 push = duration * force + longer * slow.force;
        const double twist = duration * torque + longer * slow.torque;
        Vec2 gain = duration * acceleration;
        for (int k = 0; k < 2; ++k) {
            const bool moves = free[static_cast<std::size_t>(k)];
            if (moves) gain[k] += longer * slow_push.force[k] / (mass + following_mass());
        }
        double spin = duration * angular_acceleration;
        if (free[2]) spin += longer * slow_push.torque / (inertia + following_inertia());
        work += push.dot(velocity + 0.5 * gain) + twist * (angular_velocity + 0.5 * spin);
        velocity += gain;
        angular_velocity += spin;
        impulse += push;
        angular_impulse += twist;
    }

    /// Position and angle over a time [s] with the velocities as they are.
    void drift(double duration) {
        position += duration * velocity;
        angle += duration * angular_velocity;
    }

    /// Axes of the body's frame, as columns; at angle 0 they are those of the scene.
    Eigen::Matrix2d axes() const { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }
    /// A point of the body's frame, whose origin is the mass centre, in the scene [m].
    Vec2 placed(Vec2 point) const { return position + axes() * point; }
    /// A point of the scene in the body's frame [m].
    Vec2 local(Vec2 point) const { return axes().transpose() * (point - position); }

    /// Velocity of the body where `arm` leads from the mass centre, Eq. (5) [m/s].
    Vec2 velocity_at(Vec2 arm) const { return velocity + angular_velocity * Vec2(-arm.y(), arm.x()); }
    /// A speed that no point within `radius` [m] of the mass centre exceeds [m/s].
    double fastest_within(double radius) const {
        return velocity.norm() + radius * std::abs(angular_velocity);
    }
    /// Acceleration there: of the centre, of the rotation, and centripetal [m/s^2].
    Vec2 acceleration_at(Vec2 arm) const {
        return acceleration + angular_acceleration * Vec2(-arm.y(), arm.x()) -
               angular_velocity * angular_velocity * arm;
    }

    double kinetic_energy() const {  ///< [J/m]
        return 0.5 * (mass * velocity.squaredNorm() + inertia * angular_velocity * angular_velocity);
    }
};

}  // namespace wetdeck
