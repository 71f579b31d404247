// SPDX-License-Identifier: BSD-3-Clause
#include "solver/simulation.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "solver/bodies/contact.hpp"
#include "solver/core/errors.hpp"
#include "solver/physics/wetting.hpp"
#include "solver/setup/lattice.hpp"

namespace wetdeck {
namespace {

/// Throws unless each particle has a fineness between that of the coarsest and 1.
void check_finenesses(const SimulationSetup& setup) {
    if (!(setup.coarsest >= 1)) throw InputError("coarsest must be the largest spacing over the finest");
    if (setup.coarsest == 1) return;
    const double least = 1 / setup.coarsest * (1 - 1e-12);
    const auto good = [least](double fineness) { return fineness >= least && fineness <= 1; };
    const auto good_fluid = [&](const FluidState& p) { return good(p.fineness); };
    if (!std::all_of(setup.fluid.state.begin(), setup.fluid.state.end(), good_fluid) ||
        !std::all_of(setup.walls.fineness.begin(), setup.walls.fineness.end(), good))
        throw InputError("each particle needs a fineness between that of the coarsest spacing and 1");
}

/// Steps of the fine water in one of the coarse.
int coarse_substeps_of(const SimulationSetup& setup) {
    if (setup.coarsest == 1 || setup.fluid.water < setup.fluid.size()) return 1;
    std::vector<double> finenesses;
    for (const FluidState& p : setup.fluid.state) finenesses.push_back(p.fineness);
    return coarse_substeps(setup.model, finenesses);
}

/// The constants of a set-up, checked, with substeps and threads resolved.
RatesSetup checked(const SimulationSetup& setup) {
    const bool good = setup.particle_spacing > 0 && std::isfinite(setup.particle_spacing);
    if (!good) throw InputError("particle_spacing must be positive");
    if (setup.fluid.size() == 0) throw InputError("a simulation needs fluid particles");
    for (const RigidBody& body : setup.bodies) body.check();
    check_finenesses(setup);
    RatesSetup result{setup.model, setup.execution, setup.particle_spacing, setup.domain, setup.coarsest};
    if (setup.model.periodic_x && (!setup.bodies.empty() || setup.model.sponge_thickness > 0))
        throw InputError("a periodic domain can have neither bodies nor a sponge layer");
    if (setup.model.mirror_x && (setup.model.periodic_x || setup.model.contact.on()))
        throw InputError("half a domain can be neither periodic nor have contacts of bodies");
    if (setup.tank_motion.moves() && (setup.model.periodic_x || setup.model.sponge_thickness > 0))
        throw InputError("a tank that moves can be neither periodic nor have a sponge layer");
    const auto joined = [](const RigidBody& body) { return body.joined_to.has_value(); };
    if (setup.model.contact.on() && std::any_of(setup.bodies.begin(), setup.bodies.end(), joined))
        throw InputError("bodies that are joined have no contacts");
    const bool two_phase = setup.fluid.water > 0 && setup.fluid.water < setup.fluid.size();
    result.model.wall_wetting = wets_walls(setup.model, two_phase);
    result.model.air_substeps = two_phase ? air_substeps(setup.model) : 1;
    result.model.coarse_substeps = coarse_substeps_of(setup);
    if (result.execution.threads <= 0) result.execution.threads = omp_get_max_threads();
    return result;
}

Flow placed(SimulationSetup& setup) {
    Flow flow{std::move(setup.fluid), std::move(setup.walls), std::move(setup.bodies), 0,
              std::move(setup.tank_motion)};
    for (RigidBody& body : flow.bodies) body.start();
    join_bodies(flow);
    const double support = 2 * setup.model.smoothing_ratio * setup.particle_spacing;
    const int layers = boundary_layers(support, setup.particle_spacing);
    const double density = setup.model.water.eos.reference_density;
    // water one spacing deep around each body
    measure_bodies(flow, density * setup.particle_spacing * setup.particle_spacing / layers,
                   setup.model.gravity);
    sum_own_kernels(flow.walls, {0.5 * support}, setup.particle_spacing * setup.particle_spacing);
    return flow;
}

}  // namespace

Simulation::Simulation(SimulationSetup setup) : Simulation{checked(setup), placed(setup)} {}

Simulation::Simulation(const RatesSetup& setup, Flow flow)
    : flow_(std::move(flow)),
      rates_(setup, flow_),
      bounds_(setup.model, setup.domain, rates_.kernel().support_radius()) {
    place_walls(flow_, setup.model.gravity);
    rates_.build_list(flow_);
    rates_.update_density(flow_, 0, 1, {});
    evaluate();
}

void Simulation::evaluate() {
    const double all = substeps();
    rates_.forget_mixed_fluid();
    extremes_ = extremes_of(flow_.fluid, model());
    rates_.wall_means(flow_, all);
    rates_.density(flow_, all);
    rates_.momentum(flow_, all);
    rates_.body_loads(flow_, all);
    time_step_ = step_of(model(), stable_step());
}

TimeStep Simulation::stable_step() const {
    const TimeStep step = stable_time_step(model(), kernel().smoothing_length, extremes_, fluid().water > 0,
                                           fluid().water < fluid().size(), model().coarse_substeps);
    if (!model().contact.on()) return step;
    return with_contact(step, contact_frequency(bodies(), domain(), model().contact, particle_spacing()));
}

std::optional<Instability> Simulation::step(double longest) {
    for (RigidBody& body : flow_.bodies) body.release_at(flow_.time, model().gravity);
    time_step_ = step_of(model(), stable_step());
    const double begin = flow_.time, whole = std::min(longest, time_step_.size);
    if (model().dissipation_switch)
        rates_.mark_impacts(flow_, std::max(extremes_.fastest[0], extremes_.fastest[1]));
    std::optional<Instability> instability =
        advance(flow_, rates_, whole, substeps(), bounds_, extremes_, particle_steps_);
    if (instability) {
        rates_.bring_up(flow_);
        instability->time = flow_.time;
        instability->step = steps_ + 1;
    } else {
        flow_.time = begin + whole;  // not a sum, which might end just before the end
    }
    ++steps_;
    ++limits_[static_cast<std::size_t>(time_step_.criterion)];
    return instability;
}

std::optional<Instability> Simulation::run(double end, const Observer& observe,
                                           const StabilityMonitor& monitor,
                                           const StabilityMonitor& each_step) {
    constexpr std::uint64_t steps_between_checks = 64;
    observe(*this);
    while (flow_.time < end) {
        if (std::optional<Instability> instability = step(end - flow_.time)) return instability;
        const StageTimer timer(rates_.stages().probes);
        if (each_step) {
            if (std::optional<Instability> instability = each_step(*this)) return instability;
        }
        if (monitor && (steps_ % steps_between_checks == 0 || flow_.time >= end)) {
            if (std::optional<Instability> instability = monitor(*this)) return instability;
        }
        observe(*this);
    }
    return std::nullopt;
}

double Simulation::bytes_per_particle() const {
    const std::size_t of_walls = flow_.walls.size() * bytes_of_fields(flow_.walls) + rates_.bytes();
    return static_cast<double>(bytes_of_fields(flow_.fluid)) +
           static_cast<double>(of_walls) / static_cast<double>(flow_.fluid.size());
}

}  // namespace wetdeck
