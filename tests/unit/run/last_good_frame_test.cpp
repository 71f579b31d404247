// SPDX-License-Identifier: BSD-3-Clause
// How often the state of a run is kept for the case that it becomes unstable.
#include "validation/run/last_good_frame.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"

using namespace wetdeck;

TEST_CASE("a frame is kept at intervals and more often at the start", "[run]") {
    const LastGoodFrame last_good(16);
    std::vector<std::uint64_t> due;
    for (std::uint64_t steps = 1; steps <= 50; ++steps) {
        if (last_good.due(steps)) due.push_back(steps);
    }
    CHECK(due == std::vector<std::uint64_t>{1, 2, 4, 8, 16, 32, 48});
}

TEST_CASE("the interval is shorter where the air takes several steps in one", "[run]") {
    const auto interval = [](const char* variant, std::uint64_t least) {
        const Scene scene = parse_scene(samples::small_scene, "small.toml", variant);
        return inspection_interval(assemble(scene, 0.04, 1), 256, least);
    };
    CHECK(interval("single-phase", 1) == 256);
    CHECK(interval("two-phase", 1) == 64);  // three steps of the air in one of the water
    CHECK(interval("two-phase", 100) == 100);
}

TEST_CASE("the kept frame is that of the last step at which one was due", "[run]") {
    const Scene scene = parse_scene(samples::small_scene, "small.toml", "single-phase");
    Simulation simulation = assemble(scene, 0.04, 1);
    LastGoodFrame last_good(4);
    double kept = -1;
    for (int step = 0; step < 7; ++step) {
        REQUIRE_FALSE(simulation.step(1));
        if (last_good.update(simulation, "test")) kept = simulation.time();
    }
    CHECK(last_good.frame().time == kept);
    CHECK(kept < simulation.time());
    CHECK(last_good.frame().provenance == "test");
}
