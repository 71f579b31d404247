// SPDX-License-Identifier: BSD-3-Clause
// Runs with particles that differ in their spacings: the same bits on any number of threads and from a stored
// state, momentum, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "solver/core/errors.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

void step(Simulation& simulation, int steps) {
    for (int n = 0; n < steps; ++n) REQUIRE_FALSE(simulation.step(1));
}

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

bool same(const Simulation& a, const Simulation& b) {
    const std::vector<FluidState>&left = a.fluid().state, &right = b.fluid().state;
    return left.size() == right.size() &&
           std::memcmp(left.data(), right.data(), left.size() * sizeof(FluidState)) == 0;
}

}  // namespace

TEST_CASE("a graded run goes on from a stored state, and on other threads, to the same bits",
          "[graded][simulation]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    samples::Setup setup = stirred_tank(model);
    setup.execution.precision = GENERATE(Precision::double_precision, Precision::mixed);
    Simulation whole = setup.simulate();
    step(whole, 40);
    std::uint64_t builds = whole.list_builds();
    for (int n = 0; n < 200 && whole.list_builds() == builds; ++n) step(whole, 1);
    step(whole, 2);
    setup.execution.threads = 3;
    Simulation parted = setup.simulate();
    parted.restore(whole.state());
    builds = whole.list_builds();
    step(whole, 60);
    step(parted, 60);
    CHECK(whole.list_builds() > builds);
    CHECK(same(whole, parted));
}

TEST_CASE("pairs of different spacings push each other with opposite forces all through a run",
          "[graded][simulation]") {
    Simulation simulation = stirred_tank(samples::two_phase_model()).simulate();
    for (int n = 0; n < 5; ++n) {
        CHECK(simulation.momentum_error() < 1e-13);
        step(simulation, 10);
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
