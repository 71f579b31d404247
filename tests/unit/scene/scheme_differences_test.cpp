// SPDX-License-Identifier: BSD-3-Clause
// The list of keys in which a variant differs from the scheme of its source.
#include "validation/scene/scheme_differences.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "validation/scene/plausibility.hpp"

using namespace wetdeck;

namespace {

std::vector<std::string> keys(const std::string& scene, const std::string& variant,
                              const std::vector<std::string>& overrides = {}) {
    std::vector<std::string> all;
    for (const SchemeDifference& d : scheme_differences(read_scene(find_scene(scene), variant, overrides)))
        all.push_back(d.key);
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE("The printed scheme does not differ from that of the source, and its readings in what they change",
          "[scene]") {
    const std::string scene = GENERATE("dam_break", "wedge", "flat_plate", "catamaran", "sinking_rectangle");
    CAPTURE(scene);
    CHECK(keys(scene, "paper-literal").empty());
    CHECK(keys(scene, "paper") == std::vector<std::string>{"model.mean_guard", "model.wall_velocity"});
    CHECK(keys(scene, "paper-no-switch") ==
          std::vector<std::string>{"model.dissipation_switch", "model.mean_guard", "model.wall_velocity"});
    CHECK(keys(scene, "paper-central") ==
          std::vector<std::string>{"model.mean_guard", "model.pressure_mean", "model.velocity_mean",
                                   "model.wall_pair_mean", "model.wall_velocity"});
}

TEST_CASE("A difference names both values and the equation", "[scene]") {
    const auto all = scheme_differences(
        read_scene(find_scene("dam_break"), "paper-literal", {"model.smoothing_ratio=1.4"}));
    REQUIRE(all.size() == 1);
    CHECK(all[0].key == "model.smoothing_ratio");
    CHECK(all[0].source == "1.25");
    CHECK(all[0].used == "1.4");
    CHECK(all[0].equation == "Eq. (7)");
}

TEST_CASE("The default scheme's differences include its air, its means and its bounds", "[scene]") {
    const std::vector<std::string> all = keys("dam_break", "two-phase");
    for (const char* key : {"air.sound_speed", "model.velocity_mean", "model.smoothing_ratio",
                            "model.dissipation", "model.full_kernel_sum", "model.wall_velocity"}) {
        CAPTURE(key);
        CHECK(std::find(all.begin(), all.end(), key) != all.end());
    }
    const std::vector<std::string> catamaran = keys("catamaran", "air-model-1");
    CHECK(std::find(catamaran.begin(), catamaran.end(), "model.air_substeps") != catamaran.end());
}

TEST_CASE("A scene without a source scheme has no such list, and an unknown one is refused", "[scene]") {
    CHECK(scheme_differences(read_scene(find_scene("wedge_yettou"))).empty());
    CHECK_THROWS_WITH(read_scene(find_scene("dam_break"), std::nullopt, {"source_scheme=kraken"}),
                      Catch::Contains("source_scheme") && Catch::Contains("yang2020-literal"));
}

TEST_CASE("A fixed step beyond the criterion is doubtful, at each spacing by itself", "[scene]") {
    const Scene scene = read_scene(find_scene("flat_plate"), "paper-no-switch",
                                   {"model.fixed_step=1.5e-5", "model.air_substeps=1"});
    // printed for the plate: h = 2.5 mm, c_air = 848.5 m/s
    const std::vector<std::string> doubts = doubts_at_spacing(scene, 0.002);
    REQUIRE(doubts.size() == 1);
    CHECK_THAT(doubts[0], Catch::Contains("20.4 times the stable step of 7.37e-07 s"));
    CHECK(doubts_at_spacing(scene, 0.05).empty());
    CHECK(doubts_at_spacing(read_scene(find_scene("flat_plate")), 0.002).empty());
}
