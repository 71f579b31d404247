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
    samples::Rates all, own;  ///< own: what water gets from water, walls and gravity

    void evaluate() {
        all = samples::reference_rates(setup.fluid, setup.walls, setup.model, setup.particle_spacing);
        FluidParticles water = setup.fluid;
        water.state.resize(water.water);
        water.mass.resize(water.water);
        own = samples::reference_rates(water, setup.walls, setup.model, setup.particle_spacing);
    }
    /// A rate times a time, its own part times another.
    double gain(double rate, const std::vector<double>& own_rates, std::size_t i, double time,
                double own_time) const {
        const double own_rate = i < setup.fluid.water ? own_rates[i] : 0;
        return time * (rate - own_rate) + own_time * own_rate;
    }
    void kick(double time, double own_time) {
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            FluidState& p = setup.fluid.state[i];
            p.vx += gain(all.acceleration_x[i], own.acceleration_x, i, time, own_time);
            p.vy += gain(all.acceleration_y[i], own.acceleration_y, i, time, own_time);
        }
    }
    void drift(double time) {
        for (FluidState& p : setup.fluid.state) {
            p.x += time * p.vx;
            p.y += time * p.vy;
        }
    }
    void compress(double time, double own_time) {
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            const bool water = setup.fluid.phase(i) == Phase::water;
            FluidState& p = setup.fluid.state[i];
            if (time > 0) p.density += gain(all.density[i], own.density, i, time, own_time);
            if (water && own_time > 0) {
                const TaitEquationOfState& eos = setup.model.water.eos;
                const double weight = setup.model.gravity.norm() * setup.particle_spacing;
                const double open = 1 + weight / (eos.sound_speed * eos.sound_speed);
                const double filled =
                    1 + kernel_sum_steepness * (all.kernel_sum[i] - setup.model.full_kernel_sum);
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
    model.air_substeps = GENERATE(1, 3, 5);
    model.wall_wetting = false;  // as with air, where the water is evaluated by itself, too
    model.wall_pressure = GENERATE(WallPressure::shepard_water, WallPressure::one_sided);
    model.wall_velocity = GENERATE(WallVelocity::mirrored, WallVelocity::normal);
    // with this one, water that the air is left out for meets other walls
    if (model.air_substeps == 1 && model.wall_pressure == WallPressure::one_sided)
        model.wall_pressure = GENERATE(WallPressure::shepard, WallPressure::one_sided);
    ByHand hand{samples::shaken_tank(model, 41), {}, {}};
    Simulation simulation = hand.setup.simulate();
    const int all = model.air_substeps;
    const double dt = 1e-4, whole = dt * all;
    REQUIRE(whole < simulation.time_step().size);
    REQUIRE_FALSE(simulation.step(whole));
    CHECK(simulation.time() == whole);

    hand.compress(0, 0);  // volume and pressure of the densities given
    hand.evaluate();
    for (int n = 0; n < all; ++n) {
        hand.kick(0.5 * dt, n == 0 ? 0.5 * whole : 0);
        hand.drift(0.5 * dt);
        hand.evaluate();
        hand.compress(dt, n == all / 2 ? whole : 0);
        hand.drift(0.5 * dt);
        hand.evaluate();
        hand.kick(0.5 * dt, n == all - 1 ? 0.5 * whole : 0);
    }

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
