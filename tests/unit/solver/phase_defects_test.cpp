// SPDX-License-Identifier: BSD-3-Clause
// Voids, mixed particles and penetration on sets whose values are known.
#include "solver/probes/phase_defects.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

constexpr double dx = 0.02;
const Box tank{{0, 0}, {1, 1}};

/// The two phases fill the regions given, in the tank above.
Simulation filled(const std::vector<Box>& water, const std::vector<Box>& air) {
    samples::Setup setup(samples::two_phase_model(), tank, dx);
    for (const Box& box : water) setup.fill(Phase::water, box);
    for (const Box& box : air) setup.fill(Phase::air, box);
    return setup.simulate();
}

/// The boxes around a hole of `cells` spacings a side, whose lower left corner is at (0.4, 0.4).
std::vector<Box> around_hole(double cells) {
    const double end = 0.4 + cells * dx;
    return {{{0, 0}, {0.4, 1}}, {{0.4, 0}, {end, 0.4}}, {{0.4, end}, {end, 1}}, {{end, 0}, {1, 1}}};
}

}  // namespace

TEST_CASE("Two phases on a lattice have neither voids nor mixed particles", "[probe]") {
    const Simulation simulation = filled({{{0, 0}, {1, 0.5}}}, {{{0, 0.5}, {1, 1}}});
    CHECK(void_area(simulation, {}) == 0);
    const MixedParticles mixed = mixed_particles(simulation);
    CHECK(mixed.water_in_air == 0);
    CHECK(mixed.air_in_water == 0);
}

TEST_CASE("The area of a strip without particles is what is farther than one spacing from both sides",
          "[probe]") {
    const double cells = GENERATE(2.0, 5.0, 10.0, 20.0);
    const Simulation simulation = filled({{{0, 0}, {0.3, 1}}, {{0.3 + cells * dx, 0}, {1, 1}}}, {});
    // mean of sqrt(1 - s^2) over |s| < 1/2: how far the circles about a column of particles reach
    const double reach = (0.25 * std::sqrt(3.0) + std::asin(0.5)) * dx;
    CHECK(void_area(simulation, {}) == Approx((cells + 1) * dx - 2 * reach).margin(0.25 * dx));
}

TEST_CASE("A missing particle is no void, a missing block of three by three is", "[probe]") {
    CHECK(void_area(filled(around_hole(1), {}), {}) < 0.25 * dx * dx);
    CHECK(void_area(filled(around_hole(3), {}), {}) > 3 * dx * dx);
}

TEST_CASE("Single particles of one phase within the other are counted, drops of four by four are not",
          "[probe]") {
    const Simulation one = filled({{{0.4, 0.4}, {0.42, 0.42}}}, around_hole(1));
    CHECK(mixed_particles(one).water_in_air == 1);
    CHECK(mixed_particles(one).air_in_water == 0);
    const Simulation drop = filled({{{0.4, 0.4}, {0.48, 0.48}}}, around_hole(4));
    CHECK(mixed_particles(drop).water_in_air == 0);
    const Simulation bubble = filled(around_hole(1), {{{0.4, 0.4}, {0.42, 0.42}}});
    CHECK(mixed_particles(bubble).air_in_water == 1);
    CHECK(mixed_particles(bubble).water_in_air == 0);
}

TEST_CASE("Air within water is enclosed, air that reaches the rest by a channel is not", "[probe]") {
    // a block of 0.08 m in water of 0.5 m under air; a channel of two spacings leads up from it
    const Box block{{0.4, 0.2}, {0.48, 0.28}}, channel{{0.42, 0.28}, {0.46, 0.5}}, above{{0, 0.5}, {1, 1}};
    const std::vector<Box> around{{{0, 0}, {0.4, 0.5}}, {{0.4, 0}, {0.48, 0.2}}, {{0.48, 0}, {1, 0.5}}};
    std::vector<Box> water = around;
    water.push_back({{0.4, 0.28}, {0.48, 0.5}});
    CHECK(enclosed_air(filled(water, {block, above})) == Approx(0.08 * 0.08).epsilon(1e-9));
    water.back() = {{0.4, 0.28}, {0.42, 0.5}};
    water.push_back({{0.46, 0.28}, {0.48, 0.5}});
    CHECK(enclosed_air(filled(water, {block, channel, above})) == Approx(0).margin(1e-12));
    CHECK(enclosed_air(filled(water, {})) == 0);
}

TEST_CASE("Fluid inside a body is counted in the body's frame, whatever its pose", "[probe]") {
    const double angle = GENERATE(0.0, 0.4, -2.0);
    samples::Setup setup(samples::two_phase_model(), tank, dx);
    const Outline local{{-0.1, -0.05}, {0.1, -0.05}, {0.1, 0.05}, {-0.1, 0.05}};
    RigidBody body;
    body.position = {0.5, 0.5};
    body.angle = angle;
    body.free = {false, false, false};
    for (const Vec2& place : {Vec2(0.09, 0.04), Vec2(-0.09, 0.0), Vec2(0.0, -0.04), Vec2(0.0, 0.06)}) {
        const Vec2 at = body.placed(place) - Vec2(0.5 * dx, 0.5 * dx);
        setup.fill(Phase::water, {at, at + Vec2(dx, dx)});
    }
    setup.bodies.push_back(body);
    const Simulation simulation = setup.simulate();
    CHECK(particles_in_bodies(simulation, std::vector<Outline>{local}) == 3);
    CHECK(particles_in_bodies(simulation, {}) == 0);
}
