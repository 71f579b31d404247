// SPDX-License-Identifier: BSD-3-Clause
// One time step against one put together by hand from the plain rates.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/physics/density_bounds.hpp"
#include "tests/support/reference_rates.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

struct ByHand {
    samples::Setup setup;
    samples::Rates rates;

    void evaluate() {
        rates = samples::reference_rates(setup.fluid, setup.walls, setup.model, setup.particle_spacing);
    }
    void kick(double time) {
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            setup.fluid.state[i].vx += time * rates.acceleration_x[i];
            setup.fluid.state[i].vy += time * rates.acceleration_y[i];
        }
    }
    void drift(double time) {
        for (FluidState& p : setup.fluid.state) {
            p.x += time * p.vx;
            p.y += time * p.vy;
        }
    }
    void compress(double time) {
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            const bool water = setup.fluid.phase(i) == Phase::water;
            FluidState& p = setup.fluid.state[i];
            p.density += time * rates.density[i];
            if (water && time > 0) {
                const TaitEquationOfState& eos = setup.model.water.eos;
                const double weight = setup.model.gravity.norm() * setup.particle_spacing;
                const double open = 1 + weight / (eos.sound_speed * eos.sound_speed);
                const double filled = 1 + cover_steepness * (rates.cover[i] - setup.model.full_cover);
                p.density = std::min(p.density, eos.reference_density * std::max(open, filled));
            }
            p.volume = setup.fluid.mass[i] / p.density;
            p.pressure = (water ? setup.model.water : setup.model.air).eos.pressure(p.density);
        }
    }
};

}  // namespace

TEST_CASE("A step is half a kick, half a drift, density from the middle, half a drift, half a kick",
          "[time]") {
    Model model = samples::two_phase_model();
    model.wall_pressure =
        GENERATE(WallPressure::shepard_water, WallPressure::shepard, WallPressure::one_sided);
    model.wall_velocity = GENERATE(WallVelocity::mirrored, WallVelocity::normal);
    ByHand hand{samples::shaken_tank(model, 41), {}};
    Simulation simulation = hand.setup.simulate();
    const double dt = 1e-4;
    REQUIRE(dt < simulation.time_step().size);
    REQUIRE_FALSE(simulation.step(dt));

    hand.rates.density.resize(hand.setup.fluid.size());
    hand.compress(0);  // volume and pressure of the densities given
    hand.evaluate();
    hand.kick(0.5 * dt);
    hand.drift(0.5 * dt);
    hand.evaluate();
    hand.compress(dt);
    hand.drift(0.5 * dt);
    hand.evaluate();
    hand.kick(0.5 * dt);

    const std::vector<FluidState> states = samples::by_id(simulation.fluid());
    double position = 0, velocity = 0, density = 0, pressure = 0;
    for (std::size_t id = 0; id < states.size(); ++id) {
        const FluidState& expected = hand.setup.fluid.state[id];
        position = std::max(position, (states[id].position() - expected.position()).norm());
        velocity = std::max(velocity, (states[id].velocity() - expected.velocity()).norm());
        density = std::max(density, std::abs(states[id].density / expected.density - 1));
        pressure = std::max(pressure, std::abs(states[id].pressure - expected.pressure));
    }
    // rounding of values of the size of 1 m, 10 m/s and rho c^2 / gamma = 1.3e5 Pa
    CHECK(position < 1e-14);
    CHECK(velocity < 1e-12);
    CHECK(density < 1e-13);
    CHECK(pressure < 1e-8);
}
