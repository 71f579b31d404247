// SPDX-License-Identifier: BSD-3-Clause
// The time loop: what it refuses, what it counts, when it marks impacts, how it stops.
#include "solver/simulation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "solver/core/errors.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::two_phase_model;

namespace {

/// A disc of water without air or gravity at its reference density, moving as one.
samples::Setup disc(Vec2 velocity) {
    samples::Setup setup(two_phase_model(), Box{{-1, -1}, {1, 1}}, 0.05);
    setup.model.gravity = Vec2::Zero();
    setup.model.water.eos.background_pressure = 0;
    for (int column = -3; column <= 3; ++column) {
        for (int row = -3; row <= 3; ++row)
            setup.fluid.add(Phase::water, {0.05 * column, 0.05 * row}, 2.5, 1000);
    }
    for (FluidState& p : setup.fluid.state) {
        p.vx = velocity.x();
        p.vy = velocity.y();
    }
    return setup;
}

}  // namespace

TEST_CASE("A simulation without fluid or without a spacing is refused", "[simulation]") {
    samples::Setup empty(two_phase_model(), Box{{0, 0}, {1, 1}}, 0.05);
    CHECK_THROWS_AS(empty.simulate(), InputError);
    CHECK_THROWS_WITH(empty.simulate(), Catch::Contains("needs fluid particles"));
    samples::Setup no_spacing = disc({0, 0});
    no_spacing.particle_spacing = GENERATE(0.0, -0.05, std::numeric_limits<double>::quiet_NaN());
    CHECK_THROWS_AS(no_spacing.simulate(), InputError);
}

TEST_CASE("Pressure and volume follow from density when a simulation starts", "[simulation]") {
    samples::Setup setup = disc({0, 0});
    setup.fluid.state[7].density = 1010;
    const Simulation simulation = setup.simulate();
    const FluidState p = samples::by_id(simulation.fluid())[7];
    CHECK(p.pressure == Approx(setup.model.water.eos.pressure(1010)));
    CHECK(p.volume == Approx(2.5 / 1010));
}

TEST_CASE("A step is never longer than asked for and a run ends at its end", "[simulation]") {
    Simulation simulation = disc({1, 0}).simulate();
    const double stable = simulation.time_step().size;
    CHECK(stable == Approx(0.5 * 0.0625 / 31));
    REQUIRE_FALSE(simulation.step(0.3 * stable));
    CHECK(simulation.time() == Approx(0.3 * stable));
    std::size_t observed = 0;
    REQUIRE_FALSE(simulation.run(4.5 * stable, [&](const Simulation&) { ++observed; }));
    CHECK(simulation.time() == Approx(4.5 * stable).epsilon(1e-14));
    CHECK(simulation.steps() == 6);
    CHECK(observed == 6);  // once before the five steps of the run, once after each
}

TEST_CASE("The limiting criterion of each step is counted", "[simulation]") {
    Simulation simulation = disc({1, 0}).simulate();
    for (int n = 0; n < 3; ++n) REQUIRE_FALSE(simulation.step(1));
    CHECK(simulation.limiting_counts()[static_cast<std::size_t>(LimitingCriterion::acoustic_water)] == 3);
    CHECK(simulation.limiting_counts()[static_cast<std::size_t>(LimitingCriterion::acoustic_air)] == 0);
}

TEST_CASE("The list is built again when particles have come closer by the skin, and not before",
          "[simulation]") {
    samples::Setup setup = disc({0, 0});
    // the halves fly at each other
    for (FluidState& p : setup.fluid.state) p.vx = p.x < 0 ? 10 : -10;
    setup.execution.skin = 0.2;
    Simulation simulation = setup.simulate();
    const double skin = 0.2 * 0.0625;
    CHECK(simulation.neighbours().slack() == Approx(skin));
    REQUIRE(simulation.list_builds() == 1);
    // 2.2 mm a step, 12.5 mm allowed: after six steps it would be 13.2 mm
    for (int n = 0; n < 5; ++n) REQUIRE_FALSE(simulation.step(1.1e-4));
    CHECK(simulation.list_builds() == 1);
    REQUIRE_FALSE(simulation.step(1.1e-4));
    CHECK(simulation.list_builds() == 2);
}

TEST_CASE("What flies as one keeps its list", "[simulation]") {
    Simulation simulation = disc({10, 0}).simulate();
    for (int n = 0; n < 11; ++n) REQUIRE_FALSE(simulation.step(1.1e-4));
    CHECK(simulation.list_builds() == 1);  // 12.1 mm, twice of what each may move alone
}

TEST_CASE("A particle whose density leaves its range ends the run with its name", "[simulation]") {
    samples::Setup setup = disc({0, 0});
    setup.model.full_kernel_sum = 0;
    Simulation simulation = setup.simulate();
    simulation.disturb().state[5].density = 10100;
    const std::uint32_t id = simulation.fluid().id[5];
    const std::optional<Instability> instability = simulation.step(1e-9);
    REQUIRE(instability);
    CHECK(instability->step == 1);
    CHECK(instability->time == Approx(1e-9));
    CHECK(instability->particle == id);
    CHECK(instability->position == simulation.fluid().state[5].position());
    CHECK_THAT(instability->describe(),
               Catch::Contains("water density 1.01e+04") && Catch::Contains("step 1"));
}

TEST_CASE("A run may end within a step of the water; what is evaluated then is whole", "[simulation]") {
    Model model = samples::two_phase_model();
    model.air_substeps = 3;
    Simulation simulation = samples::dam_break(model, {0.3, 0.45}, {0.9, 0.6}, 0.03).simulate();
    const auto at_rest = [&] {
        const FluidParticles& fluid = simulation.fluid();
        return std::count(fluid.acceleration_y.begin(),
                          fluid.acceleration_y.begin() + static_cast<std::ptrdiff_t>(fluid.water), 0.0);
    };
    simulation.disturb().state.back().density = 100;
    const std::optional<Instability> instability = simulation.step(3e-6);
    REQUIRE(instability);
    CHECK(instability->step == 1);
    CHECK(instability->time == Approx(1e-6));
    CHECK(at_rest() > 20);
    simulation.evaluate();
    CHECK(at_rest() == 0);
}

TEST_CASE("A velocity that is no number ends the run in the same step", "[simulation]") {
    Simulation simulation = disc({0, 0}).simulate();
    simulation.disturb().state[5].vx = std::numeric_limits<double>::quiet_NaN();
    std::size_t observed = 0;
    const std::optional<Instability> instability = simulation.run(1, [&](const Simulation&) { ++observed; });
    REQUIRE(instability);
    CHECK(instability->step == 1);
    CHECK(observed == 1);  // the bad state is not shown to probes
    CHECK_THAT(instability->describe(), Catch::Contains("step 1"));
}

TEST_CASE("Without tension the density of water never falls below its reference", "[simulation]") {
    samples::Setup setup = disc({0, 0});
    for (FluidState& p : setup.fluid.state) p.vx = 2 * p.x / 0.15;  // pulled apart
    setup.model.negative_pressure = GENERATE(true, false);
    Simulation simulation = setup.simulate();
    for (int n = 0; n < 5; ++n) REQUIRE_FALSE(simulation.step(1));
    double lowest = 1e9;
    for (const FluidState& p : simulation.fluid().state) lowest = std::min(lowest, p.density);
    if (setup.model.negative_pressure) {
        CHECK(lowest < 999);
    } else {
        CHECK(lowest == 1000);
    }
}

namespace {

/// Largest compression of two blocks that meet at 2 m/s, while their rows are still 1.5 spacings apart.
double early_compression(double full_kernel_sum) {
    constexpr double dx = 0.01;
    samples::Setup setup = disc({0, 0});
    setup.particle_spacing = dx;
    setup.fluid = {};
    for (int side : {-1, 1}) {
        for (int row = 0; row < 12; ++row) {
            for (int column = 0; column < 12; ++column) {
                setup.fluid.add(Phase::water, {side * (0.9 + column) * dx, (row - 5.5) * dx}, 1000 * dx * dx,
                                1000);
                setup.fluid.state.back().vx = -side * 1.0;
            }
        }
    }
    setup.model.negative_pressure = false;
    setup.model.full_kernel_sum = full_kernel_sum;
    Simulation simulation = setup.simulate();
    while (simulation.time() < 0.15 * dx) REQUIRE_FALSE(simulation.step(0.05 * dx));
    double highest = 0;
    for (const FluidState& p : simulation.fluid().state) highest = std::max(highest, p.density);
    return highest / 1000 - 1;
}

}  // namespace

TEST_CASE("Water that nothing has touched yet is hardly compressed", "[simulation]") {
    // the rows behind the first see a full support, and a little of what comes
    CHECK(early_compression(0.9) < 0.4 * early_compression(0));
}

TEST_CASE("Impact marks follow the pressure convection rate of the last accelerations", "[simulation]") {
    Model model = two_phase_model();
    model.dissipation_switch = true;
    Simulation simulation = samples::shaken_tank(model, 8).simulate();
    const auto before = samples::by_id(simulation.fluid());
    const auto rates = samples::rates_by_id(simulation.fluid());
    double fastest = 0;
    for (const FluidState& p : before) fastest = std::max(fastest, p.velocity().norm());
    REQUIRE_FALSE(simulation.step(1e-6));
    const auto after = samples::by_id(simulation.fluid());
    std::size_t marked = 0, wrong = 0;
    for (std::size_t id = 0; id < before.size(); ++id) {
        // grad p = -rho (dv/dt - g); on where grad p . v > rho g v_max, Eqs. (14)-(15)
        const Vec2 gradient = -before[id].density * (Vec2(rates[id][1], rates[id][2]) - model.gravity);
        const bool on = gradient.dot(before[id].velocity()) > before[id].density * 9.81 * fastest;
        marked += on;
        wrong += (after[id].impact == 1) != on;
    }
    CHECK(wrong == 0);
    CHECK(marked > before.size() / 10);
    CHECK(marked < before.size());
}

TEST_CASE("Impact marks are left alone where the switch is off", "[simulation]") {
    Simulation simulation = samples::shaken_tank(two_phase_model(), 8).simulate();
    const auto before = samples::by_id(simulation.fluid());
    REQUIRE_FALSE(simulation.step(1e-6));
    const auto after = samples::by_id(simulation.fluid());
    for (std::size_t id = 0; id < before.size(); ++id) {
        if (after[id].impact != before[id].impact) FAIL_CHECK("mark of particle " << id);
    }
    CHECK(simulation.steps() == 1);
}
