// SPDX-License-Identifier: BSD-3-Clause
// Field frames name their particles in one order, whatever the order in memory.
#include "validation/run/field_frame.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "validation/run/assemble.hpp"

using namespace wetdeck;

TEST_CASE("A frame holds the ids from 0 on in order, and each particle in its place", "[execute]") {
    const Scene scene = read_scene(find_scene("wedge"));
    Simulation simulation = assemble(scene, scene.tiers.at("quick").begin()->second.front(), 1);
    for (int n = 0; n < 30; ++n) REQUIRE_FALSE(simulation.step(1));
    const FluidParticles& fluid = simulation.fluid();
    const WallParticles& walls = simulation.walls();
    REQUIRE_FALSE(std::is_sorted(fluid.id.begin(), fluid.id.end()));  // else nothing is shown here
    const FieldFrame frame = frame_of(simulation, "");
    REQUIRE(frame.id.size() == fluid.size() + walls.size());
    for (std::size_t k = 0; k < frame.id.size(); ++k) REQUIRE(frame.id[k] == static_cast<std::int64_t>(k));
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        REQUIRE(frame.x[fluid.id[i]] == static_cast<float>(fluid.state[i].x));
        REQUIRE(frame.phase[fluid.id[i]] == static_cast<int>(fluid.phase(i)));
    }
    for (std::size_t i = 0; i < walls.size(); ++i) {
        REQUIRE(frame.y[fluid.size() + walls.id[i]] == static_cast<float>(walls.state[i].y));
        REQUIRE(frame.phase[fluid.size() + walls.id[i]] >= 2);
    }
}
