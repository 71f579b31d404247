// SPDX-License-Identifier: BSD-3-Clause
// Pressure gauge, front, depth and balances on sets whose values are known.
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/probes/energy.hpp"
#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "solver/setup/lattice.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

constexpr double spacing = 0.02;
const Box tank{{0, 0}, {1, 1}};

/// Water in `region` at a gauge pressure that may depend on the place.
template <class GaugePressure>
Simulation water_at(Box region, GaugePressure gauge) {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    fill_box(setup.fluid, Phase::water, region, spacing, 1000);
    set_initial_pressure(setup.fluid, setup.model, [&](Phase, Vec2 at) { return gauge(at); });
    return setup.simulate();
}

}  // namespace

TEST_CASE("A gauge reads the pressure at its centre in a linear field, background taken off", "[probe]") {
    const Simulation simulation = water_at({{0.5, 0}, {1, 1}}, [](Vec2 at) { return 2000 - 1500 * at.y(); });
    const double diameter = GENERATE(0.02, 0.09, 0.3), y = GENERATE(0.4, 0.503);
    const PressureGauge probe({1.0, y}, -Vec2::UnitX(), diameter);
    probe.check(spacing);
    // the kernel's sums over a lattice are uneven by some thousandths of a spacing
    CHECK(probe.sample(simulation) == Approx(2000 - 1500 * y).margin(0.005 * 1500 * spacing));
}

TEST_CASE("A gauge weighs heights by the chord of its disc", "[probe]") {
    // pressure (y - y0)^2: the mean over a disc of radius R is R^2 / 4, that over its height would be R^2 / 3
    const Simulation simulation =
        water_at({{0.5, 0}, {1, 1}}, [](Vec2 at) { return 1e5 * (at.y() - 0.5) * (at.y() - 0.5); });
    const double wide = PressureGauge({1.0, 0.5}, -Vec2::UnitX(), 0.4).sample(simulation);
    const double point = PressureGauge({1.0, 0.5}, -Vec2::UnitX(), 1e-6).sample(simulation);
    // sixteen heights give 1.3 % more than the exact mean
    CHECK(wide - point == Approx(1e5 * 0.2 * 0.2 / 4).epsilon(0.02));
}

TEST_CASE("A gauge above the water reads nothing and one half covered reads less than the water's pressure",
          "[probe]") {
    const Simulation simulation = water_at({{0.5, 0}, {1, 0.5}}, [](Vec2) { return 800.0; });
    CHECK(PressureGauge({1.0, 0.8}, -Vec2::UnitX(), 0.04).sample(simulation) == 0);
    CHECK(PressureGauge({1.0, 0.2}, -Vec2::UnitX(), 0.04).sample(simulation) == Approx(800).epsilon(1e-9));
    const double at_surface = PressureGauge({1.0, 0.5}, -Vec2::UnitX(), 0.2).sample(simulation);
    CHECK(at_surface > 300);
    CHECK(at_surface < 600);
}

TEST_CASE("A gauge that one particle hardly touches reads its pressure by four times its share", "[probe]") {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    setup.fluid.add(Phase::water, {0.97, 0.5}, 0.4, 1001);
    const Simulation simulation = setup.simulate();
    const FluidState particle = simulation.fluid().state[0];
    const double share = particle.volume * simulation.kernel().value(0.03);
    REQUIRE(share < 0.1);
    CHECK(PressureGauge({1.0, 0.5}, -Vec2::UnitX(), 1e-9).sample(simulation) ==
          Approx(4 * share * (particle.pressure - 1000)).epsilon(1e-9));
}

TEST_CASE("A gauge smaller than the particle spacing is refused", "[probe]") {
    const PressureGauge probe({1.0, 0.2}, -Vec2::UnitX(), 0.019);
    CHECK_THROWS_AS(probe.check(0.02), InputError);
    CHECK_THROWS_WITH(probe.check(0.02),
                      Catch::Contains("0.019 m is smaller than the particle spacing 0.02 m"));
    CHECK_NOTHROW(probe.check(0.019));
}

TEST_CASE("The front is the edge of the outermost water, whatever the air does", "[probe]") {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    fill_box(setup.fluid, Phase::water, {{0, 0}, {0.4, 0.2}}, spacing, 1000);
    fill_box(setup.fluid, Phase::air, {{0.4, 0}, {1, 0.2}}, spacing, 1);
    CHECK(front_position(setup.simulate()) == Approx(0.4).epsilon(1e-12));
}

TEST_CASE("Depth is the water's volume over a strip, edges and voids included", "[probe]") {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    fill_box(setup.fluid, Phase::water, {{0, 0}, {0.4, 0.2}}, spacing, 1000);
    fill_box(setup.fluid, Phase::water, {{0.1, 0.5}, {0.3, 0.6}}, spacing, 1000);
    fill_box(setup.fluid, Phase::air, {{0.4, 0}, {1, 0.2}}, spacing, 1);
    const Simulation simulation = setup.simulate();
    CHECK(water_depth(simulation, 0.2, 0.05) == Approx(0.3).epsilon(1e-12));
    CHECK(water_depth(simulation, 0.05, 0.033) == Approx(0.2).epsilon(1e-12));
    CHECK(water_depth(simulation, 0.4, 0.05) == Approx(0.1).epsilon(1e-12));  // half the strip is dry
    CHECK(water_depth(simulation, 0.7, 0.05) == 0);
}

TEST_CASE(
    "The surface is the highest water of each column, spray included, and the bottom where there is none",
    "[probe]") {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    fill_box(setup.fluid, Phase::water, {{0, 0}, {0.5, 0.4}}, spacing, 1000);
    fill_box(setup.fluid, Phase::water, {{0.74, 0.7}, {0.76, 0.72}}, spacing, 1000);  // one drop
    fill_box(setup.fluid, Phase::air, {{0, 0.4}, {0.5, 0.6}}, spacing, 1);
    const std::vector<double> top = water_top(setup.simulate(), 0, 1, 10);
    REQUIRE(top.size() == 10);
    for (std::size_t k = 0; k < 10; ++k) {
        INFO(k);
        CHECK(top[k] == Approx(k < 5 ? 0.4 : k == 7 ? 0.72 : 0.0).margin(1e-12));
    }
}

TEST_CASE("A surface whose particles have moved apart a little has no gaps between narrow columns",
          "[probe]") {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    fill_box(setup.fluid, Phase::water, {{0, 0}, {1, 0.4}}, spacing, 1000);
    for (FluidState& p : setup.fluid.state)
        p.x += (static_cast<int>(p.x / spacing) % 2 == 0 ? 0.2 : -0.2) * spacing;
    for (const double height : water_top(setup.simulate(), 0.1, 0.9, 200))
        CHECK(height == Approx(0.4).margin(1e-12));
}

TEST_CASE("The gap under a face is that to the nearest water in front of it, however the body is turned",
          "[probe]") {
    constexpr double half_turn = 3.14159265358979323846;
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    fill_box(setup.fluid, Phase::water, {{0, 0}, {1, 0.4}}, spacing, 1000);
    const auto gap_below = [&](double height, double angle, Vec2 from, Vec2 to) {
        RigidBody body;
        body.mass = 1;
        body.inertia = 1;
        body.position = {0.5, height + 0.1};
        body.angle = angle;
        setup.bodies = {body};
        const Simulation simulation = setup.simulate();
        return gap_to_water(simulation, 0, from, to);
    };
    const Vec2 low(-0.1, -0.1), high(0.1, -0.1);  // the lower face of a square
    CHECK(gap_below(0.5, 0, low, high) == Approx(0.1));
    CHECK(gap_below(0.5, half_turn / 2, {-0.1, 0.1}, low) == Approx(0.1));
    CHECK(gap_below(0.38, 0, low, high) == Approx(0).margin(1e-12));
    const double tank_diagonal = std::sqrt(2.0);
    CHECK(gap_below(0.5, half_turn, low, high) == Approx(tank_diagonal - 0.5 * spacing));
}

TEST_CASE("Balances of two particles are those computed by hand", "[probe]") {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    setup.fluid.add(Phase::water, {0.2, 0.3}, 4, 1010);
    setup.fluid.add(Phase::air, {0.8, 0.5}, 0.01, 0.9);
    setup.fluid.state[0].vx = 3;
    setup.fluid.state[0].vy = -4;
    setup.fluid.state[1].vy = 10;
    setup.model.gravity = {1, -9.81};
    const Balance b = balance(setup.simulate());
    CHECK(b.mass == Approx(4.01));
    CHECK(b.kinetic == Approx(0.5 * 4 * 25 + 0.5 * 0.01 * 100));
    CHECK(b.potential == Approx(4 * (9.81 * 0.3 - 0.2) + 0.01 * (9.81 * 0.5 - 0.8)));
    CHECK(b.momentum.x() == Approx(12));
    CHECK(b.momentum.y() == Approx(-16 + 0.1));
    CHECK(b.water_density_error == Approx(0.01));
    const auto& [water, air] = std::pair(setup.model.water.eos, setup.model.air.eos);
    CHECK(b.compression == Approx(4 * water.compression_energy(1010, water.pressure(1010)) +
                                  0.01 * air.compression_energy(0.9, air.pressure(0.9))));
    CHECK(b.compression > 0);
    CHECK(b.outside == 0);
}

TEST_CASE("Particles count as outside beyond a quarter spacing", "[probe]") {
    samples::Setup setup(samples::two_phase_model(), tank, spacing);
    for (const Vec2& at :
         {Vec2(-0.004, 0.5), Vec2(-0.006, 0.5), Vec2(0.5, 1.1), Vec2(1.006, 0.2), Vec2(0.4, -0.006)}) {
        setup.fluid.add(Phase::water, at, 0.4, 1000);
    }
    CHECK(balance(setup.simulate()).outside == 4);
}
