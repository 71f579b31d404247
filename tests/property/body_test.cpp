// SPDX-License-Identifier: BSD-3-Clause
// Bodies in the fluid: action and reaction, symmetry, determinism.
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/probes/energy.hpp"
#include "solver/setup/body_outline.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

/// A blob of water and air about a free triangle, far from any wall, all of it shaken.
Simulation body_in_blob(const Model& model, int threads) {
    samples::Setup setup = samples::shaken_blob(model, 21);
    setup.execution.threads = threads;
    setup.model.gravity = Vec2::Zero();
    setup.model.hydrostatic_correction = false;
    const Outline outline = {{-0.05, -0.05}, {0.11, -0.05}, {0.0, 0.12}};
    clear_fluid(setup.fluid, outline, setup.particle_spacing);
    RigidBody body;
    body.mass = 40;
    body.inertia = 0.1;
    body.position = area_moments(outline).centroid;
    body.velocity = {1, -2};
    body.angular_velocity = 15;
    setup.walls = {};
    add_body_particles(setup.walls, 0, outline, body.position, setup.particle_spacing, 0.08);
    setup.bodies = {body};
    return setup.simulate();
}

struct PoseAndSpeed {
    Vec2 momentum = Vec2::Zero();
    double angular = 0;  ///< about the origin
    double sizes = 0, angular_sizes = 0;
};

PoseAndSpeed motion_of(const Simulation& s) {
    PoseAndSpeed sum;
    const auto add = [&](double mass, Vec2 r, Vec2 v, double spin) {
        sum.momentum += mass * v;
        sum.angular += mass * (r.x() * v.y() - r.y() * v.x()) + spin;
        sum.sizes += mass * v.norm();
        sum.angular_sizes += mass * r.norm() * v.norm();
    };
    for (std::size_t i = 0; i < s.fluid().size(); ++i)
        add(s.fluid().mass[i], s.fluid().state[i].position(), s.fluid().state[i].velocity(), 0);
    for (const RigidBody& b : s.bodies()) add(b.mass, b.position, b.velocity, b.inertia * b.angular_velocity);
    return sum;
}

}  // namespace

TEST_CASE("Fluid and body together keep linear and angular momentum to rounding", "[body]") {
    Model model = GENERATE(samples::two_phase_model(), samples::paper_model());
    // the paper's means of velocity and rho c end the run within few steps
    model.velocity_mean = Mean::impedance_weighted;
    model.impedance_mean = ImpedanceMean::arithmetic;
    if (!model.dissipation_switch) model.air_substeps = GENERATE(1, 3);
    Simulation simulation = body_in_blob(model, 1);
    const PoseAndSpeed before = motion_of(simulation);
    const Vec2 velocity = simulation.bodies()[0].velocity;
    for (int n = 0; n < 25; ++n) {  // without dissipation air is thrown off from the 32nd on
        const auto instability = simulation.step(1);
        if (instability) FAIL(instability->describe());
    }
    const PoseAndSpeed after = motion_of(simulation);
    CHECK((after.momentum - before.momentum).norm() < 1e-11 * before.sizes);
    // all pair forces point along the line between the two
    CHECK(std::abs(after.angular - before.angular) < 1e-11 * before.angular_sizes);
    CHECK((simulation.bodies()[0].velocity - velocity).norm() > 1e-3);  // the body was pushed
    CHECK(simulation.list_builds() > 2);
    CHECK(simulation.momentum_error() < 1e-12);
}

TEST_CASE("A body's motion is the same bits for one and two threads", "[body]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    Simulation one = body_in_blob(model, 1), two = body_in_blob(model, 2);
    for (int n = 0; n < 100; ++n) {
        REQUIRE_FALSE(one.step(1));
        REQUIRE_FALSE(two.step(1));
    }
    CHECK(one.bodies()[0].position == two.bodies()[0].position);
    CHECK(one.bodies()[0].angle == two.bodies()[0].angle);
    CHECK(one.bodies()[0].impulse == two.bodies()[0].impulse);
}

TEST_CASE("What a body receives is what the fluid loses, as energy too", "[body]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    Simulation simulation = body_in_blob(model, 1);
    const RigidBody before = simulation.bodies()[0];
    for (int n = 0; n < 100; ++n) REQUIRE_FALSE(simulation.step(1));
    const RigidBody& after = simulation.bodies()[0];
    CHECK((after.mass * (after.velocity - before.velocity) - after.impulse).norm() <
          1e-12 * after.impulse.norm());
    CHECK(after.kinetic_energy() - before.kinetic_energy() == Approx(after.work).epsilon(1e-9));
}

TEST_CASE("A state taken in the middle of a run with a body goes on with the same bits", "[body]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    Simulation straight = body_in_blob(model, 1), resumed = body_in_blob(model, 2);
    for (int n = 0; n < 60; ++n) REQUIRE_FALSE(straight.step(1));
    resumed.restore(straight.state());
    for (int n = 0; n < 60; ++n) {
        REQUIRE_FALSE(straight.step(1));
        REQUIRE_FALSE(resumed.step(1));
    }
    CHECK(straight.bodies()[0].position == resumed.bodies()[0].position);
    CHECK(straight.bodies()[0].impulse == resumed.bodies()[0].impulse);
    CHECK(straight.list_builds() == resumed.list_builds());
}
