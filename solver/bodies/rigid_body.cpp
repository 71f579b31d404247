// SPDX-License-Identifier: BSD-3-Clause
#include "solver/bodies/rigid_body.hpp"

#include "solver/core/cross.hpp"
#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

Vec2 turned(Vec2 arm) {
    return {-arm.y(), arm.x()};
}

MotionState given(const Motion& motion, double time) {
    return motion ? motion(time) : MotionState{};
}

}  // namespace

void RigidBody::check() const {
    const bool translates = free[0] || free[1];
    if (translates && !(mass > 0)) throw InputError("a body that is free to move needs a positive mass");
    if (free[2] && !(inertia > 0)) throw InputError("a body that is free to turn needs a positive inertia");
    if (guide.pivot && translates) throw InputError("a body on a hinge is not free along x or y");
    if (joined_to && (yields() || guided()))
        throw InputError("a body that is joined to another one moves with it alone");
    for (std::size_t k = 0; k < 3; ++k)
        if (guide.motion[k] && free[k] && !(guide.release_time > 0))
            throw InputError("a motion is given for a degree of freedom that is free from the start");
}

bool RigidBody::moves() const {
    const auto is_given = [](const Motion& motion) { return static_cast<bool>(motion); };
    return yields() || joined_to || !velocity.isZero() || angular_velocity != 0 ||
           std::any_of(guide.motion.begin(), guide.motion.end(), is_given);
}

void RigidBody::start() {
    guide.start = position;
    guide.start_angle = angle;
    held = guide.release_time > 0;
    if (guided(2)) angular_velocity = guide.motion[2](0).velocity;
    if (guide.pivot) return place_on_hinge(0);
    for (int k = 0; k < 2; ++k)
        if (guided(k)) velocity[k] = motion_of(k)(0).velocity;
}

void RigidBody::release_at(double time, Vec2 gravity) {
    if (!held || time < guide.release_time) return;
    held = false;
    for (int k = 0; k < 2; ++k)
        if (forced(k) && added_mass > mass) acceleration[k] = gravity[k];
}

void RigidBody::set_restraint(double remaining) {
    restraint = {};
    for (const Spring& spring : springs) {
        const BodyLoad load = spring.load(*this, velocity + remaining * acceleration,
                                          angular_velocity + remaining * angular_acceleration);
        restraint.force += load.force;
        restraint.torque += load.torque;
    }
}

BodyLoad RigidBody::with_excess(const BodyLoad& load, Vec2 gravity) const {
    return {load.force + excess_mass() * (acceleration - gravity),
            load.torque + excess_inertia() * angular_acceleration};
}

void RigidBody::set_slow_load(const BodyLoad& load, Vec2 gravity) {
    slow = load;
    slow_with_excess = in_fast_water ? load : with_excess(load, gravity);
}

void RigidBody::set_fast_load(const BodyLoad& load, Vec2 gravity, double time, double spin) {
    force = load.force + slow.force;
    torque = load.torque + slow.torque;
    const BodyLoad fast = in_fast_water ? with_excess(load, gravity) : load;
    const Vec2 total_force =
        fast.force + slow_with_excess.force + applied_force + contact.force + restraint.force;
    for (int k = 0; k < 2; ++k) {
        acceleration[k] = forced(k) ? total_force[k] / (mass + excess_mass()) + gravity[k]
                                    : given(motion_of(k), time).acceleration;
    }
    double total_torque =
        fast.torque + slow_with_excess.torque + applied_torque + contact.torque + restraint.torque;
    const Vec2 arm = arm_of_centre();
    if (guide.pivot) total_torque += cross(arm, total_force + mass * (gravity - acceleration));
    angular_acceleration = forced(2) ? total_torque / (turning_inertia() + excess_inertia()) - spin
                                     : given(motion_of(2), time).acceleration;
    if (guide.pivot)
        acceleration += angular_acceleration * turned(arm) - angular_velocity * angular_velocity * arm;
}

void RigidBody::kick(double duration, double slow_weight, double time) {
    const double longer = (slow_weight - 1) * duration;
    const Vec2 linear_impulse = duration * force + longer * slow.force;
    const double torque_impulse = duration * torque + longer * slow.torque;
    const Vec2 arm = arm_of_centre();
    double rotation_gain = duration * angular_acceleration;
    if (forced(2)) {
        double slow_torque = slow_with_excess.torque;
        if (guide.pivot) slow_torque += cross(arm, slow_with_excess.force);
        rotation_gain += longer * slow_torque / (turning_inertia() + excess_inertia());
    } else {
        rotation_gain = guided(2) ? guide.motion[2](time).velocity - angular_velocity : 0;
    }
    Vec2 velocity_gain = duration * acceleration;
    for (int k = 0; k < 2; ++k) {
        if (forced(k)) {
            velocity_gain[k] += longer * slow_with_excess.force[k] / (mass + excess_mass());
        } else if (guided(k) || guide.pivot) {
            const double of_arm = guide.pivot ? ((angular_velocity + rotation_gain) * turned(arm))[k] : 0;
            velocity_gain[k] = given(motion_of(k), time).velocity + of_arm - velocity[k];
        } else {
            velocity_gain[k] = 0;
        }
    }
    work += linear_impulse.dot(velocity + 0.5 * velocity_gain) +
            torque_impulse * (angular_velocity + 0.5 * rotation_gain);
    velocity += velocity_gain;
    angular_velocity += rotation_gain;
    impulse += linear_impulse;
    angular_impulse += torque_impulse;
}

void RigidBody::drift(double duration, double time) {
    position += duration * velocity;
    angle += duration * angular_velocity;
    if (guided(2)) angle = guide.start_angle + guide.motion[2](time).displacement;
    if (guide.pivot) return place_on_hinge(time);
    for (int k = 0; k < 2; ++k)
        if (guided(k)) position[k] = guide.start[k] + motion_of(k)(time).displacement;
}

void RigidBody::place_on_hinge(double time) {
    const Vec2 arm = arm_of_centre();
    const Vec2 hinge_at_start = guide.start + Eigen::Rotation2Dd(guide.start_angle) * *guide.pivot;
    for (int k = 0; k < 2; ++k) {
        const MotionState hinge = given(motion_of(k), time);
        position[k] = hinge_at_start[k] + hinge.displacement + arm[k];
        velocity[k] = hinge.velocity + (angular_velocity * turned(arm))[k];
    }
}

}  // namespace wetdeck
