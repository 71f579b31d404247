// SPDX-License-Identifier: BSD-3-Clause
// The sponge layer: its ramp, and that it swallows sound.
#include "solver/physics/sponge.hpp"

#include <catch2/catch.hpp>

#include "tests/support/samples.hpp"

using namespace wetdeck;

TEST_CASE("The sponge's factor rises from zero at the wall to one beyond the layer", "[sponge]") {
    CHECK(sponge_factor(0, 0.3) == 0);
    CHECK(sponge_factor(-1, 0.3) == 0);
    CHECK(sponge_factor(0.3, 0.3) == 1);
    CHECK(sponge_factor(0.006, 0.3) == Approx(0.1));  // 1 - 0.9^1
    CHECK(sponge_factor(0.2999, 0.3) == Approx(1 - std::pow(0.9, 50)).epsilon(1e-3));
    CHECK(distance_to_wall({{0, 0}, {2, 1}}, 0.4, 0.7) == Approx(0.3));
    CHECK(distance_to_wall({{0, 0}, {2, 1}}, 2.1, 0.7) == Approx(-0.1));
}

TEST_CASE("Sound that meets a sponge does not come back", "[sponge]") {
    // a tank of water, compressed in its middle; the pulse has crossed half the tank twice when it is looked
    // for
    const auto largest_speed_after_return = [](double thickness) {
        Model model = samples::two_phase_model();
        model.gravity = Vec2::Zero();
        model.threads = 1;
        model.sponge_thickness = thickness;
        samples::Setup setup = samples::dam_break(model, {2.0, 0.2}, {2.0, 0.2}, 0.02, false);
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            FluidState& p = setup.fluid.state[i];
            const double raised = std::exp(-100 * (p.x - 1) * (p.x - 1));
            p.density *= 1 + 1e-4 * raised;
            setup.fluid.mass[i] = p.density * p.volume;
        }
        Simulation simulation = setup.simulate();
        const double end = 2.0 / model.water.eos.sound_speed;
        while (simulation.time() < end) REQUIRE_FALSE(simulation.step(end - simulation.time()));
        double fastest = 0;
        for (const FluidState& p : simulation.fluid().state) {
            if (std::abs(p.x - 1) < 0.4) fastest = std::max(fastest, p.velocity().norm());
        }
        return fastest;
    };
    CHECK(largest_speed_after_return(0.4) < 0.35 * largest_speed_after_return(0));
}
