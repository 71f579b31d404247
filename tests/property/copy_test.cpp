// SPDX-License-Identifier: BSD-3-Clause
// A copy of a simulation is a simulation of its own.
#include <catch2/catch.hpp>
#include <cstring>
#include <memory>

#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

/// Rates of the present state, evaluated anew, by particle.
std::vector<std::array<double, 3>> evaluated(Simulation& simulation) {
    simulation.evaluate();
    return samples::rates_by_id(simulation.fluid());
}

void step(Simulation& simulation, int count) {
    for (int n = 0; n < count; ++n) REQUIRE_FALSE(simulation.step(1));
}

}  // namespace

TEST_CASE("A copied simulation does not notice the steps of the original", "[copy]") {
    Model model = samples::two_phase_model();
    model.periodic_x = GENERATE(false, true);
    Simulation original = samples::shaken_tank(model, 17).simulate();
    Simulation copy = original;
    const auto before = evaluated(copy);
    const std::uint64_t builds = original.list_builds();
    while (original.list_builds() < builds + 3) step(original, 1);
    CHECK(evaluated(copy) == before);
    CHECK(copy.time() == 0);
}

TEST_CASE("A copied simulation goes on with the same bits, also when the original is gone", "[copy]") {
    auto original =
        std::make_unique<Simulation>(samples::shaken_tank(samples::two_phase_model(), 18).simulate());
    step(*original, 20);
    Simulation copy = *original, assigned = samples::shaken_tank(samples::two_phase_model(), 19).simulate();
    assigned = *original;
    step(*original, 40);
    const std::vector<FluidState> expected = samples::by_id(original->fluid());
    original.reset();
    step(copy, 40);
    step(assigned, 40);
    for (const Simulation* one : {&copy, &assigned}) {
        const std::vector<FluidState> found = samples::by_id(one->fluid());
        REQUIRE(found.size() == expected.size());
        CHECK(std::memcmp(found.data(), expected.data(), found.size() * sizeof(FluidState)) == 0);
    }
}

TEST_CASE("A copied neighbour list keeps its neighbours when the original is built again", "[copy]") {
    samples::Setup setup = samples::shaken_tank(samples::two_phase_model(), 20);
    const double support = 2 * setup.model.smoothing_ratio * setup.particle_spacing;
    const NearFilter near = pair_passes(setup.model).filter_near;
    NeighbourList original(setup.domain, setup.particle_spacing, support, 0.1 * support, true);
    original.sort_fixed_walls(setup.walls);
    original.build(setup.fluid, setup.walls, near, 1);
    const NeighbourList copy = original;
    const Cluster cluster = copy.clusters().front();
    const Neighbours listed = fluid_neighbours(copy.blocks(), cluster, 0);
    const std::vector<std::uint32_t> before(listed.begin(), listed.end());
    for (FluidState& p : setup.fluid.state) p.x = 1 - p.x;
    original.build(setup.fluid, setup.walls, near, 1);
    const Neighbours after = fluid_neighbours(copy.blocks(), copy.clusters().front(), 0);
    CHECK(std::vector<std::uint32_t>(after.begin(), after.end()) == before);
    CHECK(copy.blocks() != original.blocks());
}
