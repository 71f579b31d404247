// SPDX-License-Identifier: BSD-3-Clause
// Walls that water has not reached yet: nothing presses across the gap.
#include "solver/physics/wetting.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/setup/lattice.hpp"
#include "tests/support/reference_rates.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

constexpr double dx = 0.05;

Model water_alone() {
    Model model = samples::two_phase_model();
    model.water.eos.background_pressure = 0;
    model.wall_wetting = true;
    model.gravity = Vec2::Zero();
    return model;
}

/// A block of water that touches the floor, with a gap of so many spacings to the left wall, moving left and
/// down at 1 m/s.
samples::Setup block_beside_wall(const Model& model, double gap) {
    samples::Setup setup(model, {{0, 0}, {1.0, 0.8}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {0.5, 0.5}});
    for (FluidState& p : setup.fluid.state) {
        p.x += gap * dx;
        p.vx = p.vy = -1;
    }
    return setup;
}

/// Largest rate of compression [1/s] of the water in the middle of the block's left side.
double compression_at_wall(bool wetting, double gap) {
    Model model = water_alone();
    model.wall_wetting = wetting;
    const Simulation simulation = block_beside_wall(model, gap).simulate();
    double largest = 0;
    for (std::size_t i = 0; i < simulation.fluid().size(); ++i) {
        const FluidState& p = simulation.fluid().state[i];
        if (p.x < 0.3 && p.y > 0.2 && p.y < 0.3)
            largest = std::max(largest, simulation.fluid().density_rate[i] / p.density);
    }
    return largest;
}

}  // namespace

TEST_CASE("A wall is wetted when the gap has closed and stays so until half of the water has left",
          "[wetting]") {
    struct Row {
        double wetness, cover, after;
    };
    for (const Row& row : {Row{0, 0, 0},
                           {0, 0.5, 0},
                           {0, 0.93, 0},
                           {0, 0.97, 0.5},
                           {0, 1, 1},
                           {0, 1.2, 1},
                           {1, 0.97, 1},
                           {1, 0.51, 1},
                           {1, 0.49, 0},
                           {0.5, 0.6, 0.5},
                           {0.5, 0.955, 0.5},
                           {0.5, 0.985, 0.75},
                           {1, 0, 0}}) {
        CAPTURE(row.wetness, row.cover);
        CHECK(next_wetness(row.wetness, row.cover) == Approx(row.after).margin(1e-12));
    }
    CHECK(covered_share(0.3, 0.7) == Approx(1));
    CHECK(covered_share(0.15, 0.7) == Approx(0.5));
    CHECK(covered_share(0, 1) == 0);  // deep inside
}

TEST_CASE("Walls and the water that touches them fill the kernel", "[wetting]") {
    const Simulation simulation = block_beside_wall(water_alone(), 0).simulate();
    const WallParticles& walls = simulation.walls();
    std::size_t beside = 0;
    for (std::size_t w = 0; w < walls.size(); ++w) {
        CHECK(walls.own_sum[w] > 0.2);
        CHECK(walls.own_sum[w] <= 1);
        const WallState& s = walls.state[w];
        if (s.x > 0 || s.x < -dx || s.y < 0.1 || s.y > 0.35) continue;  // the first layer beside the block
        ++beside;
        double water = 0;
        for (const FluidState& p : simulation.fluid().state)
            water += p.volume * simulation.kernel().value((p.position() - Vec2(s.x, s.y)).norm());
        CHECK(walls.own_sum[w] + water == Approx(1).margin(0.02));
        CHECK(walls.mean[w].wetness == 1);
    }
    CHECK(beside == 5);
}

TEST_CASE("Water is not compressed by a wall that it has not reached", "[wetting]") {
    const double contact = compression_at_wall(true, 0);
    CHECK(contact == Approx(compression_at_wall(false, 0)));
    for (const double gap :
         {0.4, 0.6, 0.8, 1.0, 1.2}) {  // the support ends 2.5 spacings from the first layer
        CAPTURE(gap);
        CHECK(compression_at_wall(false, gap) > 1e-4 * contact);
        CHECK(std::abs(compression_at_wall(true, gap)) < 1e-6 * contact);
    }
}

TEST_CASE("Where air fills the gap, and in a periodic domain, every wall counts", "[wetting]") {
    samples::Setup with_air = block_beside_wall(water_alone(), 1);
    with_air.fill(Phase::air, {{0.8, 0.6}, {1.0, 0.8}});
    CHECK_FALSE(with_air.simulate().model().wall_wetting);
    CHECK(block_beside_wall(water_alone(), 1).simulate().model().wall_wetting);
    Model model = water_alone();
    model.periodic_x = true;
    samples::Setup periodic(model, {{0, 0}, {1.0, 0.8}}, dx, true);
    periodic.fill(Phase::water, {{0, 0}, {1.0, 0.5}});
    CHECK_FALSE(periodic.simulate().model().wall_wetting);
}

TEST_CASE("Rates beside dry and half-wetted walls are those of the plain sum", "[wetting][simd]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    const samples::ChosenInstructionSet chosen(name);
    samples::Setup setup = block_beside_wall(water_alone(), 0.4);
    verification::shake(setup, 0.2, 5);
    for (std::size_t w = 0; w < setup.walls.size(); ++w) {
        setup.walls.mean[w].wetness = 0.1 * static_cast<double>(w % 11);
        if (w % 3 == 0) setup.walls.state[w].nx = setup.walls.state[w].ny = 0;
    }
    const Simulation simulation = setup.simulate();
    const FluidParticles& fluid = simulation.fluid();
    const samples::Rates expected =
        samples::reference_rates(fluid, simulation.walls(), simulation.model(), dx);
    CHECK(samples::difference(fluid.density_rate, expected.density, 0, expected.density.size()) < 1e-11);
    CHECK(samples::difference(fluid.acceleration_x, expected.acceleration_x, 0,
                              expected.acceleration_x.size()) < 1e-11);
    setup.model.wall_wetting = false;
    CHECK(samples::difference(setup.simulate().fluid().density_rate, expected.density, 0,
                              expected.density.size()) > 1e-3);
}
