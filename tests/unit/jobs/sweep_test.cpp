// SPDX-License-Identifier: BSD-3-Clause
// Sweeps: axes, the grid, its runs, the table of results.
#include "validation/jobs/sweep.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::ScratchFolder;

namespace {

const std::string scene_text =
    samples::replaced(samples::with("[scales]\n", "[parameters]\nrho = 1000.0\nidle = 1.0\n\n[scales]\n"),
                      "density = 1000.0", "density = \"= rho\"");

SweepAxis axis_of(const std::string& text) {
    return parse_axis(text, parse_scene(scene_text, "small.toml"));
}

struct SmallSweep {
    ScratchFolder folder;
    SweepPlan plan;

    SmallSweep() {
        samples::put_bytes(folder / "small.toml", scene_text);
        plan = {folder / "small.toml", "single-phase", {axis_of("rho=900:1000:3")}, {0.04},
                {"run.end_time=0.03"}, folder / "out"};
    }
};

}  // namespace

TEST_CASE("an axis is a key, two ends, a count, and a unit if there is one", "[sweep]") {
    const SweepAxis plain = axis_of("model.background_pressure=100:300:3");
    CHECK(plain.key == "model.background_pressure");
    CHECK(plain.value(0) == 100);
    CHECK(plain.value(1) == 200);
    CHECK(plain.value(2) == 300);
    CHECK(plain.title() == "model.background_pressure");
    const SweepAxis angle = axis_of("rho=10:50:5 kg/m^3");
    CHECK(angle.key == "parameters.rho");  // a parameter of the scene
    CHECK(angle.title() == "rho [kg/m^3]");
    CHECK(axis_of("rho=5:5:1").value(0) == 5);
    for (const char* wrong : {"rho", "=1:2:3", "rho=1:2", "rho=1:2:3:4", "rho=1:2:0", "rho=1:2:2.5",
                              "rho=a:2:3", "rho=1:1:2", "rho=1:2:1", "rho=1:2:3 lemons", "rho=1,5:2:3"}) {
        INFO(wrong);
        CHECK_THROWS_AS(axis_of(wrong), InputError);
    }
}

TEST_CASE("a key that would leave others behind, or be taken for another unit, is refused", "[sweep]") {
    const auto refusal = [](const std::string& over) {
        const std::string text = samples::replaced(scene_text, "idle = 1.0", "idle = \"30 deg\"");
        try {
            parse_axis(over, parse_scene(text, "small.toml"));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal("rho=900:1000:2").empty());
    CHECK_THAT(refusal("roh=900:1000:2"), Contains("none of its parameters: idle, rho"));
    CHECK_THAT(refusal("water.density=900:1000:2"),
               Contains("follows from others in this scene, '= rho'") && Contains("idle, rho"));
    CHECK_THAT(refusal("idle=10:30:3"), Contains("is \"30 deg\" in the scene") && Contains("UNIT"));
    CHECK(refusal("idle=10:30:3 deg").empty());
    CHECK(refusal("water.sound_speed=10:30:3").empty());
}

TEST_CASE("the first axis of a grid changes fastest", "[sweep]") {
    const auto points = grid_points({{"a", 1, 2, 2, ""}, {"b", 10, 30, 3, ""}});
    CHECK(points == std::vector<std::vector<double>>{{1, 10}, {2, 10}, {1, 20}, {2, 20}, {1, 30}, {2, 30}});
    CHECK_THROWS_AS(grid_points({{"a", 1, 2, 2, ""}, {"a", 1, 2, 2, ""}}), InputError);
    CHECK_THROWS_AS(grid_points({{"a", 1, 2, 200, ""}, {"b", 1, 2, 200, ""}}), InputError);
}

TEST_CASE("every point of a sweep is run at every spacing, in a folder of its own", "[sweep]") {
    SmallSweep sweep;
    sweep.plan.spacings = {0.04, 0.02};
    const std::vector<SuiteRow> rows = sweep_rows(sweep.plan);
    REQUIRE(rows.size() == 6);
    CHECK(rows[1].overrides == std::vector<std::string>{"run.end_time=0.03", "parameters.rho=900"});
    CHECK(rows[1].directory == sweep.folder / "out/points/parameters.rho=900/dx0.02");
    CHECK(row_name(rows[1]).ends_with("dx 0.02 parameters.rho=900"));
    CHECK_THROWS_AS((sweep.plan.axes = {axis_of("rho=-1:2:2")}, sweep_rows(sweep.plan)), InputError);
}

TEST_CASE("a key that changes nothing in the run is refused", "[sweep]") {
    SmallSweep sweep;
    sweep.plan.axes = {axis_of("idle=1:2:2")};
    CHECK_THROWS_WITH(sweep_rows(sweep.plan), Contains("parameters.idle") && Contains("changes nothing"));
}

TEST_CASE("the plan of a sweep is read as it was written", "[sweep]") {
    SmallSweep sweep;
    sweep.plan.axes.push_back(axis_of("model.background_pressure=0:1:2 kPa"));
    write_sweep_plan(sweep.plan);
    const SweepPlan read = read_sweep_plan(sweep.plan.directory);
    CHECK(read.scene == sweep.plan.scene);
    CHECK(read.variant == "single-phase");
    CHECK(read.spacings == sweep.plan.spacings);
    CHECK(read.overrides == sweep.plan.overrides);
    REQUIRE(read.axes.size() == 2);
    CHECK(read.axes[1].unit == "kPa");
    CHECK(overrides_at(read, {900, 1}).back() == "model.background_pressure=\"1 kPa\"");
    samples::put_bytes(sweep.folder / "out/sweep.json", "{}");
    CHECK_THROWS_AS(read_sweep_plan(sweep.plan.directory), DataError);
}

TEST_CASE("the table of a sweep has a row for each point and leaves unknown numbers empty", "[sweep]") {
    SweepResult result;
    result.scene = "small";
    result.variant = "one";
    result.axes = {{"parameters.deadrise", 10, 20, 2, "deg"}};
    result.points = {{{10},
                      "ok",
                      "points/a",
                      {0.02, 0.01},
                      12.5,
                      {{"force", "N/m", 3.5, "", 0.1, 3.0, 0.5, {{"Wagner", 4.0}}, {}}}},
                     {{20},
                      "unstable",
                      "points/b",
                      {},
                      1.0,
                      {{"force", "N/m", {}, "not reached", {}, 2.0, 0.5, {{"Wagner", 2.5}}, {}}}}};
    const std::string text = sweep_csv(result);
    CHECK_THAT(text, Contains("deadrise [deg],dx [m],force [N/m],force_u_num [N/m],force_expected "
                              "[N/m],force_Wagner [N/m],core_s [s],status\n"));
    CHECK_THAT(text, Contains("\n10,0.01,3.5,0.1,3,4,12.5,ok\n"));
    CHECK_THAT(text, Contains("\n20,,,,2,2.5,1,unstable\n"));
}
