// SPDX-License-Identifier: BSD-3-Clause
// Bad usage and bad input: exit code 2, one line that says what was expected, and nothing left behind.
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;

namespace {

/// The program refuses with exit code 2 and one line that holds `message`.
void expect_refusal(const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome outcome = run_program(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 2);
    REQUIRE(outcome.one_line());
    REQUIRE_THAT(outcome.err, Contains(message));
}

}  // namespace

TEST_CASE("the program refuses a bad scene file in one line", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder, samples::with("end_time = 0.2", "end_time = \"soon\""));
    for (const char* command : {"check", "run", "describe"}) {
        expect_refusal({command, scene}, scene + ":40: key 'run.end_time': expected a finite number");
    }
    expect_refusal({"suite", "--only", scene, "--out", folder / "out"}, scene + ":40: key 'run.end_time'");
    REQUIRE_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("the program refuses malformed scene files in one line", "[faults]") {
    const ScratchFolder folder;
    for (const std::string text : {"[[[[phase]]\ngamm] ", "\xee\x80\x80 = 1\n", "schema = \"1\n", ""}) {
        const std::string scene = put_scene(folder, text);
        expect_refusal({"check", scene}, scene);
    }
}

TEST_CASE("names that hold line breaks and control characters are refused in one line", "[faults]") {
    const ScratchFolder folder;
    const std::string scene =
        put_scene(folder, samples::with("schema = 1\n", "schema = 1\n\"a\\nb\\u001b[2J\" = 1\n"));
    expect_refusal({"check", scene}, "key 'a b [2J': unknown");
    expect_refusal({"describe", "dam\nbreak"}, "no scene 'dam break'");
    expect_refusal({"suite", "--tier", "a\nb"}, "a b");
}

TEST_CASE("the program refuses an unknown key given by --set", "[faults]") {
    const ScratchFolder folder;
    expect_refusal({"run", "dam_break", "--set", "model.ar=false", "--out", folder / "run"},
                   "key 'model.ar': unknown, expected one of air, ");
    expect_refusal({"run", "dam_break", "--set", "execution.precision=half", "--out", folder / "run"},
                   "key 'execution.precision': is 'half', expected one of double, mixed");
    expect_refusal({"run", "dam_break", "--set", "execution.precision=mixed", "--set",
                    "model.pressure_mean=harmonic", "--out", folder / "run"},
                   "key 'execution.precision': is 'mixed', expected 'double' with pressure_mean = ");
    expect_refusal({"bench", "--precision", "half"}, "precision");
    REQUIRE_FALSE(std::filesystem::exists(folder / "run"));
}

TEST_CASE("the program refuses an unknown scene, variant and tier", "[faults]") {
    const ScratchFolder folder;
    const std::string out = folder / "out";
    expect_refusal({"run", "dam_brake", "--out", out}, "no scene 'dam_brake', expected one of ");
    expect_refusal({"describe", "dam_brake"}, "no scene 'dam_brake'");
    expect_refusal({"suite", "--only", "dam_brake", "--out", out}, "no scene 'dam_brake'");
    expect_refusal({"run", "dam_break", "--variant", "three-phase", "--out", out},
                   "no variant 'three-phase', expected one of two-phase, single-phase, paper");
    expect_refusal({"suite", "--tier", "slow", "--out", out},
                   "no tier 'slow', expected quick, standard or paper");
    REQUIRE_FALSE(std::filesystem::exists(out));
}

TEST_CASE("the program refuses spacings and times that cannot be run", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder), out = folder / "run";
    expect_refusal({"run", scene, "--dx", "0.07", "--out", out},
                   "particle spacing 0.07 m does not fit the side of 0.4 m");
    expect_refusal({"run", scene, "--dx", "-1", "--out", out}, "--dx is -1, expected a positive spacing [m]");
    expect_refusal({"run", scene, "--dx", "0", "--out", out}, "--dx is 0, expected a positive spacing [m]");
    expect_refusal({"run", scene, "--dx", "nan", "--out", out}, "expected a positive spacing [m]");
    expect_refusal({"ablate", scene, "--dx", "0", "--out", out},
                   "--dx is 0, expected a positive spacing [m]");
    expect_refusal({"run", scene, "--dx", "1e-7", "--out", out}, "expected at most 5e+07");
    expect_refusal({"run", "dam_break", "--dx", "0.06", "--out", out},
                   "a pressure gauge of 0.04 m is smaller than the particle spacing");
    for (const std::string command : {"run", "ablate"}) {
        for (const std::string until : {"0", "-1", "nan", "inf"}) {
            expect_refusal(
                {command, scene, "--variant", "single-phase", "--dx", "0.04", "--until", until, "--out", out},
                "--until is " + until + ", expected a positive time [s]");
        }
    }
    expect_refusal({"run", scene, "--out", out},
                   "--dx is missing: the scene names no quick spacing for this variant");
    REQUIRE_FALSE(std::filesystem::exists(out));
}

TEST_CASE("check refuses a bad reference curve and names its line", "[faults]") {
    const ScratchFolder folder;
    std::string curve = samples::bytes_of(std::filesystem::path(WETDECK_SOURCE_DIR) /
                                          "reference_data/dam_break/ritter_front.csv");
    REQUIRE_FALSE(curve.empty());
    const std::string path = folder / "curve.csv";
    samples::put_bytes(path, curve);
    REQUIRE(run_program({"check", path}).code == 0);
    const std::string last = "0.0,word\n";
    samples::put_bytes(path, curve + last);
    const auto lines = std::count(curve.begin(), curve.end(), '\n') + 1;
    expect_refusal({"check", path}, path + ":" + std::to_string(lines) + ": ");
    samples::put_bytes(path, "a,b\n1,2\n");
    expect_refusal({"check", path}, path);
}

TEST_CASE("check prints doubts on stderr, and with --strict any doubt is exit code 2", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder);
    CHECK(run_program({"check", scene, "--strict"}).code == 0);
    samples::put_bytes(scene, samples::with("background_pressure = 500.0", "background_pressure = 3000.0"));
    for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--json"}}) {
        std::vector<std::string> arguments = {"check", scene};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome doubted = run_program(arguments);
        CHECK(doubted.code == 0);
        CHECK(doubted.err.rfind("doubt: model.background_pressure is 3000 Pa", 0) == 0);
        CHECK(std::count(doubted.err.begin(), doubted.err.end(), '\n') == 1);
        CHECK_THAT(doubted.out, !Contains("doubt: "));
        arguments.emplace_back("--strict");
        const Outcome strict = run_program(arguments);
        CHECK(strict.code == 2);
        CHECK(strict.out == doubted.out);
        CHECK(strict.err == doubted.err);
    }
}

TEST_CASE("check tells an outline from a reference curve", "[faults]") {
    const ScratchFolder folder;
    const std::string file = folder / "hull.csv";
    samples::put_bytes(file, "# drawing: 12\nx [m], y [m]\n0, 0\n1, 0\n1, 1\n");
    CHECK(run_program({"check", file}).out ==
          file +
              ": outline of 3 corners, x from 0 to 1 m, y from 0 to 1 m, fit for 'mirrored = true', no error "
              "found\n");
    CHECK(nlohmann::json::parse(run_program({"check", file, "--json"}).out).at("corners") == 3);
    samples::put_bytes(file, "0, 0\n1, 0\n1, one\n");
    expect_refusal({"check", file}, file + ":3: expected two numbers, x and y [m] (a reference curve begins");
    expect_refusal({"check", folder / "none.csv"}, "none.csv: no such file");
}

TEST_CASE("the program refuses unknown commands, options and values", "[faults]") {
    expect_refusal({"dance"}, "no command 'dance'; see wetdeck --help");
    expect_refusal({"suit", "--tier", "quick"}, "no command 'suit'; did you mean 'suite'?");
    expect_refusal({"tset"}, "no command 'tset'; did you mean './wetdeck test'?");
    expect_refusal({"docs"},
                   "no command 'docs'; it is one of the script ./wetdeck at the root of the sources");
    expect_refusal({"run", "dam_break", "--colour"}, "--colour; see wetdeck --help");
    expect_refusal({"run"}, "scene is required; see wetdeck --help");
    expect_refusal({"run", "dam_break", "--dx", "small"}, "--dx = small");
    expect_refusal({"suite", "--jobs", "0"}, "--jobs");
}

TEST_CASE("report refuses a directory without runs", "[faults]") {
    const ScratchFolder folder;
    expect_refusal({"report", folder / "none"}, "none: no such directory");
    const std::filesystem::path path = folder;
    expect_refusal({"report", path}, "holds no run.h5, expected the directory of a suite or a run");
}

TEST_CASE("report refuses a damaged run and names it", "[faults]") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "run.h5", "not HDF5");
    const std::filesystem::path path = folder;
    expect_refusal({"report", path}, "run.h5");
}

TEST_CASE("a directory that holds another run is left as it is, unless it is to be replaced", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder), out = folder / "run";
    const std::vector<std::string> first = {"run",  scene,  "--variant", "single-phase",
                                            "--dx", "0.04", "--out",     out};
    std::vector<std::string> other = first;
    other[5] = "0.02";
    REQUIRE(run_program(first).code == 0);
    const std::string before = samples::bytes_of(folder / "run/run.h5");
    const std::string fields_before = samples::bytes_of(folder / "run/fields/frame_000001.vtp");
    REQUIRE_FALSE(fields_before.empty());
    expect_refusal(other, "holds a finished run (small single-phase dx 0.04 ");
    expect_refusal(first, "holds a finished run (small single-phase dx 0.04 ");
    REQUIRE(samples::bytes_of(folder / "run/run.h5") == before);
    REQUIRE(samples::bytes_of(folder / "run/fields/frame_000001.vtp") == fields_before);
    other.emplace_back("--replace");
    REQUIRE(run_program(other).code == 0);
    REQUIRE(samples::bytes_of(folder / "run/run.h5") != before);
}

TEST_CASE("list, describe, help and version work without a scene being run", "[faults]") {
    const nlohmann::json list = nlohmann::json::parse(run_program({"list", "--json"}).out);
    std::map<std::string, nlohmann::json> scenes;
    for (const nlohmann::json& one : list.at("scenes")) scenes[one.at("name").get<std::string>()] = one;
    for (const char* name : {"sinking_rectangle", "wedge", "flat_plate", "catamaran"})
        REQUIRE(scenes.count(name) == 1);
    const nlohmann::json& scene = scenes.at("dam_break");
    REQUIRE(scene.at("default_variant") == "two-phase");
    REQUIRE(scene.at("variants").size() == 6);
    REQUIRE_THAT(run_program({"list"}).out, Contains("single-phase"));
    REQUIRE_THAT(run_program({"describe", "dam_break"}).out,
                 Contains("pressure_gauge") && Contains("buchner2002_front  (curve not available") &&
                     Contains("model.smoothing_ratio          1.25 -> 1.5"));
    const std::string paper = run_program({"describe", "dam_break", "--variant", "paper"}).out;
    REQUIRE_THAT(paper, Contains("division -> same-sign-arithmetic") && !Contains("1.25 -> "));
    expect_refusal({"describe", "dam_break", "--variant", "kraken"}, "kraken");
    REQUIRE_THAT(run_program({"--version"}).out, Contains("commit ") && Contains("instruction set "));
    const std::string help = run_program({"--help"}).out;
    CHECK_THAT(help, Contains("Commands of the script ./wetdeck") && Contains("build and run all tests") &&
                         Contains("make the API pages"));
    CHECK(run_program({}).out == help);
    for (const char* command : {"suite", "run", "report", "list", "describe", "check"}) {
        const Outcome one = run_program({command, "--help"});
        REQUIRE(one.code == 0);
        REQUIRE_THAT(one.out, Contains("--help"));
    }
}
