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
    std::vector<bool> slow;        ///< which particles take the whole step
    samples::Rates all, own = {};  ///< own: what slow fluid gets from slow fluid, walls and gravity

    bool graded() const { return setup.coarsest > 1; }

    samples::Rates rates_of(const FluidParticles& fluid) const {
        return samples::reference_rates(fluid, setup.walls, setup.model, setup.particle_spacing, graded());
    }
    void evaluate() {
        all = rates_of(setup.fluid);
        FluidParticles alone;
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            if (!slow[i]) continue;
            numbers.push_back(i);
            alone.state.push_back(setup.fluid.state[i]);
            alone.mass.push_back(setup.fluid.mass[i]);
        }
        alone.water = alone.size();
        const samples::Rates rates = rates_of(alone);
        const auto spread = [&](const std::vector<double>& of_slow, std::vector<double>& values) {
            values.assign(setup.fluid.size(), 0.0);
            for (std::size_t n = 0; n < numbers.size(); ++n) values[numbers[n]] = of_slow[n];
        };
        spread(rates.density, own.density);
        spread(rates.acceleration_x, own.acceleration_x);
        spread(rates.acceleration_y, own.acceleration_y);
    }
    /// A rate times a time, its own part times another.
    static double gain(double rate, double own_rate, double time, double own_time) {
        return time * (rate - own_rate) + own_time * own_rate;
    }
    void kick(double time, double own_time) {
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            FluidState& p = setup.fluid.state[i];
            p.vx += gain(all.acceleration_x[i], own.acceleration_x[i], time, own_time);
            p.vy += gain(all.acceleration_y[i], own.acceleration_y[i], time, own_time);
        }
    }
    void drift(double time) {
        for (FluidState& p : setup.fluid.state) {
            p.x += time * p.vx;
            p.y += time * p.vy;
        }
    }
    /// The kernel sum bounds the density of water in the steps in which its neighbours are summed.
    double highest_density(std::size_t i) const {
        const TaitEquationOfState& eos = setup.model.water.eos;
        const double spacing = setup.particle_spacing / (graded() ? setup.fluid.state[i].fineness : 1);
        const double weight = setup.model.gravity.norm() * spacing;
        const double open = 1 + weight / (eos.sound_speed * eos.sound_speed);
        const double filled = 1 + kernel_sum_steepness * (all.kernel_sum[i] - setup.model.full_kernel_sum);
        return eos.reference_density * std::max(open, filled);
    }
    void compress(double time, double own_time) {
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            const bool water = setup.fluid.phase(i) == Phase::water;
            FluidState& p = setup.fluid.state[i];
            if (time > 0) p.density += gain(all.density[i], own.density[i], time, own_time);
            if (water && (slow[i] ? own_time : time) > 0) p.density = std::min(p.density, highest_density(i));
            p.volume = setup.fluid.mass[i] / p.density;
            p.pressure = (water ? setup.model.water : setup.model.air).eos.pressure(p.density);
        }
    }
    /// One step of the slow fluid.
    void step(double dt, int count) {
        const double whole = dt * count;
        compress(0, 0);  // volume and pressure of the densities given
        evaluate();
        for (int n = 0; n < count; ++n) {
            kick(0.5 * dt, n == 0 ? 0.5 * whole : 0);
            drift(0.5 * dt);
            evaluate();
            compress(dt, n == count / 2 ? whole : 0);
            drift(0.5 * dt);
            evaluate();
            kick(0.5 * dt, n == count - 1 ? 0.5 * whole : 0);
        }
    }
};

void check_step(ByHand hand, int count) {
    Simulation simulation = hand.setup.simulate();
    REQUIRE(simulation.substeps() == count);
    const double dt = 1e-4, whole = dt * count;
    REQUIRE(whole < simulation.time_step().size);
    REQUIRE_FALSE(simulation.step(whole));
    CHECK(simulation.time() == whole);
    hand.step(dt, count);

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
    samples::Setup setup = samples::shaken_tank(model, 41);
    std::vector<bool> water(setup.fluid.size(), false);
    std::fill_n(water.begin(), setup.fluid.water, true);
    check_step({std::move(setup), std::move(water), {}}, model.air_substeps);
}

TEST_CASE("Fine water takes several steps in one of water that is so many times coarser", "[time][graded]") {
    Model model = samples::two_phase_model();
    model.coarse_substeps = GENERATE(1, 3);
    model.wall_wetting = false;
    // walls with means of the water would be others for coarse water by itself
    model.wall_pressure = WallPressure::one_sided;
    model.wall_velocity = WallVelocity::normal;
    samples::Setup setup = samples::graded_water(model, 41);
    std::vector<bool> slow;
    for (const FluidState& p : setup.fluid.state)
        slow.push_back(model.coarse_substeps == 1 || p.fineness <= 1.0 / model.coarse_substeps);
    const auto count = std::count(slow.begin(), slow.end(), true);
    REQUIRE(count > 20);
    check_step({std::move(setup), std::move(slow), {}}, model.coarse_substeps);
}
