// SPDX-License-Identifier: BSD-3-Clause
// Runs with particles that differ in their spacings: the same bits on any number of threads and from a stored
// state, momentum, and what is refused.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/probes/phase_defects.hpp"
#include "solver/setup/body_outline.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "tests/support/restored_run.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

/// A graded tank at rest under hydrostatic pressure, its water stirred.
samples::Setup stirred(samples::Setup setup) {
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

samples::Setup stirred_tank(const Model& model) {
    return stirred(samples::graded_tank(model, 1));
}

samples::Setup stirred_water(const Model& model) {
    return stirred(samples::graded_water(model, 1));
}

/// Clusters on which nothing acts in the steps of fast fluid alone.
auto resting_clusters(const Simulation& simulation) {
    const std::vector<Cluster>& clusters = simulation.neighbours().clusters();
    return std::count_if(clusters.begin(), clusters.end(), [](const Cluster& c) { return c.rests; });
}

/// Checks the sum of all forces ten steps apart.
void check_momentum(const samples::Setup& setup, int times, double most) {
    Simulation simulation = setup.simulate();
    for (int n = 0; n < times; ++n) {
        CHECK(simulation.momentum_error() < most);
        samples::step_stably(simulation, 10);
    }
}

}  // namespace

TEST_CASE("a graded run goes on from a stored state, and on other threads, to the same bits",
          "[graded][simulation]") {
    Model model = samples::two_phase_model();
    model.air_substeps = 3;
    samples::Setup setup = stirred_tank(model);
    setup.execution.precision = GENERATE(Precision::double_precision, Precision::mixed);
    samples::check_restored_run(setup, 40);
}

TEST_CASE("pairs of different spacings push each other with opposite forces all through a run",
          "[graded][simulation]") {
    check_momentum(stirred_tank(samples::two_phase_model()), 5, 1e-13);
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

TEST_CASE("runs in which fine water takes shorter steps keep momentum, and go on to the same bits",
          "[graded][simulation]") {
    Model model = samples::two_phase_model();
    model.coarse_substeps = 3;
    samples::Setup setup = stirred_water(model);
    setup.execution.precision = GENERATE(Precision::double_precision, Precision::mixed);
    const Simulation start = setup.simulate();
    REQUIRE(start.substeps() == 3);
    REQUIRE(resting_clusters(start) > 3);
    check_momentum(setup, 3, setup.execution.precision == Precision::mixed ? 1e-7 : 1e-13);
    samples::check_restored_run(setup, 20);
}

TEST_CASE("where the list is built within a step, resting water is where it should be",
          "[graded][simulation]") {
    Model model = samples::two_phase_model();
    model.coarse_substeps = 3;
    samples::Setup setup = stirred_water(model);
    setup.execution.skin = 0.3;
    Simulation seldom = setup.simulate();
    setup.execution.skin = 0.002;  // a build in about each of the substeps
    Simulation often = setup.simulate();
    samples::step_stably(seldom, 10);
    samples::step_stably(often, 10);
    REQUIRE(resting_clusters(seldom) > 3);
    REQUIRE(seldom.list_builds() < 5);
    REQUIRE(often.list_builds() > 20);
    const std::vector<FluidState> a = samples::by_id(seldom.fluid()), b = samples::by_id(often.fluid());
    double apart = 0;
    for (std::size_t id = 0; id < a.size(); ++id)
        apart = std::max(apart, (a[id].position() - b[id].position()).norm());
    CHECK(apart < 1e-13);
}

TEST_CASE("coarse fluid at a body is noticed", "[graded][probes]") {
    samples::Setup setup = stirred_tank(samples::two_phase_model());
    for (FluidState& p : setup.fluid.state) p.vx = 0;
    const Vec2 c(GENERATE(1.0, 1.7), 0.75);
    const Outline outline = {c + Vec2(-0.1, -0.05), c + Vec2(0.1, -0.05), c + Vec2(0.1, 0.05),
                             c + Vec2(-0.1, 0.05)};
    clear_fluid(setup.fluid, outline, setup.particle_spacing);
    add_body_particles(setup.walls, 0, outline, c, setup.particle_spacing,
                       2 * setup.model.smoothing_ratio * setup.particle_spacing);
    RigidBody body;
    body.position = c;
    body.mass = 20;
    body.inertia = 0.1;
    setup.bodies = {body};
    const double coarsest = coarsest_at_bodies(setup.simulate());
    if (c.x() == 1.0) CHECK(coarsest < 1.1);
    if (c.x() > 1.0) CHECK(coarsest > 2);
}
