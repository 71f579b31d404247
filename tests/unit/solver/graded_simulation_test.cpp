// SPDX-License-Identifier: BSD-3-Clause
// Runs with particles that differ in their spacings: the same bits on any number of threads and from a stored
// state, momentum, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "tests/support/restored_run.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

/// The graded tank at rest under hydrostatic pressure, its water stirred.
samples::Setup stirred_tank(const Model& model) {
    samples::Setup setup = samples::graded_tank(model, 1);
    set_initial_pressure(setup.fluid, setup.model, [](Phase phase, Vec2 at) {
        return phase == Phase::water ? 9810 * (0.8 - at.y()) : 9.81 * (0.8 - at.y());
    });
    for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
        FluidState& p = setup.fluid.state[i];
        p.vx = 0.5 * std::sin(3 * p.y);
        p.vy = 0;
    }
    for (WallState& wall : setup.walls.state) wall.vx = wall.vy = wall.ax = wall.ay = 0;
    return setup;
}

}  // namespace

TEST_CASE("a graded run goes on from a stored state, and on other threads, to the same bits",
          "[graded][simulation]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    samples::Setup setup = stirred_tank(model);
    setup.execution.precision = GENERATE(Precision::double_precision, Precision::mixed);
    samples::check_restored_run(setup, 40);
}

TEST_CASE("pairs of different spacings push each other with opposite forces all through a run",
          "[graded][simulation]") {
    Simulation simulation = stirred_tank(samples::two_phase_model()).simulate();
    for (int n = 0; n < 5; ++n) {
        CHECK(simulation.momentum_error() < 1e-13);
        samples::step_stably(simulation, 10);
    }
}

TEST_CASE("a set-up without finenesses, or with wrong ones, is no graded set-up", "[graded][simulation]") {
    samples::Setup setup = samples::graded_tank(samples::two_phase_model(), 1);
    setup.fluid.state[3].fineness = 0;
    CHECK_THROWS_WITH(setup.simulate(), Catch::Contains("needs a fineness"));
    setup = samples::graded_tank(samples::two_phase_model(), 1);
    setup.walls.fineness[0] = 0.01;
    CHECK_THROWS_WITH(setup.simulate(), Catch::Contains("needs a fineness"));
    setup = samples::graded_tank(samples::two_phase_model(), 1);
    setup.coarsest = 0.5;
    CHECK_THROWS_WITH(setup.simulate(), Catch::Contains("coarsest"));
    setup = samples::graded_tank(samples::paper_model(), 1);
    CHECK_THROWS_WITH(setup.simulate(), Catch::Contains("no passes over differing spacings"));
}
