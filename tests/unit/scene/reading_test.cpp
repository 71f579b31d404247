// SPDX-License-Identifier: BSD-3-Clause
// What a scene file says and what the scene then holds: defaults, variants, overrides.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/scene/identity.hpp"

using namespace wetdeck;
using samples::small_scene;

namespace {

Scene read(const std::vector<std::string>& overrides = {}, const std::string& variant = "two-phase") {
    return parse_scene(small_scene, "small.toml", variant, overrides);
}

}  // namespace

TEST_CASE("a scene holds what its file says") {
    const Scene scene = parse_scene(small_scene, "small.toml");
    REQUIRE(scene.name() == "small");
    REQUIRE(scene.variant == "two-phase");
    REQUIRE(scene.tank.high == Vec2(1.0, 0.48));
    REQUIRE(scene.model.gravity == Vec2(0, -9.81));
    REQUIRE(scene.model.water.eos.sound_speed == 14);
    REQUIRE(scene.model.air.eos.sound_speed == 70);
    REQUIRE(scene.water_boxes.size() == 1);
    REQUIRE(scene.air_boxes.size() == 2);
    REQUIRE(scene.air_boxes[1].low == Vec2(0, 0.2));
    REQUIRE(scene.text == small_scene);
    REQUIRE(scene.path == "small.toml");
}

TEST_CASE("probes, quantities, comparisons and deviations are read with their scales") {
    const Scene scene = read();
    REQUIRE(scene.probes.size() == 3);
    REQUIRE((scene.probes[1].place->begin - Vec2(1.0, 0.06)).norm() < 1e-12);
    REQUIRE(scene.probes[1].series.description ==
            "gauge pressure, chord-weighted mean over a disc of 0.08 m at (1, 0.1) m; ");
    REQUIRE(scene.probes[2].series.description == "depth of water at x = 0.3 m over a width of 0.08 m");
    const QuantitySpec& quantity = scene.analysis.quantities.at(0);
    REQUIRE(quantity.x_scale == 0.1428);
    REQUIRE(quantity.y_scale == 0.2);
    REQUIRE(quantity.window->begin == 0.2);
    REQUIRE_FALSE(quantity.expected);
    const ComparisonSpec& comparison = scene.analysis.comparisons.at(0);
    REQUIRE(comparison.tolerance == 0.1);
    REQUIRE(comparison.y_label == "x");  // the column where no label is given
    REQUIRE(scene.analysis.deviations.at(0).reason == "tests are quick");
    REQUIRE(scene.analysis.error_quantity == "front_mean");
}

TEST_CASE("what a scene leaves out of [model] is the solver's default") {
    const Scene scene = read();
    const Model usual;
    REQUIRE(scene.model.velocity_mean == usual.velocity_mean);
    REQUIRE(scene.model.dissipation == usual.dissipation);
    REQUIRE(scene.model.wall_pressure == usual.wall_pressure);
    REQUIRE(scene.model.smoothing_ratio == usual.smoothing_ratio);
    REQUIRE(scene.model.courant_number == usual.courant_number);
    REQUIRE(scene.model.negative_pressure == usual.negative_pressure);
    REQUIRE(scene.model.air_substeps == 0);  // as the sound speeds go
    REQUIRE(scene.execution.skin == 0);      // chosen as the run goes
}

TEST_CASE("frames are the listed ones, the start and the end, sorted and once each") {
    REQUIRE(read().frame_times == std::vector<double>{0, 0.05, 0.1, 0.2});
    REQUIRE(read().picture_times == std::vector<double>{0.05, 0.1});
    REQUIRE(read({"run.frame_interval=0.1"}).frame_times == std::vector<double>{0, 0.05, 0.1, 0.2});
    REQUIRE(read({"run.frames=[0.2, 0.1, 0.1]"}).frame_times == std::vector<double>{0, 0.1, 0.2});
}

TEST_CASE("spacings of a tier run from coarse to fine") {
    REQUIRE(read().tiers.at("quick").at("single-phase") == std::vector<double>{0.04, 0.02});
}

TEST_CASE("a variant lies over the scene entry by entry") {
    const Scene scene = read({}, "single-phase");
    REQUIRE(scene.variant == "single-phase");
    REQUIRE_FALSE(scene.air);
    REQUIRE(scene.model.water.eos.background_pressure == 0);
    REQUIRE(scene.model.water.eos.sound_speed == 14);  // untouched
    REQUIRE(scene.variants.size() == 2);
    REQUIRE(scene.variants[1].description == "water alone");
    REQUIRE(scene.analysis.default_variant == "two-phase");
}

TEST_CASE("an override replaces a number, also one that the file leaves out") {
    REQUIRE(read({"run.end_time=0.3"}).end_time == 0.3);
    REQUIRE(read({"run.end_time=1"}).end_time == 1);  // an integer is a number
    REQUIRE(read({"model.smoothing_ratio=1.3"}).model.smoothing_ratio == 1.3);
}

TEST_CASE("an override replaces a boolean") {
    REQUIRE_FALSE(read({"model.air=false"}).air);
    REQUIRE_FALSE(read({"model.negative_pressure=false"}).model.negative_pressure);
}

TEST_CASE("an override takes a text in quotes and a bare word alike") {
    const Mean harmonic = Mean::harmonic;
    REQUIRE(read({"model.velocity_mean=\"harmonic\""}).model.velocity_mean == harmonic);
    REQUIRE(read({"model.velocity_mean=harmonic"}).model.velocity_mean == harmonic);
    REQUIRE(read({"model.velocity_mean=density-weighted"}).model.velocity_mean == Mean::density_weighted);
}

TEST_CASE("an override takes a list") {
    REQUIRE(read({"gravity=[1.0, -2.0]"}).model.gravity == Vec2(1, -2));
}

TEST_CASE("overrides win over the variant, and a later one over an earlier one") {
    REQUIRE(read({"model.background_pressure=7"}, "single-phase").model.water.eos.background_pressure == 7);
    REQUIRE(read({"run.end_time=0.3", "run.end_time=0.4"}).end_time == 0.4);
}

TEST_CASE("the laws of the air's sound speed") {
    REQUIRE(read({"air.law=physical"}).model.air.eos.sound_speed == Approx(std::sqrt(1.4 * 101325)));
    // rho c^2 / gamma the same in water and air
    REQUIRE(read({"air.law=equal-coefficient"}).model.air.eos.sound_speed ==
            Approx(std::sqrt(1000 * 14.0 * 14.0 / 7 * 1.4 / 1)));
}

TEST_CASE("the resolved text tells runs apart that differ by variant or override, and only those") {
    const std::string plain = read().resolved;
    REQUIRE(plain == read().resolved);
    REQUIRE(plain != read({"run.end_time=0.3"}).resolved);
    REQUIRE(plain != read({}, "single-phase").resolved);
    REQUIRE(plain == parse_scene("# a remark\n" + small_scene, "elsewhere.toml", "two-phase").resolved);
}

TEST_CASE("The arrangement of the particles is the lattice unless a scene says otherwise", "[scene]") {
    CHECK(parse_scene(small_scene, "small.toml").arrangement == 0);
    const Scene other = parse_scene(small_scene, "small.toml", {}, {"initial.arrangement=7"});
    CHECK(other.arrangement == 7);
    CHECK(setup_identity(other) != setup_identity(parse_scene(small_scene, "small.toml")));
    const char* value = GENERATE("-1", "1.5", "2e9", "\"first\"");
    CHECK_THROWS_WITH(
        parse_scene(small_scene, "small.toml", {}, {std::string("initial.arrangement=") + value}),
        Catch::Contains("initial.arrangement"));
}
