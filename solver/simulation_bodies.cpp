// SPDX-License-Identifier: BSD-3-Clause
// The bodies' part of the time loop: loads, poses, what can go wrong.
#include <cmath>
#include <cstdio>

#include "solver/setup/lattice.hpp"
#include "solver/simulation.hpp"
#include "solver/time/stage_timer.hpp"

namespace wetdeck {

/// Water one spacing deep around each body: what follows its surface at once, see rigid_body.hpp.
void Simulation::attach_fluid() {
    const int layers = boundary_layers(kernel_.support_radius(), particle_spacing_);
    const double mass = model_.water.eos.reference_density * particle_spacing_ * particle_spacing_ / layers;
    for (RigidBody& body : bodies_) body.attached_mass = body.attached_inertia = 0;
    for (const BodyPoint& point : walls_.body_point) {
        RigidBody& body = bodies_[point.body];
        body.attached_mass += mass;
        body.attached_inertia += mass * (point.x * point.x + point.y * point.y);
    }
    for (RigidBody& body : bodies_) {  // as if it had fallen freely before: it would else take steps to begin
        for (int k = 0; k < 2; ++k) {
            if (body.free[static_cast<std::size_t>(k)] && body.attached_mass > body.mass)
                body.acceleration[k] = model_.gravity[k];
        }
    }
}

/// Forces of the fluid on the bodies, Eqs. (20)-(21), and the accelerations that follow. Those of the water
/// are kept between its steps.
void Simulation::load_bodies() {
    if (bodies_.empty()) return;
    const StageTimer timer(stages_.bodies);
    if (water_weight_ > 0) {
        sum_body_loads({true, false});
        for (std::size_t b = 0; b < bodies_.size(); ++b) bodies_[b].load_slow(body_loads_[b], model_.gravity);
    }
    if (fluid_.water < fluid_.size())
        sum_body_loads({false, true});
    else
        body_loads_.assign(bodies_.size(), {});
    for (std::size_t b = 0; b < bodies_.size(); ++b) bodies_[b].load_fast(body_loads_[b], model_.gravity);
}

/// Forces of these phases on each body, to body_loads_.
void Simulation::sum_body_loads(std::array<bool, phase_count> phases) {
    PassInput in = pass_input();
    in.loading = phases;
    loops_.body_forces(in);
    body_loads_.assign(bodies_.size(), {});
    for (std::size_t n = walls_.fixed; n < walls_.size(); ++n) {
        const std::uint32_t body = walls_.body_point[n - walls_.fixed].body;
        const Vec2 force(walls_.force_x[n], walls_.force_y[n]);
        const Vec2 arm = Vec2(walls_.state[n].x, walls_.state[n].y) - bodies_[body].position;
        body_loads_[body].force += force;
        body_loads_[body].torque += arm.x() * force.y() - arm.y() * force.x();
    }
}

/// Puts the boundary particles where the poses say, Eqs. (22)-(23).
void Simulation::place_bodies() {
    body_axes_.clear();
    for (const RigidBody& body : bodies_) body_axes_.push_back(body.axes());
    for (std::size_t n = walls_.fixed; n < walls_.size(); ++n) {
        const BodyPoint& point = walls_.body_point[n - walls_.fixed];
        const RigidBody& body = bodies_[point.body];
        const Eigen::Matrix2d& axes = body_axes_[point.body];
        const Vec2 arm = axes * Vec2(point.x, point.y), normal = axes * Vec2(point.nx, point.ny);
        const Vec2 place = body.position + arm, velocity = body.velocity_at(arm);
        const Vec2 acceleration = body.acceleration_at(arm);
        walls_.state[n] = {place.x(),  place.y(),  velocity.x(),     velocity.y(),
                           normal.x(), normal.y(), acceleration.x(), acceleration.y()};
    }
}

/// A body that is nowhere is not noticed by the fluid: nothing is near it.
std::optional<Instability> Simulation::body_trouble() const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const RigidBody& body = bodies_[b];
        const double fastest = body.fastest_within(body_radii_[b]);
        const bool in_tank =
            (body.position - domain_.low).minCoeff() > 0 && (domain_.high - body.position).minCoeff() > 0;
        if (in_tank && fastest < highest_mach_number * model_.water.eos.sound_speed) continue;
        char text[160];
        std::snprintf(text, sizeof text, "body %zu with speed %.4g m/s %s", b + 1, fastest,
                      in_tank ? "left the range of a body" : "left the tank");
        return Instability{time_, steps_ + 1, std::nullopt, body.position, text};
    }
    return std::nullopt;
}

}  // namespace wetdeck
