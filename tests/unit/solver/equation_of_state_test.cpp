// SPDX-License-Identifier: BSD-3-Clause
// Tait equation of state: both directions, the fast powers, the elastic energy.
#include "solver/physics/equation_of_state.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solver/passes/pair_passes.hpp"
#include "tests/support/quadrature.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

TaitEquationOfState water() {
    return {1000, 30, 7, 500};
}
TaitEquationOfState air() {
    return {1.2, 90, 1.4, 500};
}

}  // namespace

TEST_CASE("Pressure at the reference density is the background pressure", "[eos]") {
    CHECK(water().pressure(1000) == Approx(500).epsilon(1e-14));
    CHECK(air().pressure(1.2) == Approx(500).epsilon(1e-14));
}

TEST_CASE("Pressure follows the Tait equation at a hand-computed point", "[eos]") {
    // B = 1000 * 900 / 7 and 1.01^7 - 1 = 0.0721353521070101
    CHECK(water().pressure(1010) == Approx(900e3 / 7 * 0.0721353521070101 + 500).epsilon(1e-12));
}

TEST_CASE("Density is the inverse of pressure", "[eos]") {
    const double ratio = GENERATE(0.3, 0.9, 0.99, 1.0, 1.01, 1.5, 3.0);
    CHECK(water().density(water().pressure(1000 * ratio)) == Approx(1000 * ratio).epsilon(1e-12));
    CHECK(air().density(air().pressure(1.2 * ratio)) == Approx(1.2 * ratio).epsilon(1e-12));
}

TEST_CASE("The slope of pressure over density at the reference is the sound speed squared", "[eos]") {
    const TaitEquationOfState eos = GENERATE(water(), air());
    const double step = 1e-5 * eos.reference_density;
    const double slope =
        (eos.pressure(eos.reference_density + step) - eos.pressure(eos.reference_density - step)) /
        (2 * step);
    CHECK(slope == Approx(eos.sound_speed * eos.sound_speed).epsilon(1e-7));
}

TEST_CASE("Phases with the equal-coefficient sound speed share the coefficient", "[eos]") {
    TaitEquationOfState light{1, 0, 1.4, 0};
    light.sound_speed = equal_coefficient_sound_speed(water(), light.reference_density, light.exponent);
    CHECK(light.coefficient() == Approx(water().coefficient()).epsilon(1e-14));
    CHECK(light.sound_speed == Approx(30 * std::sqrt(200.0)).epsilon(1e-14));
}

TEST_CASE("Both powers by multiplication agree with std::pow from 0.2 to 4", "[eos]") {
    double worst_seven = 0, worst_seven_fifths = 0;
    for (int n = 0; n <= 3800; ++n) {
        const double x = 0.2 + 0.001 * n;
        worst_seven = std::max(worst_seven, std::abs(power_seven(x) / std::pow(x, 7.0) - 1));
        worst_seven_fifths =
            std::max(worst_seven_fifths, std::abs(power_seven_fifths(x) / std::pow(x, 1.4) - 1));
    }
    CHECK(worst_seven < 1e-13);
    CHECK(worst_seven_fifths < 1e-13);
}

TEST_CASE("Compression energy is the integral of (p - p0) / rho^2", "[eos]") {
    const TaitEquationOfState eos = GENERATE(water(), air());
    const double ratio = GENERATE(0.5, 0.98, 1.02, 2.0);
    const auto work = [&](double density) {
        return (eos.pressure(density) - eos.background_pressure) / (density * density);
    };
    const double expected = samples::integral(work, eos.reference_density, ratio * eos.reference_density);
    // near the reference the formula loses digits to cancellation: of terms of the size of c^2/gamma
    const double density = ratio * eos.reference_density;
    CHECK(eos.compression_energy(density, eos.pressure(density)) ==
          Approx(expected).epsilon(1e-11).margin(1e-14 * eos.sound_speed * eos.sound_speed));
    CHECK(expected > 0);
}

TEST_CASE("The fast density step gives the density, volume and pressure of the equation of state",
          "[eos][simd]") {
    const double exponent = GENERATE(7.0, 1.4, 2.5);
    const TaitEquationOfState eos{1.2, 90, exponent, 500};
    const double dt = 0.25, lowest = 0.3;
    for (const std::string& name : samples::instruction_sets()) {
        INFO(name << ", exponent " << exponent);
        std::vector<FluidState> state(21);
        std::vector<double> rate(state.size()), mass(state.size());
        for (std::size_t i = 0; i < state.size(); ++i) {
            state[i].density = 0.2 + 0.13 * static_cast<double>(i);
            rate[i] = 0.4 - 0.05 * static_cast<double>(i);
            mass[i] = 0.01 * static_cast<double>(i + 1);
            state[i].vx = 1 + static_cast<double>(i);
            state[i].vy = -2 * state[i].vx;
        }
        const std::vector<FluidState> before = state;
        const PairPasses loops = pair_passes(samples::two_phase_model(), name);
        std::vector<Cluster> clusters(3);
        const std::vector<std::size_t> shares{0, 3};
        clusters[0].first = 2;
        clusters[0].count = 8;
        clusters[1].first = 10;
        clusters[1].count = 8;
        clusters[2].first = 18;
        clusters[2].count = 1;
        NextCluster next;
        DensityUpdate update{rate.data(), mass.data(), nullptr, {clusters.data(), shares.data(), &next, 1},
                             dt,          {},          {}};
        update.groups[0].eos = eos;
        update.groups[0].bounds.lowest = lowest;
        update.sweep.drift = 0.5 * dt;
        loops.update_density(state.data(), update);
        for (std::size_t i = 0; i < state.size(); ++i) {
            const bool advanced = i >= 2 && i < 19;
            const double density =
                advanced ? std::max(before[i].density + dt * rate[i], lowest) : before[i].density;
            CHECK(state[i].density == Approx(density).epsilon(1e-15));
            CHECK(state[i].volume == Approx(advanced ? mass[i] / density : 0).epsilon(1e-14));
            CHECK(state[i].x == Approx(advanced ? 0.5 * dt * before[i].vx : 0));
            CHECK(state[i].y == Approx(advanced ? 0.5 * dt * before[i].vy : 0));
            CHECK(state[i].velocity() == before[i].velocity());
            CHECK(state[i].pressure == Approx(advanced ? eos.pressure(density) : 0)
                                           .epsilon(1e-12)
                                           .margin(1e-12 * eos.coefficient()));
        }
    }
}
