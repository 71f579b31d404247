// SPDX-License-Identifier: BSD-3-Clause
// The same bits for any number of threads and any repetition.
#include <catch2/catch.hpp>
#include <cstring>

#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

/// A two-phase dam break with walls after 300 steps, by order in memory.
std::vector<FluidState> dam_break_states(const Model& model, int threads,
                                         Precision precision = Precision::double_precision) {
    samples::Setup setup = samples::dam_break(model, {0.3, 0.45}, {0.9, 0.6}, 0.03);
    setup.execution.threads = threads;
    setup.execution.precision = precision;
    Simulation simulation = setup.simulate();
    REQUIRE(simulation.threads() == threads);
    for (int n = 0; n < 300; ++n) REQUIRE_FALSE(simulation.step(1));
    REQUIRE(simulation.list_builds() > 5);
    return simulation.fluid().state;
}

bool same_bits(const std::vector<FluidState>& a, const std::vector<FluidState>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(FluidState)) == 0;
}

}  // namespace

TEST_CASE("A run gives the same bits with one, two and three threads and when it is repeated",
          "[determinism]") {
    Model model = samples::two_phase_model();
    model.dissipation_switch = GENERATE(false, true);
    if (!model.dissipation_switch) model.air_substeps = GENERATE(1, 3);
    const std::vector<FluidState> one = dam_break_states(model, 1);
    CHECK(same_bits(one, dam_break_states(model, 1)));
    CHECK(same_bits(one, dam_break_states(model, 2)));
    CHECK(same_bits(one, dam_break_states(model, 3)));
}

TEST_CASE(
    "A run in mixed precision gives the same bits with one, two and three threads, and others than in double",
    "[determinism][mixed]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    const std::vector<FluidState> one = dam_break_states(model, 1, Precision::mixed);
    CHECK(same_bits(one, dam_break_states(model, 2, Precision::mixed)));
    CHECK(same_bits(one, dam_break_states(model, 3, Precision::mixed)));
    CHECK_FALSE(same_bits(one, dam_break_states(model, 1)));
}

TEST_CASE("The comparison of bits sees a change in the last digit of one particle", "[determinism]") {
    samples::Setup setup = samples::dam_break(samples::two_phase_model(), {0.3, 0.45}, {0.9, 0.6}, 0.03);
    const std::vector<FluidState> before = setup.fluid.state;
    setup.fluid.state[17].vy = 1e-300;
    CHECK_FALSE(same_bits(before, setup.fluid.state));
}
