// SPDX-License-Identifier: BSD-3-Clause
// A rigid body in the plane: three degrees of freedom, each moved by forces or kept at its velocity, Yang et
// al. (2020), Eqs. (4)-(5) and (20)-(23):
//
//     M dv/dt = F + M g + F_applied,   I domega/dt = T + T_applied
//
// Loads come in two parts: the slow loads, of the water, act in the first and the last of the short steps
// that make a long one, with the weight of all of them; the fast loads, of the air, act in each.
//
// The wall pressure (17) holds the body's last acceleration: F = F0 - m a_last, with m the added mass of the
// water that follows the surface at once. Where m is larger than M this would oscillate and grow. With the
// excess x = max(0, m - M) on both sides,
//
//     (M + x) a = F + M g + F_applied + x a_last,
//
// the body settles on the same motion; its momentum lacks x (a_last - a_first) dt meanwhile, which does not
// add up over steps as long as the fast loads are steady within a long step dt. Heavier bodies have no
// excess.
//
// The pose is integrated, never the particles of the surface: they are placed from it, so that nothing
// drifts.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/core/errors.hpp"
#include "solver/core/vec2.hpp"

namespace wetdeck {

/// Force and torque on a body.
struct BodyLoad {
    Vec2 force = Vec2::Zero();  ///< [N/m]
    double torque = 0;          ///< about the mass centre [N]
};

/// One body: its properties, its motion, the loads of the fluid.
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
    BodyLoad slow;                     ///< the slow part of both
    BodyLoad contact;                  ///< by the tank and other bodies, of the last evaluation
    BodyLoad slow_with_excess;         ///< the same with x (a_last - g)
    Vec2 acceleration = Vec2::Zero();  ///< of the mass centre [m/s^2]
    double angular_acceleration = 0;   ///< [rad/s^2]

    double added_mass = 0;           ///< of the water that follows the surface at once [kg/m]
    double added_inertia = 0;        ///< of the same, about the mass centre [kg m]
    std::vector<Vec2> corners = {};  ///< of the outline, in the body's frame [m]; only contact needs them
    double radius = 0;               ///< of the farthest boundary particle about the mass centre [m]

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

    /// Whether forces can move it in any way.
    bool yields() const { return free[0] || free[1] || free[2]; }
    /// Whether it moves or could: it yields, or has a velocity that it keeps.
    bool moves() const { return yields() || !velocity.isZero() || angular_velocity != 0; }

    /// x in the equation of motion [kg/m].
    double excess_mass() const { return std::max(0.0, added_mass - mass); }
    /// The same of rotation [kg m].
    double excess_inertia() const { return std::max(0.0, added_inertia - inertia); }

    /// Sets the slow loads by the fluid. The fast loads must be set after them.
    void set_slow_load(const BodyLoad& load, Vec2 gravity) {
        slow = load;
        slow_with_excess.force = load.force + excess_mass() * (acceleration - gravity);
        slow_with_excess.torque = load.torque + excess_inertia() * angular_acceleration;
    }

    /// Sets the fast loads by the fluid, and the accelerations that follow from all loads, those of contact
    /// included.
    void set_fast_load(const BodyLoad& load, Vec2 gravity) {
        force = load.force + slow.force;
        torque = load.torque + slow.torque;
        const Vec2 total_force = load.force + slow_with_excess.force + applied_force + contact.force;
        for (int k = 0; k < 2; ++k) {
            const bool moves = free[static_cast<std::size_t>(k)];
            acceleration[k] = moves ? total_force[k] / (mass + excess_mass()) + gravity[k] : 0;
        }
        const double total_torque = load.torque + slow_with_excess.torque + applied_torque + contact.torque;
        angular_acceleration = free[2] ? total_torque / (inertia + excess_inertia()) : 0;
    }

    /// Velocities and impulses over a time [s] under the present loads. The slow loads act over that time as
    /// often as their weight says.
    void kick(double duration, double slow_weight) {
        const double longer = (slow_weight - 1) * duration;
        const Vec2 linear_impulse = duration * force + longer * slow.force;
        const double torque_impulse = duration * torque + longer * slow.torque;
        Vec2 velocity_gain = duration * acceleration;
        for (int k = 0; k < 2; ++k) {
            const bool moves = free[static_cast<std::size_t>(k)];
            if (moves) velocity_gain[k] += longer * slow_with_excess.force[k] / (mass + excess_mass());
        }
        double rotation_gain = duration * angular_acceleration;
        if (free[2]) rotation_gain += longer * slow_with_excess.torque / (inertia + excess_inertia());
        work += linear_impulse.dot(velocity + 0.5 * velocity_gain) +
                torque_impulse * (angular_velocity + 0.5 * rotation_gain);
        velocity += velocity_gain;
        angular_velocity += rotation_gain;
        impulse += linear_impulse;
        angular_impulse += torque_impulse;
    }

    /// Position and angle over a time [s] at the present velocities.
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
    /// A speed that no boundary particle exceeds [m/s].
    double fastest() const { return velocity.norm() + radius * std::abs(angular_velocity); }
    /// Acceleration there: of the centre, of the rotation, and centripetal [m/s^2].
    Vec2 acceleration_at(Vec2 arm) const {
        return acceleration + angular_acceleration * Vec2(-arm.y(), arm.x()) -
               angular_velocity * angular_velocity * arm;
    }

    double kinetic_energy() const {  ///< [J/m]
        return 0.5 * (mass * velocity.squaredNorm() + inertia * angular_velocity * angular_velocity);
    }
};

/// Calls visit(number) for each number of a body that changes in time: the contents and order of a
/// checkpoint.
template <class Body, class Visit>
void for_each_number(Body& b, const Visit& visit) {
    const auto all = [&visit](auto&... numbers) { (visit(numbers), ...); };
    all(b.position.x(), b.position.y(), b.angle, b.velocity.x(), b.velocity.y(), b.angular_velocity);
    all(b.force.x(), b.force.y(), b.torque, b.acceleration.x(), b.acceleration.y(), b.angular_acceleration);
    all(b.impulse.x(), b.impulse.y(), b.angular_impulse, b.work);
    for (auto* load : {&b.slow, &b.slow_with_excess}) all(load->force.x(), load->force.y(), load->torque);
}

}  // namespace wetdeck
