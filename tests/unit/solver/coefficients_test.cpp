// SPDX-License-Identifier: BSD-3-Clause
// From the model's choices to the numbers of the pair loops.
#include <catch2/catch.hpp>

#include "solver/passes/pair_passes.hpp"
#include "solver/physics/riemann.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::two_phase_model;

namespace {

constexpr double h = 0.05;
constexpr double water_impedance = 1000 * 30, air_impedance = 1 * 90;

PairCoefficients water_with_air(const Model& model) {
    return pair_coefficients(model, Phase::water, Phase::air, h);
}

}  // namespace

TEST_CASE("Impedance weights with full dissipation give the acoustic Riemann states of two materials",
          "[coefficients]") {
    Model model = two_phase_model();
    model.dissipation = Dissipation::riemann;
    const bool water_left = GENERATE(true, false);
    const double zl = water_left ? water_impedance : air_impedance,
                 zr = water_left ? air_impedance : water_impedance;
    const PairCoefficients c =
        water_left ? water_with_air(model) : pair_coefficients(model, Phase::air, Phase::water, h);
    const double ul = 1.3, ur = -0.7, pl = 2400, pr = 900;
    // across the left wave p + Z_L u is carried, across the right wave p - Z_R u: two equations for u* and P*
    const double u_star = (zl * ul + zr * ur + pl - pr) / (zl + zr);
    const double p_star = pl + zl * (ul - u_star);
    CHECK(p_star == Approx(pr - zr * (ur - u_star)).epsilon(1e-12));
    CHECK(ul - velocity_left_less_star(ul - ur, pl - pr, c.weight_right, c.mobility) ==
          Approx(u_star).epsilon(1e-12));
    CHECK(weighted_pressure(pl, pr, c.pressure_weight_left, c.pressure_weight_right) +
              riemann_dissipation(ul - ur, c.limiter) ==
          Approx(p_star).epsilon(1e-12));
}

TEST_CASE("Each velocity mean has its weight of the right side", "[coefficients]") {
    Model model = two_phase_model();
    const auto weight_right = [&](Mean mean) {
        model.velocity_mean = mean;
        return water_with_air(model).weight_right;
    };
    CHECK(weight_right(Mean::arithmetic) == 0.5);
    CHECK(weight_right(Mean::density_weighted) == Approx(1 / 1001.0));
    CHECK(weight_right(Mean::impedance_weighted) == Approx(90 / 30090.0));
}

TEST_CASE("Each pressure mean weighs the lighter side's pressure less than its own weight would",
          "[coefficients]") {
    Model model = two_phase_model();
    const auto left_and_right = [&](Mean mean) {
        model.pressure_mean = mean;
        const PairCoefficients c = water_with_air(model);
        CHECK(c.pressure_weight_left + c.pressure_weight_right == Approx(1).epsilon(1e-15));
        return c.pressure_weight_right;
    };
    CHECK(left_and_right(Mean::arithmetic) == 0.5);
    CHECK(left_and_right(Mean::density_weighted) == Approx(1000 / 1001.0));
    CHECK(left_and_right(Mean::impedance_weighted) == Approx(30000 / 30090.0));
}

TEST_CASE("The pressure jump moves the velocity by 1/(Z_L + Z_R), with harmonic means by 1/(2 H(Z))",
          "[coefficients]") {
    Model model = two_phase_model();
    model.pressure_diffusion = 0.5;
    CHECK(water_with_air(model).mobility == Approx(0.5 / 30090));
    CHECK(water_with_air(model).right_mobility == 0);
    model.impedance_mean = ImpedanceMean::harmonic;
    const double mean = 2 * water_impedance * air_impedance / (water_impedance + air_impedance);
    const PairCoefficients c = water_with_air(model);
    CHECK(c.mobility + c.right_mobility / model.air.eos.reference_density == Approx(0.5 / (2 * mean)));
    CHECK(c.mobility == Approx(0.5 * 0.25 / water_impedance));
}

TEST_CASE("Dissipation of water with water is limited, with air it is a share for both signs",
          "[coefficients]") {
    Model model = two_phase_model();
    model.dissipation_slope = 3;
    model.air_dissipation = 0.1;
    const PairCoefficients water = pair_coefficients(model, Phase::water, Phase::water, h);
    CHECK(water.limiter.half_impedance == Approx(15000));
    CHECK(water.limiter.slope_over_speed == Approx(0.1));
    CHECK(water.limiter.floor == 0);
    const Phase other = GENERATE(Phase::water, Phase::air);
    const PairCoefficients air = pair_coefficients(model, Phase::air, other, h);
    CHECK(air.limiter.slope_over_speed == 0);
    CHECK(air.limiter.floor == 0.1);
    CHECK(air.limiter.half_impedance == Approx(other == Phase::air ? 45 : 30000 * 90.0 / 30090));
}

TEST_CASE("Full Riemann dissipation is the same share in every pair", "[coefficients]") {
    Model model = two_phase_model();
    model.dissipation = Dissipation::riemann;
    const Phase left = GENERATE(Phase::water, Phase::air), right = GENERATE(Phase::water, Phase::air);
    const PairCoefficients c = pair_coefficients(model, left, right, h);
    CHECK(c.limiter.slope_over_speed == 0);
    CHECK(c.limiter.floor == 1);
}

TEST_CASE("Viscosity of a pair is lambda times the harmonic mean over h", "[coefficients]") {
    Model model = two_phase_model();
    model.water.viscosity = 2e-3;
    model.air.viscosity = 1e-5;
    model.viscosity = Viscosity::approaching;
    CHECK(water_with_air(model).viscosity == Approx(5 * 2 * 2e-3 * 1e-5 / (2e-3 + 1e-5) / h));
    CHECK(water_with_air(model).lowest_viscous_jump == 0);
    model.viscosity = Viscosity::symmetric;
    CHECK(pair_coefficients(model, Phase::water, Phase::water, h).viscosity == Approx(4 * 2e-3 / h));
    CHECK(water_with_air(model).lowest_viscous_jump < -1e9);
    model.air.viscosity = 0;
    CHECK(water_with_air(model).viscosity == 0);
}

TEST_CASE("The hydrostatic density of mixed pairs is the arithmetic mean, that of the switch the harmonic",
          "[coefficients]") {
    const PairCoefficients c = water_with_air(two_phase_model());
    CHECK(c.hydrostatic_density == Approx(500.5));
    CHECK(c.half_density == Approx(1000 / 1001.0));
    const PairCoefficients water = pair_coefficients(two_phase_model(), Phase::water, Phase::water, h);
    CHECK(water.hydrostatic_density == Approx(1000));
    CHECK(water.half_density == Approx(500));
}

TEST_CASE("A wall dissipates with the fluid's own impedance and is viscous only where viscosity is on",
          "[coefficients]") {
    Model model = two_phase_model();
    model.wall_dissipation = 3;
    model.water.viscosity = 2e-3;
    const WallCoefficients plain = wall_coefficients(model, Phase::water, h);
    CHECK(plain.limiter.half_impedance == Approx(water_impedance));
    CHECK(plain.limiter.slope_over_speed == Approx(0.1));
    CHECK(plain.limiter.floor == 0);
    CHECK(plain.viscosity == 0);
    model.viscosity = Viscosity::symmetric;
    CHECK(wall_coefficients(model, Phase::water, h).viscosity == Approx(4 * 2e-3 / h));
    CHECK(wall_coefficients(model, Phase::air, h).limiter.slope_over_speed == Approx(3.0 / 90));
    model.wall_dissipation = 0;
    CHECK(riemann_dissipation(7.0, wall_coefficients(model, Phase::water, h).limiter) == 0);
}
