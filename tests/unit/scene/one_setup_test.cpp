// SPDX-License-Identifier: BSD-3-Clause
// Runs of another set-up than that of the latest run of their scene are left out, with what differs.
#include "validation/scene/one_setup.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <utility>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/scene/identity.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::small_scene;

namespace {

/// A stored run; `started` orders the runs in time.
RunSummary stored(const std::string& text, const std::string& variant, int started,
                  const std::vector<std::string>& overrides = {}) {
    RunSummary run;
    RunRecord& r = run.record;
    r.scene = "small";
    r.variant = variant;
    r.scene_text = text;
    r.scene_path = "small.toml";
    r.parameters["scheme_revision"] = 3;
    r.provenance = {{"setup_identity", setup_identity(parse_scene(text, "small.toml", variant, overrides))},
                    {"base_setup_identity", setup_identity(parse_scene(text, "small.toml", variant))},
                    {"overrides", fmt::format("{}", fmt::join(overrides, "; "))},
                    {"start_time", fmt::format("2026-01-{:02}", started)}};
    run.directory = fmt::format("runs/{}-{}", variant, started);
    return run;
}

std::vector<LeftOutRun> left_out_of(std::vector<RunSummary> runs, std::vector<SensitivityRun> varied = {}) {
    const std::size_t all = runs.size() + varied.size();
    std::vector<LeftOutRun> out = leave_out_other_setups(runs, varied);
    CHECK(runs.size() + varied.size() + out.size() == all);
    return out;
}

}  // namespace

TEST_CASE("Each edit of a scene that changes its set-up leaves the earlier run out and is named",
          "[one-setup]") {
    const std::vector<std::array<std::string, 3>> edits = {
        {"sound_speed = 14.0", "sound_speed = 15.0", "water.sound_speed is 14.0, in the latest run 15.0"},
        {"density = 1000.0", "density = 1025.0", "water.density is 1000.0, in the latest run 1025.0"},
        {"exponent = 7.0", "exponent = 6.0", "water.exponent is 7.0, in the latest run 6.0"},
        {"size = [1.0, 0.48]", "size = [1.0, 0.50]", "tank.1 is 0.48, in the latest run 0.5"},
        {"[[0.0, 0.0, 0.4, 0.2]]", "[[0.0, 0.0, 0.3, 0.2]]",
         "water_boxes.0.1.0 is 0.4, in the latest run 0.3"},
        {"background_pressure = 500.0", "background_pressure = 400.0",
         "model.background_pressure is 500.0, in the latest run 400.0"},
        {"end_time = 0.2", "end_time = 0.3", "end_time is 0.2, in the latest run 0.3"},
        {"sample_interval = 0.002", "sample_interval = 0.001",
         "sample_interval is 0.002, in the latest run 0.001"},
        {"frames = [0.05, 0.1]", "frames = [0.06, 0.1]", "frame_times.1 is 0.05, in the latest run 0.06"},
        {"gravity = [0.0, -9.81]", "gravity = [0.0, -9.8]", "gravity_y is -9.81, in the latest run -9.8"},
        {"air = true", "air = true\nsmoothing_ratio = 1.3",
         "model.smoothing_ratio is 1.5, in the latest run 1.3"}};
    for (const auto& [original, other, words] : edits) {
        INFO(other);
        const auto out = left_out_of(
            {stored(small_scene, "two-phase", 1), stored(samples::with(original, other), "two-phase", 2)});
        REQUIRE(out.size() == 1);
        CHECK(out[0].directory == "runs/two-phase-1");
        CHECK(out[0].differences.at(0) == words);
    }
}

TEST_CASE("A variant that was not run again after an edit is left out as well", "[one-setup]") {
    const std::string now = samples::with("sound_speed = 14.0", "sound_speed = 15.0");
    const auto out = left_out_of({stored(small_scene, "single-phase", 1), stored(now, "two-phase", 2)});
    REQUIRE(out.size() == 1);
    CHECK(out[0].variant == "single-phase");
    CHECK_THAT(out[0].differences.at(0), Contains("water.sound_speed is 14.0"));
}

TEST_CASE("The latest run speaks, whatever the order of the folders; labels make no other set-up",
          "[one-setup]") {
    const std::string other = samples::with("sound_speed = 14.0", "sound_speed = 15.0");
    CHECK(left_out_of({stored(small_scene, "two-phase", 3), stored(other, "two-phase", 2)}).at(0).directory ==
          "runs/two-phase-2");
    const std::string titled = samples::with("A small column", "A column");
    CHECK(left_out_of({stored(small_scene, "two-phase", 1), stored(titled, "two-phase", 2)}).empty());
    CHECK(left_out_of({stored(small_scene, "single-phase", 1), stored(titled, "two-phase", 2)}).empty());
}

TEST_CASE("Runs with keys set by hand, of another revision of the scheme or of a lost variant are left out",
          "[one-setup]") {
    const RunSummary latest = stored(small_scene, "two-phase", 2);
    const auto by_hand = left_out_of(
        {stored(small_scene, "two-phase", 1, {"water.sound_speed=16", "model.air_substeps=5"}), latest});
    REQUIRE(by_hand.size() == 1);
    CHECK_THAT(by_hand[0].differences.at(1), Contains("water.sound_speed is 16.0"));

    RunSummary old_scheme = stored(small_scene, "two-phase", 1);
    old_scheme.record.parameters["scheme_revision"] = 2;
    old_scheme.record.provenance["setup_identity"] = "0123";
    CHECK(left_out_of({old_scheme, latest}).at(0).differences.at(0) ==
          "the revision of the numerical scheme is 2, in the latest run 3");

    RunSummary other_file = stored(small_scene, "two-phase", 1);
    other_file.record.provenance["setup_identity"] = "4567";
    CHECK_THAT(left_out_of({other_file, latest}).at(0).differences.at(0),
               Contains("a file that the scene names"));

    std::string renamed = small_scene;
    for (std::size_t at; (at = renamed.find("single-phase")) != std::string::npos;)
        renamed.replace(at, 12, "water-alone");
    CHECK(left_out_of({stored(small_scene, "single-phase", 1), stored(renamed, "two-phase", 2)})
              .at(0)
              .differences.at(0) == "the scene has no such variant any more");
}

TEST_CASE("A run of a study goes with the set-up that it varies", "[one-setup]") {
    const std::string now = samples::with("sound_speed = 14.0", "sound_speed = 15.0");
    const std::vector<std::string> varied = {"water.exponent=6"};
    const SensitivityRun of_old{"water.exponent", 6, stored(small_scene, "two-phase", 1, varied)};
    const SensitivityRun of_new{"water.exponent", 6, stored(now, "two-phase", 3, varied)};
    const RunSummary latest = stored(now, "two-phase", 2);
    const auto out = left_out_of({latest}, {of_old, of_new});
    REQUIRE(out.size() == 1);
    CHECK(out[0].directory == "runs/two-phase-1");
    // its variant is left out, and it with it
    const RunSummary old = stored(small_scene, "two-phase", 1);
    CHECK(left_out_of({old, stored(now, "single-phase", 2)}, {of_old}).size() == 2);
}
