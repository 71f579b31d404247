// SPDX-License-Identifier: BSD-3-Clause
#include "solver/time/verlet.hpp"

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

/// One step of the fast fluid among those that make a step of the slow one.
struct Substep {
    double dt = 0;   ///< [s]
    int number = 0;  ///< from 0
    int count = 1;   ///< m

    bool middle() const { return number == count / 2; }  ///< whether it compresses the slow fluid
    bool last() const { return number == count - 1; }    ///< whether it ends the step of the slow fluid
};

/// The largest speed and the first particle out of range that the threads have met.
Met met_by_all(const std::vector<Met>& met) {
    Met all;
    for (const Met& of_thread : met) all.join(of_thread);
    return all;
}

/// The first half kick and half drift of the fluid. Within a step of the slow fluid the last half kick of the
/// step before comes first (`with_last_kick`): one sweep in the place of two.
template <bool with_last_kick>
Met kick_and_drift_fluid(Flow& flow, Rates& rates, const Substep& substep, const StabilityBounds* bounds) {
    FluidParticles& fluid = flow.fluid;
    MixedFluid* const mixed = rates.mixed_fluid();
    MixedState* const copies = mixed ? mixed->data() : nullptr;
    const FixedPoint fixed_point = mixed ? mixed->fixed_point() : FixedPoint{};
    std::vector<Met>& met = rates.met();
    const ClusterSweep sweep = rates.sweep(0.5 * substep.dt, substep.number == 0 || substep.middle());
    rates.clusters().for_each([&](const Cluster& cluster, int thread) {
        if (sweep.leaves_out(cluster)) return;
        // locals: a number of a particle might be one of those beyond the loop
        const double kick = 0.5 * substep.dt, drift = sweep.drift_of(cluster);
        const double *const ax = fluid.acceleration_x.data(), *const ay = fluid.acceleration_y.data(),
                            *const rate = fluid.density_rate.data();
        FluidState* const state = fluid.state.data();
        const auto half_kick = [kick, ax, ay](FluidState& p, std::size_t i) {
            p.vx += kick * ax[i];
            p.vy += kick * ay[i];
        };
        double fastest2 = 0;
        std::size_t first_bad = Met::nobody;
        for (std::size_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
            FluidState& p = state[i];
            if constexpr (with_last_kick) {
                half_kick(p, i);
                if (!bounds->hold(p, rate[i], cluster.phase)) [[unlikely]]
                    first_bad = std::min(first_bad, i);
            }
            half_kick(p, i);
            p.x += drift * p.vx;
            p.y += drift * p.vy;
            fastest2 = std::max(fastest2, p.vx * p.vx + p.vy * p.vy);
            if (copies) copy_motion(p, fixed_point, copies[i]);
        }
        Met& own = met[static_cast<std::size_t>(thread)];
        own.fastest2[0] = std::max(own.fastest2[0], fastest2);
        own.first_bad = std::min(own.first_bad, first_bad);
    });
    return met_by_all(met);
}

/// The same of the bodies. Returns how far the fastest particle of fluid or body has moved; it moves as far
/// in the second half.
double kick_and_drift_bodies(Flow& flow, Rates& rates, const Substep& substep, const Met& fluid) {
    const double half = 0.5 * substep.dt;
    const double substep_weight = substep.number == 0 ? substep.count : 0;  // of the rates that are left
    double fastest = rates.fastest_of_step(std::sqrt(fluid.fastest2[0]), substep.number == 0);
    flow.time += half;
    for (RigidBody& body : flow.bodies) {
        body.kick(half, substep_weight, flow.time);
        body.drift(half, flow.time);
        fastest = std::max(fastest, body.fastest());
    }
    place_walls(flow, rates.setup().model.gravity);
    return half * fastest;
}

/// The first half kick and half drift of a step of the slow fluid. Returns how far the fastest has moved.
double kick_and_drift(Flow& flow, Rates& rates, const Substep& substep) {
    const StageTimer timer(rates.stages().integration);
    return kick_and_drift_bodies(flow, rates, substep,
                                 kick_and_drift_fluid<false>(flow, rates, substep, nullptr));
}

void last_kick_of_bodies(Flow& flow, const Substep& substep) {
    const double slow_weight = substep.last() ? substep.count : 0;
    for (RigidBody& body : flow.bodies) body.kick(0.5 * substep.dt, slow_weight, flow.time);
    carry_joined_bodies(flow.bodies);
}

/// The second half drift, with the densities at the end of the step. Returns how far the fastest guided body
/// has moved, which does not move at its velocity alone.
double update_and_drift(Flow& flow, Rates& rates, const Substep& substep) {
    const StageTimer timer(rates.stages().integration);
    const double half = 0.5 * substep.dt, weight = substep.middle() ? substep.count : 0;
    rates.update_density(flow, substep.dt, weight, rates.sweep(half, substep.middle() || substep.last()));
    flow.time += half;
    double farthest = 0;
    for (RigidBody& body : flow.bodies) {
        const Vec2 position = body.position;
        const double angle = body.angle;
        body.drift(0.5 * substep.dt, flow.time);
        if (body.guided())
            farthest = std::max(
                farthest, (body.position - position).norm() + body.radius * std::abs(body.angle - angle));
    }
    place_walls(flow, rates.setup().model.gravity);
    return farthest;
}

/// The first particle or body out of range. (After a new list the rates stand in the old order, and another
/// particle may be named.)
std::optional<Instability> out_of_range(const Flow& flow, const StabilityBounds& bounds, const Met& met) {
    if (met.first_bad == Met::nobody) return bounds.of_bodies(flow.bodies);
    return bounds.instability_of(flow.fluid, met.first_bad);
}

/// The last half kick of a step of the fast fluid, and what begins the next one within the step of the slow.
/// @param moved  set to how far the fastest has moved
std::optional<Instability> kick_into_next(Flow& flow, Rates& rates, Substep& substep,
                                          const StabilityBounds& bounds, double& moved) {
    const StageTimer timer(rates.stages().integration);
    last_kick_of_bodies(flow, substep);
    ++substep.number;
    const Met met = kick_and_drift_fluid<true>(flow, rates, substep, &bounds);
    if (auto instability = out_of_range(flow, bounds, met)) return instability;
    moved = kick_and_drift_bodies(flow, rates, substep, met);
    return {};
}

/// The last half kick of a step of the slow fluid, which finds the extremes.
std::optional<Instability> last_kick(Flow& flow, Rates& rates, const Substep& substep,
                                     const StabilityBounds& bounds, Extremes& extremes) {
    const StageTimer timer(rates.stages().integration);
    FluidParticles& fluid = flow.fluid;
    last_kick_of_bodies(flow, substep);
    std::vector<Met>& met = rates.met();
    rates.clusters().for_each([&](const Cluster& cluster, int thread) {
        const auto phase = static_cast<std::size_t>(cluster.phase);
        const double half = 0.5 * substep.dt;
        const StabilityBounds own_bounds = bounds;
        const double *const ax = fluid.acceleration_x.data(), *const ay = fluid.acceleration_y.data(),
                            *const rate = fluid.density_rate.data();
        FluidState* const state = fluid.state.data();
        double fastest2 = 0, densest = 0;
        const std::size_t end = cluster.first + cluster.count;
        bool sound = true;
        for (std::size_t i = cluster.first; i < end; ++i) {
            FluidState& p = state[i];
            p.vx += half * ax[i];
            p.vy += half * ay[i];
            fastest2 = std::max(fastest2, p.vx * p.vx + p.vy * p.vy);
            densest = std::max(densest, p.density);
            sound &= own_bounds.hold(p, rate[i], cluster.phase);
        }
        Met& own = met[static_cast<std::size_t>(thread)];
        own.fastest2[phase] = std::max(own.fastest2[phase], fastest2);
        own.densest[phase] = std::max(own.densest[phase], densest);
        for (std::size_t i = end; !sound && i-- > cluster.first;)
            if (!bounds.hold(state[i], rate[i], cluster.phase)) own.first_bad = std::min(own.first_bad, i);
    });
    const Met all = met_by_all(met);
    for (std::size_t k = 0; k < phase_count; ++k) {
        extremes.fastest[k] = std::sqrt(all.fastest2[k]);
        extremes.densest[k] = std::max(1.0, all.densest[k] / bounds.reference_densities()[k]);
    }
    return out_of_range(flow, bounds, all);
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

std::optional<Instability> advance(Flow& flow, Rates& rates, double step, int substeps,
                                   const StabilityBounds& bounds, Extremes& extremes,
                                   std::uint64_t& particle_steps) {
    Substep substep{step / substeps, 0, substeps};
    double moved = kick_and_drift(flow, rates, substep);
    for (;;) {
        const double all = substep.count;
        const double middle = substep.middle() ? all : 0, after = substep.last() ? all : 0;
        rates.refresh_list(flow, moved);
        if (rates.means_in_density(middle)) rates.wall_means(flow, middle);
        rates.density(flow, middle);
        const double moved_by_guide = update_and_drift(flow, rates, substep);
        rates.refresh_list(flow, std::max(moved, moved_by_guide));
        rates.wall_means(flow, after);
        rates.momentum(flow, after);
        rates.body_loads(flow, after, 0.5 * substep.dt);
        particle_steps += substep.last() ? flow.fluid.size() : rates.summed_in_each_step();
        if (substep.last()) return last_kick(flow, rates, substep, bounds, extremes);
        if (auto instability = kick_into_next(flow, rates, substep, bounds, moved)) return instability;
    }
}

}  // namespace wetdeck
