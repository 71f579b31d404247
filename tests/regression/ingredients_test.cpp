// SPDX-License-Identifier: BSD-3-Clause
// An ingredient that is switched off costs nothing: its code is not in the loop that runs.
#include <catch2/catch.hpp>

#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::two_phase_model;

namespace {

std::size_t air_neighbours(const Simulation& simulation) {
    std::size_t sum = 0;
    for (const Cluster& c : simulation.neighbours().clusters()) sum += c.fluid_neighbours[1];
    return sum;
}

}  // namespace

TEST_CASE("Without air there are no air clusters, no air neighbours and fewer pairs", "[ingredients]") {
    const auto tank = [](bool with_air) {
        return samples::dam_break(two_phase_model(), {0.3, 0.45}, {0.9, 0.6}, 0.03, with_air).simulate();
    };
    const Simulation both = tank(true), water = tank(false);
    CHECK(air_neighbours(both) > 1000);
    CHECK(air_neighbours(water) == 0);
    CHECK(water.neighbours().entries() < both.neighbours().entries() / 2);
    CHECK(both.fluid().water == water.fluid().size());
    for (const Cluster& c : water.neighbours().clusters()) CHECK(c.phase == Phase::water);
}

TEST_CASE("Water that no air is near is looked at once in a step, however many the air takes",
          "[ingredients]") {
    Model model = two_phase_model();
    const auto particle_steps = [&](int substeps) {
        model.air_substeps = substeps;
        Simulation simulation = samples::dam_break(model, {0.3, 0.45}, {0.9, 0.6}, 0.03).simulate();
        REQUIRE_FALSE(simulation.step(1));
        return simulation.particle_steps();
    };
    const samples::Setup setup = samples::dam_break(model, {0.3, 0.45}, {0.9, 0.6}, 0.03);
    const std::size_t water = setup.fluid.water, air = setup.fluid.size() - water;
    CHECK(particle_steps(1) == water + air);
    const std::uint64_t three = particle_steps(3);
    CHECK(three > water + 3 * air);  // its surface is looked at more often
    CHECK(three < 2 * water + 3 * air);
    CHECK(particle_steps(5) - three == three - particle_steps(1));
}

TEST_CASE("Each ingredient that is switched has a momentum loop of its own", "[ingredients]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    const auto momentum_loop = [&](auto change) {
        Model model = two_phase_model();
        change(model);
        return pair_passes(model, name).accelerations;
    };
    const Pass plain = momentum_loop([](Model&) {});
    CHECK(momentum_loop([](Model& m) { m.pressure_mean = Mean::arithmetic; }) ==
          plain);  // other weights, same loop
    std::vector<Pass> loops = {
        plain,
        momentum_loop([](Model& m) { m.pressure_mean = Mean::harmonic; }),
        momentum_loop([](Model& m) { m.dissipation = Dissipation::none; }),
        momentum_loop([](Model& m) { m.viscosity = Viscosity::symmetric; }),
        momentum_loop([](Model& m) { m.dissipation_switch = true; }),
        momentum_loop([](Model& m) { m.wall_slip = WallSlip::no; }),
    };
    for (std::size_t a = 0; a < loops.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) CHECK(loops[a] != loops[b]);
    }
}

TEST_CASE("The density loop knows the velocity mean, the hydrostatic correction and the walls' velocity",
          "[ingredients]") {
    const auto density_loop = [](auto change) {
        Model model = two_phase_model();
        change(model);
        return pair_passes(model, "sse2").density_rates;
    };
    const Pass plain = density_loop([](Model&) {});
    const Pass harmonic = density_loop([](Model& m) { m.velocity_mean = Mean::harmonic; });
    const Pass uncorrected = density_loop([](Model& m) { m.hydrostatic_correction = false; });
    CHECK(harmonic != plain);
    CHECK(uncorrected != plain);
    CHECK(uncorrected != harmonic);
    CHECK(density_loop([](Model& m) { m.wall_velocity = WallVelocity::normal; }) != plain);
    CHECK(density_loop([](Model& m) { m.viscosity = Viscosity::symmetric; }) == plain);
    CHECK(density_loop([](Model& m) { m.dissipation = Dissipation::none; }) == plain);
}

TEST_CASE("Walls that need no means have neither lists of their own nor a pass over them", "[ingredients]") {
    Model model = two_phase_model();
    model.wall_velocity = WallVelocity::normal;
    const auto after_steps = [&] {
        Simulation simulation = samples::dam_break(model, {0.3, 0.45}, {0.9, 0.6}, 0.03).simulate();
        for (int n = 0; n < 3; ++n) REQUIRE_FALSE(simulation.step(1));
        return simulation;
    };
    const Simulation shepard = after_steps();
    CHECK(shepard.neighbours().wall_clusters().size() > 10);
    CHECK(shepard.stage_times().walls > 0);
    model.wall_pressure = WallPressure::one_sided;
    const Simulation one_sided = after_steps();
    CHECK(one_sided.neighbours().wall_clusters().empty());
    CHECK(one_sided.stage_times().walls == 0);
    CHECK(one_sided.momentum_error() < 1e-12);  // the tank's reactions are known nevertheless
}
