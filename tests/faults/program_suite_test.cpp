// SPDX-License-Identifier: BSD-3-Clause
// Suites: reports made again, interrupted work taken up again, nothing left running.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/faults/program_support.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/fields.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using Catch::Contains;
using Catch::StartsWith;
using samples::Outcome;
using samples::Program;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;
using std::chrono::seconds;

namespace {

/// Three runs of about 0.2 s each.
const std::string three_runs =
    samples::with("single-phase = [0.02, 0.04]", "two-phase = [0.02, 0.0201, 0.0202]");
/// Two runs without end: water that stands still.
const std::string endless =
    samples::replaced(samples::replaced(samples::with("end_time = 0.2", "end_time = 1e6"),
                                        "[0.0, 0.0, 0.4, 0.2]", "[0.0, 0.0, 1.0, 0.2]"),
                      "[0.4, 0.0, 1.0, 0.2], ", "");

/// About a second of work.
const std::string one_long_run = samples::replaced(samples::with("end_time = 0.2", "end_time = 0.6"),
                                                   "single-phase = [0.02, 0.04]", "two-phase = [0.02]");

std::vector<std::string> suite(const std::string& scene, const ScratchFolder& folder) {
    return {"suite", "--only", scene, "--out", folder / "out", "--jobs", "1"};
}

std::filesystem::path run_of(const ScratchFolder& folder, const std::string& spacing) {
    return folder / ("out/runs/small/two-phase/dx" + spacing + "/run.h5");
}

}  // namespace

TEST_CASE("a suite runs every row, and its report can be made again to the same bytes", "[faults]") {
    const ScratchFolder folder;
    const Outcome outcome = run_program(suite(put_scene(folder), folder));
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    const auto page = [&] { return samples::report_in(folder / "out"); };
    const auto summary = [&] { return samples::bytes_of(folder / "out/summary.json"); };
    const std::string first_page = page(), first_summary = summary();
    REQUIRE(first_page.size() > 1000);
    for (int time = 0; time < 2; ++time) {
        REQUIRE(run_program({"report", folder / "out"}).code == 0);
        REQUIRE(page() == first_page);
        REQUIRE(summary() == first_summary);
    }
    const nlohmann::json json = nlohmann::json::parse(first_summary);
    REQUIRE(json.at("schema") == 2);
    REQUIRE(json.at("tier") == "quick");
    REQUIRE(json.at("runs").size() == 2);
    for (const nlohmann::json& run : json.at("runs")) REQUIRE(run.at("status") == "ok");
}

TEST_CASE("a finished suite is reused whole, and run again with --fresh", "[faults]") {
    const ScratchFolder folder;
    std::vector<std::string> arguments = suite(put_scene(folder), folder);
    REQUIRE(run_program(arguments).code == 0);
    REQUIRE_THAT(run_program(arguments).out, Contains("dx 0.02: finished before, reused") &&
                                                 Contains("dx 0.04: finished before, reused") &&
                                                 Contains("0 runs to do"));
    arguments.emplace_back("--fresh");
    REQUIRE_THAT(run_program(arguments).out, Contains("2 runs to do"));
}

TEST_CASE("runs of a scene that has changed since are not reused", "[faults]") {
    const ScratchFolder folder;
    REQUIRE(run_program(suite(put_scene(folder), folder)).code == 0);
    const std::string changed = put_scene(folder, samples::with("end_time = 0.2", "end_time = 0.21"));
    REQUIRE_THAT(run_program(suite(changed, folder)).out, Contains("2 runs to do"));
}

TEST_CASE("a scene that is edited and run again at other spacings leaves the earlier runs out of the report",
          "[faults]") {
    const ScratchFolder folder;
    REQUIRE(run_program(suite(put_scene(folder), folder)).code == 0);
    const std::string edited =
        put_scene(folder, samples::replaced(samples::with("sound_speed = 14.0", "sound_speed = 15.0"),
                                            "single-phase = [0.02, 0.04]", "single-phase = [0.025, 0.05]"));
    const Outcome outcome = run_program(suite(edited, folder));
    CHECK(outcome.code == 0);
    const std::string left_out =
        "runs/small/single-phase/dx0.02: water.sound_speed is 14.0, in the latest run 15.0";
    CHECK_THAT(outcome.err, Contains("left out: " + left_out));
    const nlohmann::json summary = nlohmann::json::parse(samples::bytes_of(folder / "out/summary.json"));
    std::set<double> shown;
    for (const nlohmann::json& run : summary.at("runs")) shown.insert(run.at("dx").get<double>());
    CHECK(shown == std::set<double>{0.025, 0.05});
    CHECK(summary.at("left_out").size() == 2);
    for (const nlohmann::json& row : summary.at("convergence"))
        CHECK(row.at("dx") == nlohmann::json({0.05, 0.025}));
    const std::string page = samples::bytes_of(folder / "out/index.html");
    CHECK_THAT(page, Contains("runs/small/single-phase/dx0.04 is left out") &&
                         Contains("water.sound_speed is 14.0, in the latest run 15.0"));
}

TEST_CASE("a killed suite, started again, reuses what was finished and does the rest", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder, three_runs);
    {
        Program killed(suite(scene, folder), folder);
        REQUIRE(Program::true_within(seconds(60),
                                     [&] { return std::filesystem::exists(run_of(folder, "0.02")); }));
        killed.kill_all();
    }
    REQUIRE_FALSE(std::filesystem::exists(run_of(folder, "0.0202")));
    const std::string finished = samples::bytes_of(run_of(folder, "0.02"));
    const Outcome outcome = run_program(suite(scene, folder));
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    REQUIRE_THAT(outcome.out, Contains("dx 0.02: finished before, reused"));
    REQUIRE(samples::bytes_of(run_of(folder, "0.02")) == finished);
    for (const char* spacing : {"0.0201", "0.0202"})
        REQUIRE(read_run(run_of(folder, spacing)).status == RunStatus::ok);
    REQUIRE(nlohmann::json::parse(samples::bytes_of(folder / "out/summary.json")).at("runs").size() == 3);
}

TEST_CASE("a killed run leaves no run that looks finished, and can be started again", "[faults]") {
    const ScratchFolder folder;
    const std::vector<std::string> arguments = {
        "run", put_scene(folder), "--variant", "single-phase", "--dx", "0.02", "--out", folder / "run"};
    std::vector<std::string> long_run = arguments;
    long_run[1] = folder / "long.toml";
    samples::put_bytes(folder / "long.toml", endless);
    {
        Program killed(long_run, folder);
        REQUIRE(Program::true_within(seconds(30),
                                     [&] { return std::filesystem::exists(folder / "run/fields.pvd"); }));
        killed.kill_all();
    }
    REQUIRE_FALSE(std::filesystem::exists(folder / "run/run.h5"));
    const Outcome other = run_program(arguments);  // of another length: not the run that was killed
    REQUIRE(other.code == 2);
    REQUIRE_THAT(other.err, Contains("holds another, unfinished run"));
    std::vector<std::string> replacing = arguments;
    replacing.emplace_back("--replace");
    REQUIRE(run_program(replacing).code == 0);
}

TEST_CASE("two suites do not work in the same run directory", "[faults]") {
    const ScratchFolder folder, logs;
    const std::string scene = put_scene(folder, endless);
    Program first(suite(scene, folder), logs);
    const std::filesystem::path log = folder / "out/runs/small/single-phase/dx0.02";
    REQUIRE(Program::true_within(seconds(30), [&] { return std::filesystem::exists(log / "fields.pvd"); }));
    const Outcome second =
        run_program({"run", scene, "--variant", "single-phase", "--dx", "0.02", "--out", log, "--replace"});
    REQUIRE(second.code == 4);
    // the water reaches the far wall at the start, which is a doubt about the front
    REQUIRE_THAT(second.err, StartsWith("doubt: ") && Contains("\nwetdeck: ") &&
                                 Contains("another process is working in this directory"));
    REQUIRE(std::count(second.err.begin(), second.err.end(), '\n') == 2);
}

TEST_CASE("a killed suite leaves no run going on", "[faults]") {
    const ScratchFolder folder;
    Program killed(suite(put_scene(folder, endless), folder), folder);
    REQUIRE(Program::true_within(seconds(30), [&] {
        return std::filesystem::exists(folder / "out/runs/small/single-phase/dx0.02/fields.pvd");
    }));
    killed.kill_parent();
    REQUIRE(killed.all_gone_within(seconds(5)));
}

TEST_CASE("a suite varies the inputs of the sensitivity study, and its report tells what they do",
          "[faults]") {
    const ScratchFolder folder;
    const std::string study =
        "[[sensitivity]]\nkey = \"model.background_pressure\"\nlow = 400.0\nhigh = 600.0\nuncertainty = "
        "50.0\n"
        "source = \"made up\"\n";
    const auto scene =
        put_scene(folder, samples::with("single-phase = [0.02, 0.04]", "two-phase = [0.04]") + study);
    REQUIRE(run_program(suite(scene, folder)).code == 0);
    const std::string low = "out/sensitivity/small/model.background_pressure=400/run.h5";
    const auto before = std::filesystem::last_write_time(folder / low);
    const auto summary = nlohmann::json::parse(samples::bytes_of(folder / "out/summary.json"));
    CHECK(summary["runs"].size() == 1);
    CHECK(summary["missing"].empty());
    REQUIRE(summary["sensitivity"].size() == 1);
    CHECK(summary["sensitivity"][0]["quantity"] == "front_mean");
    CHECK(summary["sensitivity"][0]["value_low"] != summary["sensitivity"][0]["value_high"]);
    CHECK(read_run(folder / low).provenance.at("overrides") == "model.background_pressure=400");
    REQUIRE(run_program(suite(scene, folder)).code == 0);  // all are finished
    CHECK(std::filesystem::last_write_time(folder / low) == before);
}

TEST_CASE("a suite runs other arrangements of the particles, and its report tells how much they differ",
          "[faults]") {
    const ScratchFolder folder;
    const auto scene = put_scene(folder, samples::with("single-phase = [0.02, 0.04]", "two-phase = [0.04]") +
                                             "[replicates]\nvariants = [\"two-phase\"]\ncount = 40\n");
    std::vector<std::string> command = suite(scene, folder);
    command.insert(command.end(), {"--replicates", "3"});
    REQUIRE(run_program(command).code == 0);
    const auto summary = nlohmann::json::parse(samples::bytes_of(folder / "out/summary.json"));
    CHECK(summary["runs"].size() == 1);
    CHECK(summary["missing"].empty());
    REQUIRE_FALSE(summary["replicates"].empty());
    for (const auto& row : summary["replicates"]) {
        CHECK(row["n"] == 3);
        CHECK(row["sd"] > 0);
        CHECK(row["low95"] < row["mean"]);
        CHECK(row["mean"] < row["high95"]);
    }
    CHECK(list_frames(folder / "out/runs/small/two-phase/dx0.04").size() > 0);
    CHECK(list_frames(folder / "out/replicates/small/two-phase/initial.arrangement=2").empty());
    CHECK(read_run(folder / "out/replicates/small/two-phase/initial.arrangement=2/run.h5")
              .provenance.at("overrides") == "initial.arrangement=2");
}

TEST_CASE("a baseline of a clean program is kept and compared; from a dirty one it is refused", "[faults]") {
    const ScratchFolder folder;
    const auto scene = put_scene(folder, samples::with("single-phase = [0.02, 0.04]", "two-phase = [0.04]"));
    REQUIRE(run_program(suite(scene, folder)).code == 0);
    const std::string out = folder / "out", file = folder / "base.json";
    const Outcome written = run_program({"baseline", "write", out, "--file", file});
    const std::string commit = read_run(run_of(folder, "0.04")).provenance.at("commit");
    if (commit == "unknown" || commit.ends_with("-dirty")) {
        CHECK(written.code == 2);
        CHECK_THAT(written.err, Contains("a baseline needs runs of a committed program"));
        return;
    }
    CHECK(written.code == 0);
    CHECK(run_program({"baseline", "compare", out, "--file", file}).code == 0);
}

TEST_CASE("a suite stopped by a signal, or killed, goes on with its interrupted run", "[faults]") {
    const ScratchFolder folder, logs;
    const std::string scene = put_scene(folder, one_long_run);
    std::vector<std::string> arguments = suite(scene, folder);
    arguments.insert(arguments.end(), {"--checkpoint-interval", "0"});
    const auto run = folder / "out/runs/small/two-phase/dx0.02";
    {
        Program stopped(arguments, logs);
        REQUIRE(Program::true_within(seconds(30), [&] { return list_checkpoints(run).size() == 2; }));
        SECTION("SIGTERM to the suite alone") {
            stopped.send(SIGTERM);
            REQUIRE(stopped.wait() == 143);
            REQUIRE_THAT(stopped.err(), Contains("stopped by SIGTERM with 0 of 1 runs done"));
            REQUIRE_THAT(samples::bytes_of(run / "run.log"), Contains("stopped by SIGTERM at t = "));
        }
        SECTION("kill -9 of everything") {
            stopped.kill_all();
        }
        SECTION("kill -9 of the suite alone: the run stores where it is, and the next suite waits for that") {
            stopped.kill_parent();
        }
    }
    const Outcome outcome = run_program(arguments);
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    REQUIRE_THAT(samples::bytes_of(run / "run.log"), Contains("continuing from t = "));
    REQUIRE(nlohmann::json::parse(samples::bytes_of(folder / "out/summary.json")).at("runs").size() == 1);
}

TEST_CASE("a suite starts a run again whose checkpoints are all damaged", "[faults]") {
    const ScratchFolder folder, logs;
    const std::string scene = put_scene(folder, one_long_run);
    std::vector<std::string> arguments = suite(scene, folder);
    arguments.insert(arguments.end(), {"--checkpoint-interval", "0"});
    const auto run = folder / "out/runs/small/two-phase/dx0.02";
    {
        Program killed(arguments, logs);
        REQUIRE(Program::true_within(seconds(30), [&] { return list_checkpoints(run).size() == 2; }));
        killed.kill_all();
    }
    for (const auto& file : list_checkpoints(run)) std::filesystem::resize_file(file, 100);
    REQUIRE(run_program(arguments).code == 0);
    REQUIRE(read_run(run / "run.h5").status == RunStatus::ok);
}

TEST_CASE("a variant that is expected to become unstable is no failure, whatever its name", "[faults]") {
    for (const bool expected : {false, true}) {
        const ScratchFolder folder;
        const std::string key = expected ? "\nexpect = \"unstable\"" : "";
        const std::string text = samples::with("[variants.two-phase]",
                                               "[variants.two-phase]\nscheme = \"yang2020-literal\"" + key);
        const std::string scene =
            put_scene(folder, samples::replaced(text, "single-phase = [0.02, 0.04]", "two-phase = [0.04]"));
        const Outcome outcome = run_program(suite(scene, folder));
        INFO(outcome.out << outcome.err);
        REQUIRE_THAT(outcome.out,
                     Contains(expected ? "became unstable as expected, see" : "became unstable, see"));
        CHECK(outcome.code == (expected ? 0 : 3));
    }
}

TEST_CASE(
    "a changed label leaves a finished suite done, a changed tank does not; the plan names the revision",
    "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder);
    REQUIRE(run_program(suite(scene, folder)).code == 0);
    const auto plan = [&] {
        std::vector<std::string> arguments = suite(scene, folder);
        arguments.insert(arguments.end(), {"--plan", "--json"});
        return nlohmann::json::parse(run_program(arguments).out).at("rows");
    };
    put_scene(folder, samples::with("title = \"A small column\"", "title = \"Another title\""));
    for (const nlohmann::json& row : plan()) {
        CHECK(row.at("state") == "done");
        CHECK(row.at("revision").get<std::string>().size() >= 7);
    }
    put_scene(folder, samples::with("size = [1.0, 0.48]", "size = [1.0, 0.52]"));
    for (const nlohmann::json& row : plan()) {
        CHECK(row.at("state") == "to do");
        CHECK(row.at("revision").is_null());
    }
}

TEST_CASE("a tier without runs is refused", "[faults]") {
    const ScratchFolder folder;
    const std::string text = samples::with("single-phase = [0.02, 0.04]", "single-phase = []");
    samples::put_bytes(folder / "none.toml", text);
    for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--plan"}, {"--row", "0"}}) {
        std::vector<std::string> arguments = {"suite", "--only", folder / "none.toml", "--out",
                                              folder / "out"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run_program(arguments);
        INFO(outcome.out << outcome.err);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.err, Contains("tier 'quick' of") && Contains("holds no run"));
        CHECK_FALSE(std::filesystem::exists(folder / "out"));
    }
}
