// SPDX-License-Identifier: BSD-3-Clause
// Greco's initial pressure of a dam break, and the densities that follow from a pressure.
#include "solver/setup/initial_pressure.hpp"

#include <catch2/catch.hpp>

#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

constexpr double height = 0.6, weight = 1000 * 9.81;

double greco(double distance, double y) {
    return greco_pressure(1000, 9.81, height, distance, y);
}

}  // namespace

TEST_CASE("Greco's pressure vanishes on the released face", "[greco]") {
    // The series is cut after 4000 terms: its rest is at most 1 / (4 * 4000) of 8/pi^2 rho g h, here below
    // 1e-4 rho g h.
    const double y = GENERATE(0.0, 0.1, 0.3, 0.59);
    CHECK(greco(0, y) == Approx(0).margin(1e-4 * weight * height));
}

TEST_CASE("Greco's pressure vanishes on the surface", "[greco]") {
    const double distance = GENERATE(0.01, 0.1, 0.6, 3.0);
    CHECK(greco(distance, height) == Approx(0).margin(1e-9 * weight * height));
}

TEST_CASE("Greco's pressure is hydrostatic far from the face", "[greco]") {
    // the slowest term decays like exp(-pi d / (2 h)): 4e-7 at 5.6 heights
    const double y = GENERATE(0.0, 0.2, 0.5);
    CHECK(greco(10 * height, y) == Approx(weight * (height - y)).epsilon(1e-6));
}

TEST_CASE("Greco's pressure is 0.83068 rho g h on the bed one height behind the face", "[greco]") {
    // 1 - (8/pi^2) (e^(-pi/2) + e^(-3 pi/2)/9 + e^(-5 pi/2)/25 + ...) = 1 - 0.810569 * 0.208894
    CHECK(greco(height, 0) == Approx(0.830677 * weight * height).epsilon(2e-6));
}

TEST_CASE("Greco's pressure satisfies Laplace's equation and has no flow through the bed", "[greco]") {
    const double d = GENERATE(0.1, 0.4, 1.0), y = GENERATE(0.1, 0.3, 0.5);
    const double step = 1e-3;
    const double laplacian = (greco(d + step, y) + greco(d - step, y) + greco(d, y + step) +
                              greco(d, y - step) - 4 * greco(d, y)) /
                             (step * step);
    // each second derivative is up to weight / height * 8; the difference has an error of step^2 of the
    // fourth
    CHECK(laplacian == Approx(0).margin(1e-3 * weight / height));
    const double slope_at_bed = (greco(d, step) - greco(d, 0)) / step;
    CHECK(slope_at_bed == Approx(-weight).epsilon(0.02));
}

TEST_CASE("A gauge pressure sets density and mass and leaves volume", "[setup]") {
    samples::Setup setup = samples::shaken_blob(samples::two_phase_model(), 1);
    const double volume = setup.particle_spacing * setup.particle_spacing;
    const auto gauge = [](Phase phase, Vec2 at) { return phase == Phase::water ? 3000 * at.x() : 40.0; };
    set_initial_pressure(setup.fluid, setup.model, gauge);
    for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
        const FluidState& p = setup.fluid.state[i];
        const TaitEquationOfState& eos =
            setup.fluid.phase(i) == Phase::water ? setup.model.water.eos : setup.model.air.eos;
        const double expected = 1000 + gauge(setup.fluid.phase(i), p.position());
        if (std::abs(eos.pressure(p.density) - expected) > 1e-6) FAIL_CHECK("density of particle " << i);
        if (std::abs(p.volume / volume - 1) > 1e-14) FAIL_CHECK("volume of particle " << i);
        if (std::abs(setup.fluid.mass[i] / (p.density * volume) - 1) > 1e-14)
            FAIL_CHECK("mass of particle " << i);
        if (p.pressure != expected) FAIL_CHECK("pressure of particle " << i);
    }
}
