// SPDX-License-Identifier: BSD-3-Clause
// The sponge layer: its ramp, and what it does to rates.
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
    constexpr SpongeRamp other = SpongeRamp::larsen_dancy;
    CHECK(sponge_factor(0, 0.3, other) == Approx(0.01));
    CHECK(sponge_factor(0.3, 0.3, other) == 1);
    CHECK(sponge_factor(0.006, 0.3, other) == Approx(std::pow(100, -0.9)));
    CHECK(sponge_factor(0.2999, 0.3, other) == Approx(0.9765).epsilon(1e-3));
    CHECK(distance_to_wall({{0, 0}, {2, 1}}, 0.4, 0.7) == Approx(0.3));
    CHECK(distance_to_wall({{0, 0}, {2, 1}}, 2.1, 0.7) == Approx(-0.1));
}

TEST_CASE("Rates vanish at the wall and are left alone beyond the layer", "[sponge]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    samples::Setup setup = samples::shaken_tank(model, 5);
    const Simulation without = setup.simulate();
    setup.model.sponge_thickness = 0.2;
    setup.model.sponge_ramp = GENERATE(SpongeRamp::exponential, SpongeRamp::larsen_dancy);
    const Simulation with = setup.simulate();
    const auto plain = samples::rates_by_id(without.fluid()), soaked = samples::rates_by_id(with.fluid());
    const auto state = samples::by_id(with.fluid());
    std::size_t inside = 0;
    for (std::size_t id = 0; id < state.size(); ++id) {
        const double factor = sponge_factor(distance_to_wall(setup.domain, state[id].x, state[id].y), 0.2,
                                            setup.model.sponge_ramp);
        inside += factor < 1 ? 1 : 0;
        for (std::size_t k = 0; k < 3; ++k)
            CHECK(soaked[id][k] == Approx(factor * plain[id][k]).margin(1e-9));
    }
    CHECK(inside > 20);
    CHECK(inside < state.size());
}
