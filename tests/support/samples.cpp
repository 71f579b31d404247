// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "solver/core/errors.hpp"
#include "solver/setup/graded_lattice.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "solver/setup/lattice.hpp"

namespace wetdeck::samples {
namespace {

void shake(Setup& setup, Dice& dice) {
    for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
        FluidState& p = setup.fluid.state[i];
        p.x += dice.symmetric(0.3 * setup.particle_spacing);
        p.y += dice.symmetric(0.3 * setup.particle_spacing);
        p.vx = dice.symmetric(2);
        p.vy = dice.symmetric(2);
        p.density *= 1 + dice.symmetric(setup.fluid.phase(i) == Phase::water ? 0.01 : 0.1);
        p.impact = dice.symmetric(1) > 0.5 ? 1 : 0;
    }
    for (WallState& w : setup.walls.state) {
        w.vx = dice.symmetric(0.5);
        w.vy = dice.symmetric(0.5);
        w.ax = dice.symmetric(5);
        w.ay = dice.symmetric(5);
    }
}

}  // namespace

Model two_phase_model() {
    Model model;
    model.water.eos = {1000, 30, 7, 1000};
    model.water.viscosity = 0;
    model.air.eos = {1, 90, 1.4, 1000};
    model.air.viscosity = 0;
    model.gravity = {0, -9.81};
    model.velocity_mean = Mean::impedance_weighted;
    model.pressure_mean = Mean::impedance_weighted;
    model.pressure_diffusion = 1;
    model.hydrostatic_correction = true;
    model.dissipation = Dissipation::low_dissipation;
    model.dissipation_slope = 3;
    model.air_dissipation = 0.1;
    model.viscosity = Viscosity::none;
    model.dissipation_switch = false;
    model.wall_slip = WallSlip::free;
    model.wall_pressure = WallPressure::shepard_water;
    model.wall_velocity = WallVelocity::mirrored;
    model.wall_dissipation = 3;
    model.sponge_thickness = 0;
    model.negative_pressure = true;
    model.smoothing_ratio = 1.25;
    model.air_substeps = 1;
    model.courant_number = 0.5;
    return model;
}

Model paper_model() {
    Model model = two_phase_model();
    model.velocity_mean = Mean::harmonic;
    model.pressure_mean = Mean::harmonic;
    model.impedance_mean = ImpedanceMean::harmonic;
    model.hydrostatic_correction = false;
    model.dissipation = Dissipation::none;
    model.viscosity = Viscosity::approaching;
    model.water.viscosity = 1e-3;
    model.air.viscosity = 1e-5;
    model.dissipation_switch = true;
    model.wall_pressure = WallPressure::shepard;
    model.wall_velocity = WallVelocity::normal;
    model.wall_dissipation = 0;
    model.courant_number = 0.25;
    model.full_kernel_sum = 0;
    model.wall_wetting = false;
    return model;
}

Setup shaken_tank(const Model& model, std::uint64_t seed, double particle_spacing) {
    Setup setup(model, {{0, 0}, {1.0, 0.8}}, particle_spacing, true);
    setup.fill(Phase::water, {{0, 0}, {0.5, 0.5}});
    setup.fill(Phase::air, {{0.5, 0}, {1.0, 0.5}});
    setup.fill(Phase::air, {{0, 0.5}, {1.0, 0.8}});
    Dice dice(seed);
    shake(setup, dice);
    return setup;
}

Setup shaken_blob(const Model& model, std::uint64_t seed, double particle_spacing) {
    Setup setup(model, {{-2, -2}, {2, 2}}, particle_spacing);
    const double dx = particle_spacing;
    for (const Phase phase : {Phase::water, Phase::air}) {
        const double density = (phase == Phase::water ? model.water : model.air).eos.reference_density;
        for (double x = -0.25 + 0.5 * dx; x < 0.25; x += dx) {
            for (double y = -0.25 + 0.5 * dx; y < 0.25; y += dx) {
                const double radius = std::hypot(x, y);
                const bool of_phase = phase == Phase::water ? radius < 0.15 : radius >= 0.15 && radius < 0.25;
                if (of_phase) setup.fluid.add(phase, {x, y}, density * dx * dx, density);
            }
        }
    }
    Dice dice(seed);
    shake(setup, dice);
    return setup;
}

namespace {

/// Water below air in a tank, finest in a box.
Setup graded_layers(const Model& model, std::uint64_t seed, double width, Box finest) {
    Setup setup(model, {{0, 0}, {width, 1.5}}, 0.025);
    const Grading grading{finest, setup.particle_spacing, 0.1, 4};
    std::vector<Box> all;
    for (const Phase phase : {Phase::water, Phase::air}) {
        const double density = (phase == Phase::water ? model.water : model.air).eos.reference_density;
        const Box layer = phase == Phase::water ? Box{{0, 0}, {width, 0.8}} : Box{{0, 0.8}, {width, 1.5}};
        const std::vector<Box> cells = graded_cells(layer, grading);
        fill_cells(setup.fluid, phase, cells, setup.particle_spacing, density);
        all.insert(all.end(), cells.begin(), cells.end());
    }
    setup.walls = graded_tank_walls(setup.domain, all, setup.particle_spacing, 3);
    std::vector<double> fineness;
    for (const FluidState& p : setup.fluid.state) fineness.push_back(p.fineness);
    Dice dice(seed);
    shake(setup, dice);
    for (std::size_t i = 0; i < fineness.size(); ++i) setup.fluid.state[i].fineness = fineness[i];
    setup.coarsest = coarsest_over_finest(setup.fluid, setup.walls);
    return setup;
}

}  // namespace

Setup graded_tank(const Model& model, std::uint64_t seed) {
    return graded_layers(model, seed, 2, {{0.8, 0.6}, {1.2, 0.9}});
}

Setup graded_water(const Model& model, std::uint64_t seed) {
    Setup setup = graded_layers(model, seed, 3, {{0.2, 0.6}, {0.6, 0.9}});
    FluidParticles water;
    for (std::size_t i = 0; i < setup.fluid.water; ++i) {
        const FluidState& p = setup.fluid.state[i];
        water.add(Phase::water, p.position(), setup.fluid.mass[i], p.density, p.fineness);
        water.state.back() = p;
    }
    setup.fluid = std::move(water);
    return setup;
}

Setup dam_break(const Model& model, Vec2 column, Vec2 tank, double particle_spacing, bool with_air) {
    Setup setup(model, {{0, 0}, tank}, particle_spacing, true);
    const auto fill = [&](Phase phase, Box box) {
        if (((box.high - box.low).array() >= 0.5 * particle_spacing).all()) setup.fill(phase, box);
    };
    fill(Phase::water, {{0, 0}, column});
    if (with_air) {
        fill(Phase::air, {{column.x(), 0}, {tank.x(), column.y()}});
        fill(Phase::air, {{0, column.y()}, tank});
    }
    set_initial_pressure(setup.fluid, model, [&](Phase phase, Vec2 position) {
        const double density = (phase == Phase::water ? model.water : model.air).eos.reference_density;
        return density * model.gravity.norm() * (column.y() - position.y());
    });
    return setup;
}

std::vector<FluidState> by_id(const FluidParticles& fluid) {
    std::vector<FluidState> states(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i) states[fluid.id[i]] = fluid.state[i];
    return states;
}

std::vector<std::array<double, 3>> rates_by_id(const FluidParticles& fluid) {
    std::vector<std::array<double, 3>> rates(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        rates[fluid.id[i]] = {fluid.density_rate[i], fluid.acceleration_x[i], fluid.acceleration_y[i]};
    }
    return rates;
}

double rate_difference(const Simulation& a, const Simulation& b) {
    const auto left = rates_by_id(a.fluid()), right = rates_by_id(b.fluid());
    std::array<std::array<double, 2>, phase_count> difference{}, scale{};
    for (std::size_t i = 0; i < a.fluid().size(); ++i) {
        const auto& l = left[a.fluid().id[i]];
        const auto& r = right[a.fluid().id[i]];
        const auto phase = static_cast<std::size_t>(a.fluid().phase(i));
        difference[phase][0] = std::max(difference[phase][0], std::abs(l[0] - r[0]));
        scale[phase][0] = std::max(scale[phase][0], std::abs(l[0]));
        difference[phase][1] = std::max(difference[phase][1], std::hypot(l[1] - r[1], l[2] - r[2]));
        scale[phase][1] = std::max(scale[phase][1], std::hypot(l[1], l[2]));
    }
    double worst = 0;
    for (std::size_t phase = 0; phase < phase_count; ++phase) {
        for (std::size_t kind = 0; kind < 2; ++kind) {
            if (scale[phase][kind] > 0) worst = std::max(worst, difference[phase][kind] / scale[phase][kind]);
        }
    }
    return worst;
}

ChosenInstructionSet::ChosenInstructionSet(const std::string& name) {
    ::setenv("WETDECK_SIMD", name.c_str(), 1);
}
ChosenInstructionSet::~ChosenInstructionSet() {
    ::unsetenv("WETDECK_SIMD");
}

std::vector<std::string> instruction_sets() {
    std::vector<std::string> supported;
    for (const char* name : {"sse2", "avx2", "avx512"}) {
        try {
            pair_passes(two_phase_model(), name);
            supported.emplace_back(name);
        } catch (const InputError&) {
            // not on this processor
        }
    }
    return supported;
}

}  // namespace wetdeck::samples
