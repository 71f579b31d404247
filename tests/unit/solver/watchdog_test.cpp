// SPDX-License-Identifier: BSD-3-Clause
// What ends a run: each kind of instability is noticed in the step it arises in, or at the next look.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "solver/setup/body_outline.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Simulation tank() {
    return samples::dam_break(samples::two_phase_model(), {0.3, 0.45}, {0.9, 0.6}, 0.03).simulate();
}

/// The same tank with a square of 0.3 m in the air.
Simulation tank_with_body(const RigidBody& body) {
    samples::Setup setup = samples::dam_break(samples::two_phase_model(), {0.3, 0.45}, {0.9, 0.6}, 0.03);
    const Vec2 c(0.6, 0.3), a(0.15, 0.15), b(0.15, -0.15);
    const Outline outline = {c - a, c + b, c + a, c - b};
    clear_fluid(setup.fluid, outline, setup.particle_spacing);
    add_body_particles(setup.walls, 0, outline, c, setup.particle_spacing,
                       2 * setup.model.smoothing_ratio * setup.particle_spacing);
    setup.bodies = {body};
    return setup.simulate();
}

RigidBody resting_body() {
    RigidBody body;
    body.mass = 90;
    body.inertia = 1.35;
    body.position = {0.6, 0.3};
    return body;
}

}  // namespace

TEST_CASE("A particle that runs away, is lost or is no number ends the run in the same step",
          "[simulation]") {
    Simulation simulation = tank();
    const std::size_t water = 5, air = simulation.fluid().water + 5;
    std::size_t culprit = water;
    std::string what;
    FluidParticles& fluid = simulation.disturb();
    SECTION("water faster than ten times its sound") {
        fluid.state[water].vx = 301;  // c = 30 m/s
        what = "water density";
    }
    SECTION("air faster than ten times its sound") {
        culprit = air;
        fluid.state[air].vy = -901;  // c = 90 m/s
        what = "air density";
    }
    SECTION("density too high") {
        culprit = air;  // that of water is bounded by its cover
        fluid.state[air].density = 5100;
        what = "left the range of a fluid";
    }
    SECTION("outside the tank") {
        fluid.state[water].y = -0.2;
        what = "escaped from the tank";
    }
    const std::uint32_t id = fluid.id[culprit];
    const std::optional<Instability> instability = simulation.step(1e-9);
    REQUIRE(instability);
    CHECK(instability->step == 1);
    CHECK(instability->particle == id);
    CHECK_THAT(instability->describe(),
               Contains(what) && Contains("particle " + std::to_string(id) + " at ("));
}

TEST_CASE("What is no number ends the run in the same step, near where it was", "[simulation]") {
    Simulation simulation = tank();
    FluidState& culprit = simulation.disturb().state[40];
    const Vec2 place = culprit.position();
    SECTION("a density") {
        culprit.density = nothing;
    }
    SECTION("a velocity") {
        culprit.vy = nothing;
    }
    SECTION("a place") {
        culprit.x = nothing;
    }
    const std::optional<Instability> instability = simulation.step(1e-9);
    REQUIRE(instability);
    CHECK(instability->step == 1);
    // Within the step it has spread by a support in each of the density pass, the wall pass and the momentum
    // pass; of all that caught it the first in memory is named.
    const bool near = !((instability->position - place).norm() > 3 * simulation.kernel().support_radius());
    CHECK(near);
    CHECK_THAT(instability->describe(), Contains("left the range of a fluid"));
}

TEST_CASE("A density rate that is no number is noticed where densities are kept from falling",
          "[simulation]") {
    samples::Setup setup =
        samples::dam_break(samples::two_phase_model(), {0.3, 0.45}, {0.9, 0.6}, 0.03, false);
    setup.model.negative_pressure = false;
    setup.model.water.eos.background_pressure = 0;
    Simulation simulation = setup.simulate();
    simulation.disturb().state[40].volume = nothing;
    REQUIRE(simulation.step(1e-9));
}

TEST_CASE("No speed that a run survives makes its step collapse", "[simulation]") {
    Simulation simulation = tank();
    const double at_rest = simulation.time_step().size;
    for (FluidState& p : simulation.disturb().state) p.vx = 0;
    simulation.disturb().state[5].vx = 299;
    simulation.evaluate();
    REQUIRE_FALSE(simulation.step(1e-9));
    REQUIRE(simulation.time_step().size > at_rest / 11);
    simulation.disturb().state[5].vx = 1e9;
    simulation.evaluate();
    REQUIRE(simulation.step(1));
}

TEST_CASE("A body that is nowhere, runs away or leaves the tank ends the run", "[simulation]") {
    RigidBody body = resting_body();
    std::string what = "left the tank";
    SECTION("at rest") {
        what.clear();
    }
    SECTION("faster than ten times the sound of water") {
        body.velocity.x() = 301;
        what = "left the range of a body";
    }
    SECTION("turning as fast") {
        body.angular_velocity = 1600;  // at 0.2 m
        what = "left the range of a body";
    }
    SECTION("through the floor") {
        body.velocity.y() = -250;
        body.position.y() = 2e-7;
    }
    Simulation simulation = tank_with_body(body);
    const std::optional<Instability> instability = simulation.step(1e-9);
    REQUIRE(instability.has_value() == !what.empty());
    if (instability) CHECK_THAT(instability->describe(), Contains("body 1 with speed") && Contains(what));
}

TEST_CASE("A body that the fluid pushes by no number ends the run", "[simulation]") {
    Simulation simulation = tank_with_body(resting_body());
    for (FluidState& p : simulation.disturb().state) {
        if ((p.position() - Vec2(0.6, 0.3)).norm() < 0.2) p.pressure = nothing;
    }
    simulation.evaluate();
    const std::optional<Instability> instability = simulation.step(1e-9);
    REQUIRE(instability);
}

TEST_CASE("A watch is asked at most 64 steps apart and can end a run", "[simulation]") {
    Simulation simulation = tank();
    std::vector<std::uint64_t> asked;
    const auto watch = [&](const Simulation& s) {
        asked.push_back(s.steps());
        return asked.size() < 3 ? std::nullopt
                                : std::optional(Instability{s.time(), s.steps(), 7, {0, 0}, "a test"});
    };
    const std::optional<Instability> instability = simulation.run(
        1e9, [](const Simulation&) {}, watch);
    REQUIRE(instability);
    CHECK(instability->quantity == "a test");
    CHECK(asked == std::vector<std::uint64_t>{64, 128, 192});
}

TEST_CASE("Air may be squeezed as far as an impact of the water can press it", "[simulation]") {
    Model model = samples::two_phase_model();  // water of 30 m/s
    const auto holds = [&](Phase phase, double ratio) {
        FluidState p;
        p.x = p.y = 0.5;
        p.density = ratio * (phase == Phase::water ? model.water : model.air).eos.reference_density;
        return StabilityBounds(model, {{0, 0}, {1, 1}}, 0.1).hold(p, 0, phase);
    };
    CHECK(holds(Phase::air, 9));
    CHECK_FALSE(holds(Phase::air, 60));
    CHECK_FALSE(holds(Phase::water, 12));
    model.water.eos.sound_speed = 1450;
    CHECK(holds(Phase::air, 60));
    CHECK_FALSE(holds(Phase::air, 6000));
    CHECK_FALSE(holds(Phase::water, 12));
    model.air = {};
    CHECK_FALSE(holds(Phase::water, 12));
}
