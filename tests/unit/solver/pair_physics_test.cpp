// SPDX-License-Identifier: BSD-3-Clause
// The small formulas of a pair: means with their singular points, dissipation limiter, wall pressure,
// viscosity factor.
#include <catch2/catch.hpp>

#include "solver/physics/model.hpp"
#include "solver/physics/riemann.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

TEST_CASE("Weights of a mean are shares that add up to one", "[mean]") {
    constexpr MeanWeights w = weights_by(3000, 1000);
    CHECK(w.left == 0.75);
    CHECK(w.right == 0.25);
    constexpr MeanWeights none = weights_by(1, 1);
    CHECK(none.left == 0.5);
    CHECK(none.right == 0.5);
}

TEST_CASE("The harmonic mean of positive values lies between them and nearer the smaller", "[mean]") {
    CHECK(harmonic_mean(1000, 1) == Approx(2000.0 / 1001).epsilon(1e-15));
    CHECK(harmonic_mean(5, 5) == 5);
    CHECK(guarded_harmonic_mean(1000.0, 1.0, 1e-12) == Approx(2000.0 / 1001).epsilon(1e-15));
}

TEST_CASE("The harmonic mean is zero instead of singular where its values cancel", "[mean]") {
    CHECK(guarded_harmonic_mean(0.0, 0.0, 0.0) == 0);
    CHECK(guarded_harmonic_mean(2.0, -2.0, 0.0) == 0);
    CHECK(guarded_harmonic_mean(-2.0, 2.0, 1e-9) == 0);
    // on the guard itself, from either side
    CHECK(guarded_harmonic_mean(1.0, -0.75, 0.25) == 0);
    CHECK(guarded_harmonic_mean(-1.0, 0.75, 0.25) == 0);
}

TEST_CASE("Beyond its guard the harmonic mean keeps its pole, with the sign of either side", "[mean]") {
    // 2ab/(a+b) at a = 1, b = -1 +- 1e-6: the literal formula, as large as it comes
    CHECK(guarded_harmonic_mean(1.0, -1.0 + 1e-6, 1e-12) == Approx(-2e6).epsilon(1e-5));
    CHECK(guarded_harmonic_mean(1.0, -1.0 - 1e-6, 1e-12) == Approx(2e6).epsilon(1e-5));
    CHECK(guarded_harmonic_mean(-3.0, -6.0, 1e-12) == Approx(-4).epsilon(1e-15));
    CHECK(guarded_harmonic_mean(-3.0, 6.0, 1e-12) == Approx(-12).epsilon(1e-15));
}

TEST_CASE("Low dissipation acts on approaching pairs only, quadratic in the jump, then full",
          "[dissipation]") {
    const DissipationLimiter limiter{500, 3.0 / 30, 0};  // slope 3, c 30 m/s: full from 10 m/s
    CHECK(riemann_dissipation(-5.0, limiter) == 0);
    CHECK(riemann_dissipation(0.0, limiter) == 0);
    CHECK(riemann_dissipation(2.0, limiter) == Approx(500 * 0.2 * 2));
    CHECK(riemann_dissipation(4.0, limiter) == Approx(4 * riemann_dissipation(2.0, limiter)));
    CHECK(riemann_dissipation(10.0, limiter) == Approx(500 * 10));
    CHECK(riemann_dissipation(50.0, limiter) == Approx(500 * 50));
}

TEST_CASE("Full Riemann dissipation is linear in the jump with both signs", "[dissipation]") {
    const DissipationLimiter limiter{500, 0, 1};
    CHECK(riemann_dissipation(2.0, limiter) == Approx(1000));
    CHECK(riemann_dissipation(-2.0, limiter) == Approx(-1000));
}

TEST_CASE("A floor is the least share of dissipation, for both signs", "[dissipation]") {
    const DissipationLimiter limiter{500, 3.0 / 30, 0.1};
    CHECK(riemann_dissipation(-2.0, limiter) == Approx(-100));
    CHECK(riemann_dissipation(0.5, limiter) == Approx(25));
    CHECK(riemann_dissipation(5.0, limiter) == Approx(500 * 0.5 * 5));
}

TEST_CASE("Dissipation never drives a velocity jump", "[dissipation]") {
    const double slope = GENERATE(0.0, 0.1, 3.0), floor = GENERATE(0.0, 0.1, 1.0);
    const double jump = GENERATE(-100.0, -1.0, 1e-3, 1.0, 100.0);
    CHECK(riemann_dissipation(jump, DissipationLimiter{500, slope, floor}) * jump >= 0);
}

TEST_CASE("Pressure behind a still wall is hydrostatic", "[wall]") {
    // fluid 0.02 m above the boundary particle and 0.03 m beside it, gravity downwards: drive = -g
    CHECK(one_sided_pressure(700.0, 1000.0, 0.03, 0.02, 0.0, 9.81) == Approx(700 + 1000 * 9.81 * 0.02));
    CHECK(one_sided_pressure(700.0, 1000.0, 0.03, -0.02, 0.0, 9.81) == Approx(700 - 1000 * 9.81 * 0.02));
}

TEST_CASE("A wall that accelerates into the fluid has the higher pressure behind its face", "[wall]") {
    // wall on the left pushes to the right with 50 m/s^2, no gravity
    CHECK(one_sided_pressure(0.0, 1000.0, 0.02, 0.0, 50.0, 0.0) == Approx(1000));
    // a tank in free fall has no pressure gradient
    CHECK(one_sided_pressure(700.0, 1000.0, 0.03, 0.02, 0.0, -9.81 + 9.81) == 700);
}

TEST_CASE("Stretching along a wall counts from half a spacing on and fades out to a fifth", "[wall]") {
    CHECK(stretching_share(0.5) == Approx(1));
    CHECK(stretching_share(3.0) == 1);
    CHECK(stretching_share(0.35) == Approx(0.5));
    CHECK(stretching_share(0.2) == Approx(0).margin(1e-15));
    CHECK(stretching_share(-0.4) == 0);
}

TEST_CASE("The deficit of the left velocity is its share of the jump less what the pressure jump drives",
          "[riemann]") {
    CHECK(velocity_left_less_star(4.0, 0.0, 0.25, 1e-4) == Approx(1));
    CHECK(velocity_left_less_star(0.0, 100.0, 0.25, 1e-4) == Approx(-0.01));
}

TEST_CASE("Viscosity on approaching pairs takes the factor 5, on both signs 4", "[viscosity]") {
    CHECK(viscosity_lambda(Viscosity::approaching) == 5);
    CHECK(viscosity_lambda(Viscosity::symmetric) == 4);
}

TEST_CASE(
    "A harmonic mean under a guard is 2ab/(a+b) where the signs agree, and what the guard says elsewhere",
    "[pairs]") {
    const MeanGuard guard =
        GENERATE(MeanGuard::division, MeanGuard::same_sign_arithmetic, MeanGuard::same_sign_zero);
    CHECK(harmonic_mean(1.0, 3.0, guard, 1e-9) == Approx(1.5));
    CHECK(harmonic_mean(-1.0, -3.0, guard, 1e-9) == Approx(-1.5));
    CHECK(harmonic_mean_of_pressures(100.0, 300.0, guard, 1e-9) == Approx(150));
    const bool arithmetic = guard == MeanGuard::same_sign_arithmetic, division = guard == MeanGuard::division;
    CHECK(harmonic_mean(-1.0, 3.0, guard, 1e-9) == Approx(division ? -3 : arithmetic ? 1 : 0));
    CHECK(harmonic_mean(0.0, 0.0, guard, 1e-9) == 0);
    CHECK(harmonic_mean_of_pressures(-100.0, -300.0, guard, 1e-9) == Approx(division     ? -150
                                                                            : arithmetic ? -200
                                                                                         : 0));
    CHECK(harmonic_mean_of_pressures(-100.0, 300.0, guard, 1e-9) == Approx(division     ? -300
                                                                           : arithmetic ? 100
                                                                                        : 0));
}

TEST_CASE("The harmonic mean of velocity vectors is taken by component, worked by hand for one pair",
          "[pairs]") {
    // Two particles of water on a line at 45 degrees, r_ij = (-d, -d), velocities (2, 1) and (6, -1): by
    // component v_bar = (3, 0) under the guard "else zero", so that u_L - v_bar . e = ((2 - 3) + (1 - 0)) /
    // sqrt(2) = 0, while the harmonic mean of the projections, 3/sqrt(2) and 5/sqrt(2), would give (3
    // - 3.75)/sqrt(2).
    Model model = samples::two_phase_model();
    model.velocity_mean = Mean::harmonic;
    model.mean_guard = MeanGuard::same_sign_zero;
    model.gravity = Vec2::Zero();
    samples::Setup setup(model, {{-1, -1}, {1, 1}}, 0.05);
    setup.fluid.add(Phase::water, {0, 0}, 2.5, 1000);
    setup.fluid.add(Phase::water, {0.03, 0.03}, 2.5, 1000);
    setup.fluid.state[0].vx = 2;
    setup.fluid.state[0].vy = 1;
    setup.fluid.state[1].vx = 6;
    setup.fluid.state[1].vy = -1;
    const FluidParticles still = setup.simulate().fluid();
    const double scale =
        2 * 1000 * 0.0025 * WendlandC2{0.0625}.slope_over_distance(0.03 * std::sqrt(2)) * 0.03;
    CHECK(std::abs(still.density_rate[0]) < 1e-12 * scale);
    // another vertical velocity of the second particle: v_bar = (3, 1.5), u_L - v_bar . e = (-1 -
    // 0.5)/sqrt(2)
    setup.fluid.state[1].vy = 3;
    CHECK(setup.simulate().fluid().density_rate[0] == Approx(scale * -1.5));
}
