// SPDX-License-Identifier: BSD-3-Clause
// Pressures of walls around water at rest.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/setup/initial_pressure.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::two_phase_model;

TEST_CASE("In water at rest every wall that touches it has the hydrostatic pressure at its own height",
          "[wall]") {
    Model model = two_phase_model();
    model.wall_pressure = GENERATE(WallPressure::shepard, WallPressure::shepard_water);
    model.gravity = GENERATE(Vec2(0, -9.81), Vec2(3, -7));
    samples::Setup setup = samples::dam_break(model, {0.6, 0.6}, {0.6, 0.6}, 0.03, false);
    const auto gauge = [&](Vec2 at) { return 1000 * model.gravity.dot(at - Vec2(0.6, 0.6)); };
    set_initial_pressure(setup.fluid, model, [&](Phase, Vec2 at) { return gauge(at); });
    const Simulation simulation = setup.simulate();
    double worst = 0;
    std::size_t seen = 0;
    for (const Cluster& c : simulation.neighbours().wall_clusters()) {
        for (std::uint32_t w = c.first; w < c.first + c.count; ++w) {
            if (simulation.walls().mean[w].pressure == 0) continue;  // beyond the support of all fluid
            const WallState& wall = simulation.walls().state[w];
            worst = std::max(worst,
                             std::abs(simulation.walls().mean[w].pressure - 1000 - gauge({wall.x, wall.y})));
            ++seen;
        }
    }
    CHECK(seen > 150);
    // The fluid's densities are not the reference: by up to 0.7 %, over two spacings of height.
    CHECK(worst < 0.01 * 1000 * model.gravity.norm() * 2 * setup.particle_spacing);
}

TEST_CASE("Water at rest under hydrostatic pressure has next to no acceleration at walls", "[wall]") {
    Model model = two_phase_model();
    model.wall_pressure =
        GENERATE(WallPressure::one_sided, WallPressure::shepard, WallPressure::shepard_water);
    const Simulation simulation = samples::dam_break(model, {0.6, 0.6}, {0.6, 0.6}, 0.03, false).simulate();
    const FluidParticles& fluid = simulation.fluid();
    double worst = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        worst = std::max(worst, std::hypot(fluid.acceleration_x[i], fluid.acceleration_y[i]));
    }
    // Measured 1.25 m/s^2: sums over a lattice whose volumes differ by 1 %. Pressures of the wrong sign make
    // it g.
    CHECK(worst < 0.25 * 9.81);
}
