// SPDX-License-Identifier: BSD-3-Clause
// Slips that make a sound scene file of another meaning.
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/scene/plausibility.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

/// The small scene with a plate of 0.2 x 0.05 m, 5 kg/m, at rest.
std::vector<std::string> doubts_of(const std::vector<std::string>& overrides) {
    const std::string plate =
        "[body]\noutline = [[0.1, 0.3], [0.3, 0.3], [0.3, 0.35], [0.1, 0.35]]\nposition = [0.0, 0.0]\n"
        "free = [\"y\"]\nmass = 5.0\n\n[initial]\n";
    return doubtful(parse_scene(samples::with("[initial]\n", plate), "small.toml", std::nullopt, overrides));
}

}  // namespace

TEST_CASE("the scenes that come with the program mean what they say") {
    for (const std::string& name : scene_names()) {
        const Scene scene = read_scene(find_scene(name));
        CAPTURE(name);
        for (const VariantInfo& variant : scene.variants) {
            const std::vector<std::string> doubts = doubtful(read_scene(find_scene(name), variant.name));
            const bool sinks = name == "sinking_rectangle";
            if (!sinks) CHECK(doubts.empty());
        }
    }
}

TEST_CASE("a plate in the air of a sensible mass is not doubted") {
    CHECK(doubts_of({}).empty());
}

TEST_CASE("water that the fall compresses by more than a percent is doubted") {
    // falls 0.1 m to the surface: 1.4 m/s more than the velocity that it has
    const auto doubts = doubts_of({"body.velocity_y=-1.5"});
    REQUIRE(doubts.size() == 1);
    CHECK_THAT(doubts[0], Contains("water.sound_speed is 14 m/s") && Contains("2.05 m/s"));
}

TEST_CASE("a body that starts in the water is told") {
    const auto doubts = doubts_of({"body.outline=[[0.1, 0.1], [0.3, 0.1], [0.3, 0.35], [0.1, 0.35]]"});
    REQUIRE(doubts.size() == 1);
    CHECK_THAT(doubts[0], Contains("starts in the water"));
}

TEST_CASE("a mass in tonnes or grams is doubted") {
    for (const char* mass : {"body.mass=0.005", "body.mass=5000.0"}) {
        const auto doubts = doubts_of({mass});
        REQUIRE(doubts.size() == 1);
        CHECK_THAT(doubts[0], Contains("times the mass of the water it would displace"));
    }
}

TEST_CASE("a background pressure of the order of the air's stiffness is doubted") {
    const double stiffness =
        parse_scene(samples::small_scene, "small.toml", std::nullopt, {}).model.air.eos.coefficient();
    const auto doubts = [](double pressure) {
        return doubts_of({"model.background_pressure=" + std::to_string(pressure)});
    };
    CHECK(doubts(0.49 * stiffness).empty());
    REQUIRE(doubts(0.51 * stiffness).size() == 1);
    CHECK_THAT(doubts(0.51 * stiffness)[0], Contains("the air's own stiffness"));
}
