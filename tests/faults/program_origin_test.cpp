// SPDX-License-Identifier: BSD-3-Clause
// Contacts that each run finds, and numbers by hand beside them: from the run to the report.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"
#include "validation/metrics/time_origin.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::run_program;
using samples::ScratchFolder;

namespace {

constexpr double speed = 1.0, height = 0.03;

/// A wedge that falls 0.03 m from 1 m/s to the water.
std::string drop(const std::string& contact) {
    return fmt::format(R"toml(schema = 1
name = "drop"
title = "Drop"
purpose = "to test"
source = "none"
gravity = [0.0, -9.81]
default_variant = "water"
[tank]
size = [0.6, 0.5]
[water]
density = 1000.0
sound_speed = 20.0
exponent = 7.0
boxes = [[0.0, 0.0, 0.6, 0.2]]
[initial]
pressure = "hydrostatic"
surface = 0.2
[body]
position = [0.3, 0.23]
outline = [[0.0, 0.0], [0.14, 0.1], [-0.14, 0.1]]
free = ["y"]
mass = 30.0
velocity_y = -1.0
[model]
air = false
[run]
end_time = 0.06
sample_interval = 0.001
[accepted_doubts]
sound_speed = "the time of contact alone counts here"

[variants.water]
[time_origins]
contact = {}
[[quantities]]
name = "speed_at_contact"
metric = "value_at"
series = "body_velocity_y"
x_origin = "contact"
threshold = 0.0
unit = "m/s"
)toml",
                       contact);
}

double time_of_fall(double distance) {
    return (std::sqrt(speed * speed + 2 * 9.81 * distance) - speed) / 9.81;
}

std::vector<std::string> run_in(const std::string& scene, const std::string& out,
                                const std::string& dx = "0.02") {
    return {"run", scene, "--dx", dx, "--out", out};
}

nlohmann::json summary_of(const std::string& directory) {
    return nlohmann::json::parse(samples::bytes_of(directory + "/summary.json"));
}

}  // namespace

TEST_CASE("first and geometric contact of a falling wedge come at the time of free fall",
          "[faults][origin]") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "drop.toml", drop("\"geometric_contact\""));
    for (const char* dx : {"0.02", "0.01"}) {
        REQUIRE(run_program(run_in(folder / "drop.toml", folder / dx, dx)).code == 0);
        const RunRecord record = read_run(folder / dx / "run.h5");
        const double spacing = record.particle_spacing;
        const double geometric = find_event(record, geometric_contact("body", "body_clearance")).time;
        const double wet = find_event(record, first_contact("body", "body_water_gap")).time;
        CAPTURE(dx, geometric, wet, time_of_fall(height));
        CHECK(std::abs(geometric - time_of_fall(height)) < 0.001);
        CHECK(std::abs(wet - time_of_fall(height - 0.25 * spacing)) < 0.5 * spacing / speed);
    }
}

TEST_CASE("a contact by hand that a changed start makes wrong is doubted by run and report",
          "[faults][origin]") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "drop.toml", drop(fmt::format("{:.6f}", time_of_fall(height))));
    std::vector<std::string> moved = run_in(folder / "drop.toml", folder / "runs/moved");
    moved.insert(moved.end(), {"--set", "body.position=[0.3, 0.25]"});
    const Outcome as_written = run_program(run_in(folder / "drop.toml", folder / "runs/as_written"));
    CHECK(as_written.code == 0);
    CHECK(as_written.err == "");
    const Outcome higher = run_program(moved);
    CHECK(higher.code == 0);
    CHECK_THAT(higher.err, Catch::StartsWith("doubt: time_origins.contact is 0.0265") &&
                               Contains("the run found the geometric contact of body at 0.041"));
    const Outcome report = run_program({"report", folder / "runs"});
    CHECK_THAT(report.err, Catch::StartsWith("doubt: drop water dx 0.02: time_origins.contact is 0.0265"));
    CHECK_THAT(
        samples::report_in(folder / "runs"),
        Contains("Doubt about drop water dx 0.02 with body.position=[0.3, 0.25]: time_origins.contact"));
    const nlohmann::json doubts = summary_of(folder / "runs").at("doubts");
    REQUIRE(doubts.size() == 1);
    CHECK(doubts[0].at("overrides") == "body.position=[0.3, 0.25]");
}

TEST_CASE("a contact that each run finds moves with the start, from the stored series alone",
          "[faults][origin]") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "drop.toml", drop("0.5"));  // far off: --set takes its place
    for (const char* y : {"0.23", "0.24", "0.25"}) {
        std::vector<std::string> moved = run_in(folder / "drop.toml", folder / "runs" / y);
        moved.insert(moved.end(), {"--set", fmt::format("body.position=[0.3, {}]", y), "--set",
                                   "time_origins.contact=geometric_contact"});
        const Outcome outcome = run_program(moved);
        CHECK(outcome.code == 0);
        CHECK(outcome.err == "");
        CHECK(run_program({"report", folder / "runs" / y}).err == "");
        const nlohmann::json runs = summary_of(folder / "runs" / y).at("runs");
        REQUIRE(runs.size() == 1);
        const RunRecord record = read_run(folder / "runs" / y / "run.h5");
        const double contact = find_event(record, geometric_contact("body", "body_clearance")).time;
        const double at_contact = runs[0].at("qoi").at("speed_at_contact").at("value");
        CHECK(at_contact == Approx(-speed - 9.81 * contact).epsilon(0.05));
    }
}
