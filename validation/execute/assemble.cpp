// SPDX-License-Identifier: BSD-3-Clause
#include "validation/execute/assemble.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/probes/energy.hpp"
#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "solver/setup/lattice.hpp"

namespace wetdeck {
namespace {

FluidParticles fill(const Scene& scene, double particle_spacing) {
    FluidParticles fluid;
    const Model& model = scene.model;
    for (const Box& box : scene.water_boxes) {
        fill_box(fluid, Phase::water, box, particle_spacing, model.water.eos.reference_density);
    }
    if (scene.air) {
        for (const Box& box : scene.air_boxes) {
            fill_box(fluid, Phase::air, box, particle_spacing, model.air.eos.reference_density);
        }
    }
    return fluid;
}

/// Gauge pressure at the start: the air weighs on the water, the water stands as the scene says.
double initial_gauge_pressure(const Scene& scene, Phase phase, Vec2 position) {
    const double g = -scene.model.gravity.y();
    const InitialPressure& initial = scene.initial;
    const double air_density = scene.air ? scene.model.air.eos.reference_density : 0;
    if (phase == Phase::air) return air_density * g * (scene.tank.high.y() - position.y());
    const double on_surface = air_density * g * (scene.tank.high.y() - initial.surface);
    const double density = scene.model.water.eos.reference_density;
    if (initial.law == InitialPressure::Law::greco) {
        return on_surface + greco_pressure(density, g, initial.surface, initial.released_face - position.x(),
                                           position.y());
    }
    return on_surface + density * g * (initial.surface - position.y());
}

}  // namespace

Simulation assemble(const Scene& scene, double particle_spacing, int threads) {
    Model model = scene.model;
    model.threads = threads;
    FluidParticles fluid = fill(scene, particle_spacing);
    set_initial_pressure(fluid, model, [&](Phase phase, Vec2 position) {
        return initial_gauge_pressure(scene, phase, position);
    });
    const double support = 2 * model.smoothing_ratio * particle_spacing;
    return {model, std::move(fluid), tank_walls(scene.tank, particle_spacing, support), particle_spacing,
            scene.tank};
}

void check_spacing(const Scene& scene, double particle_spacing) {
    constexpr double most_particles = 5e7;
    if (!(particle_spacing > 0) || !std::isfinite(particle_spacing)) {
        throw InputError(fmt::format("--dx is {}, expected a positive spacing [m]", particle_spacing));
    }
    const double particles =
        (scene.tank.high - scene.tank.low).prod() / (particle_spacing * particle_spacing);
    if (particles > most_particles) {
        throw InputError(
            fmt::format("particle spacing {} m would make {:.2g} particles, expected at most {:.2g}",
                        particle_spacing, particles, most_particles));
    }
    fill(scene, particle_spacing);
    Recorders(scene, particle_spacing);
}

Recorders::Recorders(const Scene& scene, double particle_spacing) {
    for (const ProbeSpec& spec : scene.probes) {
        switch (spec.type) {
            case ProbeSpec::Type::front:
                list_.push_back({spec.name, "m", "largest x that water reaches"});
                probes_.emplace_back(front_position);
                break;
            case ProbeSpec::Type::wall_pressure: {
                const WallPressureProbe probe(spec.centre, spec.diameter);
                probe.check(particle_spacing);
                list_.push_back(
                    {spec.name, "Pa",
                     fmt::format("gauge pressure, chord-weighted mean over a disc of {} m at ({}, {}) m; {}",
                                 spec.diameter, spec.centre.x(), spec.centre.y(), spec.note)});
                probes_.emplace_back([probe](const Simulation& s) { return probe.sample(s); });
                break;
            }
            case ProbeSpec::Type::water_depth:
                list_.push_back(
                    {spec.name, "m",
                     fmt::format("depth of water at x = {} m over a width of {} m", spec.x, spec.width)});
                probes_.emplace_back(
                    [spec](const Simulation& s) { return water_depth(s, spec.x, spec.width); });
                break;
        }
    }
    list_.insert(list_.end(), every_run_series().begin(), every_run_series().end());
}

void Recorders::sample(const Simulation& simulation, std::vector<double>& values) const {
    values.clear();
    for (const auto& probe : probes_) values.push_back(probe(simulation));
    const Balance b = balance(simulation);  // in the order of every_run_series()
    values.insert(values.end(),
                  {b.kinetic, b.potential, b.compression, b.momentum.x(), b.momentum.y(), b.mass,
                   b.water_density_error, static_cast<double>(b.outside), simulation.time_step().size});
}

}  // namespace wetdeck
