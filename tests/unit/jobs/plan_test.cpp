// SPDX-License-Identifier: BSD-3-Clause
// The plan of a suite: its rows, their order, names, directories and states.
#include "validation/jobs/plan.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {

/// The plan of the small scene, two spacings of one variant, and a study of the air's density.
struct SmallPlan {
    ScratchFolder folder;
    PlanOptions options;

    SmallPlan() {
        const std::string scene = folder / "small.toml";
        samples::put_bytes(
            scene,
            samples::with("quick = { single-phase = [0.02, 0.04] }", "quick = { two-phase = [0.04, 0.02] }") +
                "[[sensitivity]]\nkey = \"model.background_pressure\"\nlow = 400.0\nhigh = "
                "600.0\nuncertainty = 50.0\nreason = \"made up\"\nhigh_with = "
                "[\"air.sound_speed=50\"]\n");
        options.scenes = {scene};
        options.directory = folder / "out";
    }
};

}  // namespace

TEST_CASE("A plan has every spacing and both values of a varied input, the longest run first", "[plan]") {
    const SmallPlan plan;
    const std::vector<SuiteRow> rows = suite_rows(plan.options);
    REQUIRE(rows.size() == 4);  // two spacings, low and high
    const auto longer = [](const SuiteRow& a, const SuiteRow& b) {
        return a.estimated_core_seconds > b.estimated_core_seconds;
    };
    CHECK(std::is_sorted(rows.begin(), rows.end(), longer));
    const auto of = [&](const std::vector<std::string>& overrides, double dx) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const SuiteRow& each) {
            return each.overrides == overrides && each.particle_spacing == dx;
        });
        REQUIRE(row != rows.end());
        return *row;
    };
    const SuiteRow coarse = of({}, 0.04);
    CHECK(coarse.directory == plan.options.directory / "runs/small/two-phase/dx0.04");
    CHECK(row_name(coarse) == plan.options.scenes[0] + " two-phase dx 0.04");
    const SuiteRow low = of({"model.background_pressure=400"}, 0.04);
    CHECK(low.directory == plan.options.directory / "sensitivity/small/model.background_pressure=400");
    CHECK(row_name(low).ends_with(" dx 0.04 model.background_pressure=400"));
    const SuiteRow high = of({"model.background_pressure=600", "air.sound_speed=50"}, 0.04);
    CHECK(row_name(high).ends_with(" dx 0.04 model.background_pressure=600"));
    double sum = 0;
    for (const SuiteRow& row : rows) sum += row.estimated_core_seconds;
    CHECK(estimated_core_seconds(rows) == sum);
}

TEST_CASE("The results of a row are as large as its fields and its checkpoint", "[plan]") {
    SmallPlan plan;
    RowOptions options;
    for (const SuiteRow& row : suite_rows(plan.options)) {
        const auto bytes = [&](Fields fields) {
            options.fields = fields;
            return estimated_bytes(row, options);
        };
        CHECK(row.frames == 4);  // 0, 0.05, 0.1, 0.2
        CHECK(row.fluid_particles == Approx(0.48 / row.particle_spacing / row.particle_spacing));
        CHECK(bytes(Fields::none) > 1e5);
        const bool study = !row.overrides.empty();
        CHECK((bytes(Fields::all) > bytes(Fields::none)) == !study);
        CHECK((bytes(Fields::key) > bytes(Fields::none)) == row.pictured);
        CHECK(bytes(Fields::key) <= bytes(Fields::all));
    }
}

TEST_CASE("The finest run of a variant has pictures, and those that are shown beside other variants",
          "[plan]") {
    SmallPlan plan;
    const std::string scene = plan.options.scenes[0];
    const auto pictured = [&plan] {
        std::set<double> spacings;
        for (const SuiteRow& row : suite_rows(plan.options))
            if (row.pictured) spacings.insert(row.particle_spacing);
        return spacings;
    };
    CHECK(pictured() == std::set<double>{0.02});
    const std::string beside =
        "[[side_by_side]]\ntitle = \"both\"\nvariants = [\"two-phase\", \"single-phase\"]\n";
    samples::put_bytes(scene, samples::bytes_of(scene) + beside + "series = \"front\"\n");
    CHECK(pictured() == std::set<double>{0.02});
    samples::put_bytes(scene, samples::bytes_of(scene) + beside + "time = 0.1\n");
    CHECK(pictured() == std::set<double>{0.02, 0.04});
}

TEST_CASE(
    "A plan has a half and twice the sound speed of the variants that a scene names, at their coarsest "
    "spacing",
    "[plan]") {
    SmallPlan plan;
    const std::string scene = plan.options.scenes[0];
    samples::put_bytes(scene, samples::bytes_of(scene) + "[sound_speed_study]\nvariants = [\"two-phase\"]\n");
    const std::vector<SuiteRow> rows = suite_rows(plan.options);
    REQUIRE(rows.size() == 6);
    for (const std::string assignment : {"water.sound_speed=7", "water.sound_speed=28"}) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const SuiteRow& each) {
            return !each.overrides.empty() && each.overrides[0] == assignment;
        });
        REQUIRE(row != rows.end());
        CHECK(row->overrides.size() == (assignment == "water.sound_speed=7" ? 2 : 1));
        CHECK(row->variant == "two-phase");
        CHECK(row->particle_spacing == 0.04);
        CHECK(row->directory == plan.options.directory / "sound_speed/small/two-phase" / assignment);
    }
    samples::put_bytes(scene, samples::small_scene + "[sound_speed_study]\nvariants = [\"three-phase\"]\n");
    CHECK_THROWS_WITH(suite_rows(plan.options),
                      Catch::Contains("key 'sound_speed_study.variants': 'three-phase' is not a variant"));
}

TEST_CASE("A plan has the replicates that a scene or the caller asks for, at the coarsest spacing",
          "[plan]") {
    SmallPlan plan;
    const std::string scene = plan.options.scenes[0];
    samples::put_bytes(scene,
                       samples::bytes_of(scene) + "[replicates]\nvariants = [\"two-phase\"]\ncount = 3\n");
    const auto replicates = [&] {
        std::vector<SuiteRow> rows = suite_rows(plan.options);
        std::erase_if(rows, [](const SuiteRow& row) {
            return row.overrides.empty() || !row.overrides[0].starts_with("initial.arrangement=");
        });
        return rows;
    };
    const std::vector<SuiteRow> rows = replicates();
    REQUIRE(rows.size() == 3);
    for (const SuiteRow& row : rows) {
        CHECK(row.particle_spacing == 0.04);
        CHECK(row.overrides.size() == 1);
        CHECK(row.directory == plan.options.directory / "replicates/small/two-phase" / row.overrides[0]);
        CHECK(row_name(row).ends_with(" dx 0.04 " + row.overrides[0]));
    }
    CHECK(rows[0].overrides != rows[1].overrides);
    plan.options.replicates = 5;
    CHECK(replicates().size() == 5);
    plan.options.replicates = 0;
    CHECK(replicates().empty());
}

TEST_CASE("Replicates of another variant, or a number of them that is none, are refused", "[plan]") {
    SmallPlan plan;
    const std::string scene = plan.options.scenes[0];
    const auto [keys, message] = GENERATE(table<const char*, const char*>(
        {{"variants = [\"three-phase\"]", "key 'replicates.variants': 'three-phase' is not a variant"},
         {"variants = [\"two-phase\"]\ncount = 1", "key 'replicates.count': expected a whole number"},
         {"variants = [\"two-phase\"]\ncount = 2.5", "key 'replicates.count': expected a whole number"},
         {"variants = [\"two-phase\"]\ncount = 1001", "key 'replicates.count': expected a whole number"},
         {"variants = [\"two-phase\"]\nseeds = 3", "seeds"},
         {"count = 3", "variants"}}));
    samples::put_bytes(scene, samples::small_scene + "[replicates]\n" + keys + "\n");
    CHECK_THROWS_WITH(suite_rows(plan.options), Catch::Contains(message));
}

TEST_CASE("A row without a directory is neither finished nor interrupted", "[plan]") {
    const SmallPlan plan;
    for (const SuiteRow& row : suite_rows(plan.options)) {
        CHECK_FALSE(finished(row));
        CHECK_FALSE(interrupted(row));
    }
}

TEST_CASE("A plan of an unknown tier or scene is refused", "[plan]") {
    SmallPlan plan;
    plan.options.tier = "slow";
    CHECK_THROWS_WITH(suite_rows(plan.options), Catch::Contains("no tier 'slow', expected quick"));
    plan.options.scenes = {"dam_brake"};
    CHECK_THROWS_AS(suite_rows(plan.options), InputError);
}
