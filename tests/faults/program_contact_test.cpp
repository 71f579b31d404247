// SPDX-License-Identifier: BSD-3-Clause
// A body that sinks to the floor ends the run, or comes to rest there where the scene has a law of contact.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/faults/program_support.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::run_program;
using samples::ScratchFolder;

namespace {

/// A block of three times the density of the water, 0.3 x 0.2 m, in water of 0.4 m.
std::string put_sinking_block(const ScratchFolder& folder) {
    std::string text =
        samples::replaced(samples::small_scene, "[[0.0, 0.0, 0.4, 0.2]]", "[[0.0, 0.0, 1.0, 0.4]]");
    text =
        samples::replaced(text, "[[0.4, 0.0, 1.0, 0.2], [0.0, 0.2, 1.0, 0.48]]", "[[0.0, 0.4, 1.0, 0.48]]");
    text = samples::replaced(text, "surface = 0.2", "surface = 0.4");
    text = samples::replaced(text, "sound_speed = 14.0", "sound_speed = 20.0");
    text = samples::replaced(text, "end_time = 0.2", "end_time = 1.5");
    text = samples::replaced(text, "[model]\n", R"toml([body]
outline = [[-0.15, 0.0], [0.15, 0.0], [0.15, 0.2], [-0.15, 0.2]]
position = [0.5, 0.1]
free = ["x", "y", "rotation"]
mass = 180.0

[model]
)toml");
    samples::put_bytes(folder / "block.toml", text);
    return folder / "block.toml";
}

std::vector<std::string> run_of(const std::string& scene, const std::filesystem::path& out,
                                const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"run",  scene,       "--variant", "single-phase", "--dx",
                                          "0.04", "--threads", "1",         "--out",        out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

double last_of(const RunRecord& record, const char* name) {
    return record.series.at(name).value.back();
}

}  // namespace

TEST_CASE("a body that reaches the floor ends the run with time and place", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_sinking_block(folder);
    const Outcome outcome = run_program(run_of(scene, folder / "run"));
    INFO(outcome.err);
    REQUIRE(outcome.code == 3);
    REQUIRE_THAT(outcome.out, Contains("body touches the floor") && Contains("table [contact]"));
    const RunRecord record = read_run(folder / "run/run.h5");
    CHECK_THAT(record.stop_reason, Contains("at t = ") && Contains("body touches the floor"));
    const double angle = last_of(record, "body_angle");  // the block heels as it lands
    const double lowest =
        last_of(record, "body_y") - 0.1 * std::cos(angle) - 0.15 * std::abs(std::sin(angle));
    CHECK(lowest > 0);
    CHECK(lowest < 0.005);
    REQUIRE(run_program({"report", folder / "run"}).code <= 1);
    CHECK_THAT(samples::report_in(folder / "run"), Contains("body touches the floor"));
}

TEST_CASE("with a law of contact the body comes to rest on the floor at half its height", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_sinking_block(folder);
    const Outcome outcome = run_program(run_of(scene, folder / "run", {"--set", "contact.restitution=0.3"}));
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    const RunRecord record = read_run(folder / "run/run.h5");
    CHECK(last_of(record, "body_y") == Approx(0.1).margin(0.001));
    CHECK(last_of(record, "body_velocity_y") == Approx(0).margin(0.01));
    CHECK(last_of(record, "body_angle") == Approx(0).margin(0.01));
}

TEST_CASE("a body that moves as given into another ends the run, a law of contact or not", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_sinking_block(folder);
    std::string text = samples::bytes_of(scene);
    text =
        samples::replaced(text, "position = [0.5, 0.1]\nfree = [\"x\", \"y\", \"rotation\"]\nmass = 180.0\n",
                          R"toml(position = [0.3, 0.1]
velocity_x = 0.5

[body_2]
outline = [[-0.15, 0.0], [0.15, 0.0], [0.15, 0.2], [-0.15, 0.2]]
position = [0.65, 0.1]

[contact]
)toml");
    samples::put_bytes(folder / "block.toml", text);
    const Outcome outcome = run_program(run_of(scene, folder / "run"));
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 3);
    CHECK_THAT(outcome.out, Contains("body_2 touches body, and both move as given"));
    const RunRecord record = read_run(folder / "run/run.h5");
    CHECK(record.series.at("body_x").time.back() == Approx(0.1).margin(0.011));  // 0.05 m at 0.5 m/s
}
