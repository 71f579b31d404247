// SPDX-License-Identifier: BSD-3-Clause
// A rigid body in the plane: three degrees of freedom, each moved by forces or kept at its velocity, Yang et
// al. (2020), Eqs. (4)-(5) and (20)-(23):
//
//     M dv/dt = F + M g + F_applied,   I domega/dt = T + T_applied
//
// Loads come in two parts: the slow loads, of the slow fluid, act in the first and the last of the short
// steps that make a long one, with the weight of all of them; the fast loads, of the fast fluid, act in each
// (see time/verlet.hpp).
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
// A degree of freedom may follow a given motion instead, and is released from it at a time or at the first
// contact with water. A body on a hinge P turns about it, with r from P to the mass centre and a_P given:
//
//     (I + M r^2) domega/dt = T + T_applied + r x (F + F_applied + M (g - a_P)).
//
// The pose is integrated, never the particles of the surface: they are placed from it, so that nothing
// drifts.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "solver/bodies/motion.hpp"
#include "solver/bodies/spring.hpp"
#include "solver/core/vec2.hpp"

namespace wetdeck {

/// Force and torque on a body.
struct BodyLoad {
    Vec2 force = Vec2::Zero();  ///< [N/m]
    double torque = 0;          ///< about the mass centre [N]
};

/// What moves a body besides forces.
struct Guide {
    std::array<Motion, 3> motion;  ///< x, y, rotation: displacement from the start; none: see RigidBody::free
    std::optional<Vec2> pivot;  ///< hinge, in the body's frame: it stays, or moves as given for x and y [m]
    double release_time = 0;    ///< of the free degrees of freedom; infinite: until it is set [s]
    Vec2 start = Vec2::Zero();  ///< of the mass centre [m]
    double start_angle = 0;     ///< [rad]
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
    bool in_fast_water = false;      ///< whether that water is fast, else slow
    double added_inertia = 0;        ///< of the same, about the mass centre [kg m]
    std::vector<Vec2> corners = {};  ///< of the outline, in the body's frame [m]; only contact needs them
    double radius = 0;               ///< of the farthest boundary particle of it and what is joined to it [m]
    bool held = false;               ///< until its release: no force moves it

    Vec2 impulse = Vec2::Zero();  ///< time integral of `force` since the start [N s/m]
    double angular_impulse = 0;   ///< time integral of `torque` [N s]
    double work = 0;              ///< of the fluid on the body since the start [J/m]

    std::optional<std::size_t> joined_to;  ///< number of the body before it to which it is fixed, if any
    Vec2 joint = Vec2::Zero();             ///< its mass centre in the frame of that body [m]
    double joint_angle = 0;                ///< its angle less that of that body [rad]
    Guide guide;                           ///< what moves it besides forces
    std::vector<Spring> springs;           ///< between it and the earth
    BodyLoad restraint;                    ///< by the springs, of the last evaluation

    /// Throws InputError if it is free to move without mass or inertia, if a motion is given and free with
    /// no release, or if a hinged body is free along x or y.
    void check() const;

    /// Whether forces can move it in any way, at once or later.
    bool yields() const { return free[0] || free[1] || free[2]; }
    /// Whether it moves or could: it yields, has a velocity that it keeps, or is guided.
    bool moves() const;

    /// x in the equation of motion [kg/m].
    double excess_mass() const { return guide.pivot ? 0 : std::max(0.0, added_mass - mass); }
    /// The same of rotation [kg m].
    double excess_inertia() const { return std::max(0.0, added_inertia - turning_inertia()); }
    /// About the point about which it turns: the hinge or the mass centre [kg m].
    double turning_inertia() const {
        return guide.pivot ? inertia + mass * guide.pivot->squaredNorm() : inertia;
    }
    /// The hinge or the mass centre, in the scene [m].
    Vec2 turning_point() const { return guide.pivot ? Vec2(position - arm_of_centre()) : position; }
    /// From the hinge to the mass centre, in the scene; zero without a hinge [m].
    Vec2 arm_of_centre() const { return guide.pivot ? Vec2(-(axes() * *guide.pivot)) : Vec2(0, 0); }

    /// Notes where it is as the start of its guided motion, and takes the velocity that is given there.
    void start();
    /// Whether forces move this degree of freedom now: x, y, rotation.
    bool forced(int k) const { return free[static_cast<std::size_t>(k)] && !held; }
    /// Whether it follows a given motion now: x, y, rotation.
    bool guided(int k) const { return motion_of(k) && !forced(k); }
    /// Whether any degree of freedom does, or it is on a hinge.
    bool guided() const { return guide.pivot || guided(0) || guided(1) || guided(2); }
    /// The motion that is given for x, y or rotation, if any; with a hinge, that of the hinge.
    const Motion& motion_of(int k) const { return guide.motion[static_cast<std::size_t>(k)]; }
    /// Lets go of the free degrees of freedom when it is time [s]. Those of bodies that are lighter than
    /// their added mass begin at `gravity`, which they would else take steps to reach.
    void release_at(double time, Vec2 gravity);

    /// Sets the loads of the springs.
    /// @param remaining  time from the present velocities to those at the present pose [s]
    void set_restraint(double remaining);
    /// Sets the slow loads by the fluid. The fast loads must be set after them.
    void set_slow_load(const BodyLoad& load, Vec2 gravity);
    /// Sets the fast loads by the fluid, and the accelerations that follow from all loads, those of contact
    /// and springs included.
    /// @param gravity  with the forces of a moving tank [m/s^2]
    /// @param time     of the pose [s]
    /// @param spin     angular acceleration of a moving tank [rad/s^2]
    void set_fast_load(const BodyLoad& load, Vec2 gravity, double time = 0, double spin = 0);

    /// Velocities and impulses over a time [s] under the present loads. The slow loads act over that time as
    /// often as their weight says.
    /// @param time  to which the velocities lead [s]
    void kick(double duration, double slow_weight, double time = 0);
    /// Position and angle over a time [s] at the present velocities, up to `time` [s].
    void drift(double duration, double time = 0);

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

  private:
    /// A load of water, plus x (a_last - g).
    BodyLoad with_excess(const BodyLoad& load, Vec2 gravity) const;
    void place_on_hinge(double time);
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
