// SPDX-License-Identifier: BSD-3-Clause
// Bodies in water that are moved, held and released, joined, or cut by a plane of symmetry; checkpoints of
// them.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "solver/core/errors.hpp"
#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "solver/setup/lattice.hpp"
#include "solver/setup/mirrored_body.hpp"
#include "validation/verification/setups.hpp"

using namespace wetdeck;
using verification::Setup;

namespace {

constexpr double gravity = 9.81, dx = 0.02;
const Outline square = {{-0.06, -0.06}, {0.06, -0.06}, {0.06, 0.06}, {-0.06, 0.06}};

/// Still water 0.2 m deep in a tank of 0.8 x 0.5 m.
Setup basin() {
    Setup setup(verification::water_model(14, gravity), {{0, 0}, {0.8, 0.5}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {0.8, 0.2}});
    set_initial_pressure(setup.fluid, setup.model,
                         [](Phase, Vec2 at) { return 1000 * gravity * (0.2 - at.y()); });
    return setup;
}

RigidBody block(Vec2 position) {
    RigidBody body;
    body.mass = 5;
    body.inertia = 0.02;
    body.position = position;
    return body;
}

void run(Simulation& simulation, double end) {
    REQUIRE_FALSE(simulation.run(end, [](const Simulation&) {}));
}

bool same_bits(const Simulation& a, const Simulation& b) {
    const Simulation::State one = a.state(), other = b.state();
    for (const auto& [name, values] : one.arrays)
        if (other.arrays.at(name) != values) return false;
    return one.arrays.size() == other.arrays.size() && one.numbers.at("time") == other.numbers.at("time");
}

}  // namespace

TEST_CASE("a body that is moved through water follows its motion to rounding, at its list of neighbours too",
          "[motion][simulation]") {
    Setup setup = basin();
    RigidBody body = block({0.4, 0.3});
    body.free = {false, false, false};
    body.guide.motion[1] = harmonic_motion({-0.12, 0.4, 0, 0});
    body.guide.motion[2] = harmonic_motion({0.4, 0.3, 0, 0});
    setup.put(body, square);
    Simulation simulation = setup.simulate();
    double worst = 0, largest_force = 0;
    REQUIRE_FALSE(simulation.run(0.15, [&](const Simulation& s) {
        const RigidBody& b = s.bodies().front();
        worst = std::max({worst, std::abs(b.position.y() - 0.3 - b.guide.motion[1](s.time()).displacement),
                          std::abs(b.angle - b.guide.motion[2](s.time()).displacement),
                          std::abs(b.velocity.y() - b.guide.motion[1](s.time()).velocity)});
        largest_force = std::max(largest_force, b.force.y());
    }));
    CHECK(worst < 1e-13);
    CHECK(largest_force > 100);  // it has gone into the water
}

TEST_CASE("a checkpoint of a body that waits for its release goes on to the same bits",
          "[motion][simulation]") {
    const bool at_contact = GENERATE(false, true);
    Setup setup = basin();
    RigidBody body = block({0.4, 0.28});
    body.velocity = {0, -1};
    body.guide.release_time = at_contact ? std::numeric_limits<double>::infinity() : 0.03;
    setup.put(body, square);
    Simulation simulation = setup.simulate(), restored = setup.simulate();
    run(simulation, 0.02);
    CHECK(simulation.bodies().front().velocity.y() == -1);
    if (at_contact) simulation.release(0);
    restored.restore(simulation.state());
    run(simulation, 0.05);
    run(restored, 0.05);
    CHECK(simulation.bodies().front().velocity.y() != -1);
    CHECK(same_bits(simulation, restored));
}

TEST_CASE("joined bodies move as one, and the carrier feels the load of both", "[motion][simulation]") {
    Setup setup = basin();
    RigidBody carrier = block({0.4, 0.24});
    carrier.mass = 10;
    carrier.inertia = 0.3;
    RigidBody left = block({0.2, 0.24});
    left.free = {false, false, false};
    left.joined_to = 0;
    setup.put(carrier, square);
    setup.put(left, square);
    Simulation simulation = setup.simulate();
    run(simulation, 0.1);
    const RigidBody &one = simulation.bodies()[0], &two = simulation.bodies()[1];
    CHECK(one.angle != 0);  // the water lifts the left side as well
    CHECK(two.angle == one.angle);
    CHECK((one.local(two.position) - Vec2(-0.2, 0)).norm() < 1e-14);
    CHECK((two.velocity - one.velocity_at(two.position - one.position)).norm() < 1e-14);
    CHECK(two.force.y() > 0);
    CHECK(one.force.y() > two.force.y());
    RigidBody odd = left;
    odd.joined_to = 3;
    setup.bodies[1] = odd;
    CHECK_THROWS_AS(setup.simulate(), std::out_of_range);
    odd.joined_to = 0;
    odd.free[1] = true;
    setup.bodies[1] = odd;
    CHECK_THROWS_AS(setup.simulate(), InputError);
}

TEST_CASE("half of a symmetric tank gives the motion of the whole", "[symmetry][simulation]") {
    const auto drop = [](bool half) {
        Model model = verification::water_model(14, gravity);
        model.mirror_x = half;
        Setup setup(model, {{half ? 0.4 : 0.0, 0}, {0.8, 0.5}}, dx, true);
        setup.fill(Phase::water, {{half ? 0.4 : 0.0, 0}, {0.8, 0.2}});
        set_initial_pressure(setup.fluid, model,
                             [](Phase, Vec2 at) { return 1000 * gravity * (0.2 - at.y()); });
        RigidBody wedge = block({0.4, 0.3});
        wedge.velocity = {0, -1};
        wedge.free = {false, true, false};
        const std::size_t before = setup.walls.size();
        setup.put(wedge, {{0, -0.06}, {0.1, 0.0}, {0.1, 0.1}, {-0.1, 0.1}, {-0.1, 0.0}});
        mirror_body_points(setup.walls, before, 1e-3 * dx);
        return setup.simulate();
    };
    Simulation whole = drop(false), half = drop(true);
    CHECK(2 * half.fluid().size() == whole.fluid().size());
    run(whole, 0.08);
    run(half, 0.08);
    const RigidBody &one = whole.bodies()[0], &other = half.bodies()[0];
    CHECK(other.impulse.y() == Approx(one.impulse.y()).epsilon(1e-6));
    CHECK(one.impulse.y() > 1);
    CHECK(std::abs(one.impulse.x()) < 1e-6);
    CHECK(other.velocity.y() == Approx(one.velocity.y()).epsilon(1e-6));
    CHECK(other.impulse.x() == 0);
    CHECK(half.momentum_error() < 1e-12);
    // probes on either half and across the plane read the same
    for (const double x : {0.2, 0.39, 0.4, 0.6}) {
        CAPTURE(x);
        const PressureGauge floor({x, 0}, {0, 1}, 0.06);
        CHECK(floor.sample(half) == Approx(floor.sample(whole)).epsilon(1e-4));
        CHECK(water_depth(half, x, 0.1) == Approx(water_depth(whole, x, 0.1)).epsilon(1e-4));
    }
    CHECK(water_top(half, 0.1, 0.7, 12)[2] == Approx(water_top(whole, 0.1, 0.7, 12)[2]).epsilon(1e-4));
    CHECK(front_position(half, {0, false, {{0, 0}, {0.8, 0.5}}}) ==
          Approx(front_position(whole, {0, false, {{0, 0}, {0.8, 0.5}}})).margin(1e-4));
    CHECK(gap_to_water(half, 0, {-0.1, 0}, {0, -0.06}) ==
          Approx(gap_to_water(whole, 0, {-0.1, 0}, {0, -0.06})).margin(1e-4));
}
