// SPDX-License-Identifier: BSD-3-Clause
#include "solver/time/verlet.hpp"

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

/// What a kick and a drift change of a particle in single precision.
void copy_motion(const FluidState& from, FixedPoint fixed_point, MixedState& to) {
    to.x = fixed_point.fixed(from.x);
    to.y = fixed_point.fixed(from.y);
    to.vx = static_cast<float>(from.vx);
    to.vy = static_cast<float>(from.vy);
}

/// The first half kick and half drift of all fluid and the bodies. Returns how far the fastest particle has
/// moved; it moves as far in the second half.
double kick_and_drift(Flow& flow, Rates& rates, double half, double substep_weight) {
    const StageTimer timer(rates.stages().integration);
    FluidParticles& fluid = flow.fluid;
    MixedFluid* const mixed = rates.mixed_fluid();
    MixedState* const copies = mixed ? mixed->data() : nullptr;
    const FixedPoint fixed_point = mixed ? mixed->fixed_point() : FixedPoint{};
    double fastest2 = 0;
    const auto size = static_cast<std::int64_t>(fluid.size());
#pragma omp parallel for schedule(static) num_threads(rates.setup().execution.threads) reduction(max \
                                                                                                 : fastest2)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        FluidState& p = fluid.state[i];
        p.vx += half * fluid.acceleration_x[i];
        p.vy += half * fluid.acceleration_y[i];
        p.x += half * p.vx;
        p.y += half * p.vy;
        fastest2 = std::max(fastest2, p.vx * p.vx + p.vy * p.vy);
        if (copies) copy_motion(p, fixed_point, copies[i]);
    }
    double fastest = std::sqrt(fastest2);
    flow.time += half;
    for (RigidBody& body : flow.bodies) {
        body.kick(half, substep_weight, flow.time);
        body.drift(half, flow.time);
        fastest = std::max(fastest, body.fastest());
    }
    place_walls(flow, rates.setup().model.gravity);
    return half * fastest;
}

/// The second half drift, with the densities at the end of the step. Returns how far the fastest guided body
/// has moved, which does not move at its velocity alone.
double update_and_drift(Flow& flow, Rates& rates, double dt, double substep_weight) {
    const StageTimer timer(rates.stages().integration);
    rates.update_density(flow, dt, substep_weight);
    flow.time += 0.5 * dt;
    double farthest = 0;
    for (RigidBody& body : flow.bodies) {
        const Vec2 position = body.position;
        const double angle = body.angle;
        body.drift(0.5 * dt, flow.time);
        if (body.guided())
            farthest = std::max(
                farthest, (body.position - position).norm() + body.radius * std::abs(body.angle - angle));
    }
    place_walls(flow, rates.setup().model.gravity);
    return farthest;
}

/// The last half kick, which finds the extremes and the first particle out of range. (After a new list the
/// rates stand in the old order, and another particle may be named.)
std::optional<Instability> last_kick(Flow& flow, Rates& rates, const Substep& substep,
                                     const StabilityBounds& bounds, Extremes& extremes) {
    const StageTimer timer(rates.stages().integration);
    FluidParticles& fluid = flow.fluid;
    const double slow_weight = substep.last() ? substep.count : 0;
    for (RigidBody& body : flow.bodies) body.kick(0.5 * substep.dt, slow_weight, flow.time);
    carry_joined_bodies(flow.bodies);
    const auto size = static_cast<std::int64_t>(fluid.size());
    double fastest_water = 0, fastest_air = 0, densest_water = 1, densest_air = 1;
    std::int64_t first_bad = size;
#pragma omp parallel for schedule(static) num_threads(rates.setup().execution.threads) \
    reduction(max                                                                      \
              : fastest_water, fastest_air, densest_water, densest_air) reduction(min  \
                                                                                  : first_bad)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        FluidState& p = fluid.state[i];
        p.vx += 0.5 * substep.dt * fluid.acceleration_x[i];
        p.vy += 0.5 * substep.dt * fluid.acceleration_y[i];
        const bool water = i < fluid.water;
        double& fastest = water ? fastest_water : fastest_air;
        fastest = std::max(fastest, p.vx * p.vx + p.vy * p.vy);
        double& densest = water ? densest_water : densest_air;
        densest = std::max(densest, p.density / bounds.reference_densities()[water ? 0 : 1]);
        if (!bounds.hold(p, fluid.density_rate[i], fluid.phase(i))) first_bad = std::min(first_bad, n);
    }
    extremes = {{std::sqrt(fastest_water), std::sqrt(fastest_air)}, {densest_water, densest_air}};
    if (first_bad == size) return bounds.of_bodies(flow.bodies);
    return bounds.instability_of(fluid, static_cast<std::size_t>(first_bad));
}

}  // namespace

Extremes extremes_of(const FluidParticles& fluid, const Model& model) {
    Extremes extremes;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const auto phase = static_cast<std::size_t>(fluid.phase(i));
        const Material& material = phase == 0 ? model.water : model.air;
        extremes.fastest[phase] = std::max(extremes.fastest[phase], fluid.state[i].velocity().norm());
        extremes.densest[phase] =
            std::max(extremes.densest[phase], fluid.state[i].density / material.eos.reference_density);
    }
    return extremes;
}

std::optional<Instability> advance(Flow& flow, Rates& rates, const Substep& substep,
                                   const StabilityBounds& bounds, Extremes& extremes) {
    const double all = substep.count;
    const double before = substep.number == 0 ? all : 0;  // weight of the rates that the last step left
    const double middle = substep.middle() ? all : 0, after = substep.last() ? all : 0;
    const double moved = kick_and_drift(flow, rates, 0.5 * substep.dt, before);
    rates.refresh_list(flow, moved);
    if (rates.means_in_density(middle)) rates.wall_means(flow, middle);
    rates.density(flow, middle);
    const double moved_by_guide = update_and_drift(flow, rates, substep.dt, middle);
    rates.refresh_list(flow, std::max(moved, moved_by_guide));
    rates.wall_means(flow, after);
    rates.momentum(flow, after);
    rates.body_loads(flow, after, 0.5 * substep.dt);
    return last_kick(flow, rates, substep, bounds, extremes);
}

}  // namespace wetdeck
