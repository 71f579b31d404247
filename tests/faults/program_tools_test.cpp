// SPDX-License-Identifier: BSD-3-Clause
// What shells, scripts and readers ask of the program: manual page, completion, JSON, quiet and verbose.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using nlohmann::json;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;

namespace {

std::string output_of(const std::vector<std::string>& arguments, int code = 0) {
    const Outcome outcome = run_program(arguments);
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == code);
    return outcome.out;
}

json json_of(const std::vector<std::string>& arguments, int code = 0) {
    return json::parse(output_of(arguments, code));
}

std::set<std::string> matches(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
        found.insert((*match)[1]);
    return found;
}

/// Commands of the program as the help lists them, before those of the script.
std::set<std::string> commands() {
    const std::string help = output_of({"--help"});
    const std::size_t begin = help.find("Subcommands:"), end = help.find("Commands of the script", begin);
    return matches(help.substr(begin, end - begin), "\n  ([a-z]+) ");
}

std::set<std::string> options_of(const std::string& command) {
    return matches(output_of({command, "--help"}), "\n  (?:-[a-z],)?(--[a-z-]+)");
}

bool installed(const char* program) {
    return std::system((std::string("command -v ") + program + " >/dev/null").c_str()) == 0;
}

std::string shell(const std::string& line) {
    FILE* pipe = ::popen(("bash -c '" + line + "' 2>&1").c_str(), "r");
    std::string text;
    for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
        text += static_cast<char>(letter);
    ::pclose(pipe);
    return text;
}

/// What bash would offer for the last word.
std::set<std::string> offered(const std::string& words) {
    const std::string script = WETDECK_SOURCE_DIR "/validation/program/completion.bash";
    return matches(shell("source " + script + "; COMP_WORDS=(wetdeck " + words + "); " +
                         "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _wetdeck " + WETDECK_PROGRAM +
                         "; printf \"%s\\n\" \"${COMPREPLY[@]}\""),
                   "(.+)\n");
}

}  // namespace

TEST_CASE("the manual page has every command and every option, and is sound roff", "[faults]") {
    const ScratchFolder folder;
    const std::string page = output_of({"--manual"});
    REQUIRE(commands().size() >= 12);
    for (const std::string& command : commands()) {
        const std::size_t begin = page.find("\n.SS " + command + "\n"), end = page.find("\n.S", begin + 4);
        REQUIRE(begin != std::string::npos);
        const std::string section = page.substr(begin, end - begin);
        REQUIRE(options_of(command).count("--help") == 1);
        for (const std::string& option : options_of(command)) {
            CAPTURE(command, option);
            CHECK_THAT(section, Contains(std::regex_replace(option, std::regex("-"), "\\-") + "\\fR"));
        }
    }
    samples::put_bytes(folder / "wetdeck.1", page);
    const std::string file = (folder / "wetdeck.1").string();
    if (installed("groff")) {
        CHECK(shell("groff -man -ww -z -Tutf8 " + file).empty());
    } else {
        WARN("not tested: the page with groff");
    }
}

TEST_CASE("bash completes commands, options, scenes, variants, tiers and lists", "[faults]") {
    const std::set<std::string> all = commands();
    CHECK(offered("\"\"") == all);
    CHECK(offered("des") == std::set<std::string>{"describe"});
    for (const std::string& command : all) {
        CAPTURE(command);
        CHECK(offered(command + " --") == options_of(command));
    }
    CHECK(offered("run \"\"").count("dam_break") == 1);
    CHECK(offered("run we") == std::set<std::string>{"wedge", "wedge_deadrise", "wedge_yettou"});
    CHECK(offered("run dam_break --variant \"\"") == std::set<std::string>{"two-phase", "single-phase",
                                                                           "paper", "paper-no-switch",
                                                                           "paper-central", "paper-literal"});
    CHECK(offered("suite --tier s") == std::set<std::string>{"standard"});
    CHECK(offered("suite --executor \"\"") == std::set<std::string>{"local", "slurm"});
    CHECK(offered("suite --only dam_break,cat") == std::set<std::string>{"dam_break,catamaran"});
    CHECK(offered("verify --only taylor").count("taylor_green") == 1);
    CHECK(offered("stress --only body_d") == std::set<std::string>{"body_density"});
    CHECK(offered("baseline \"\"") == std::set<std::string>{"write", "compare"});
    CHECK(offered("run dam_break --out x").empty());
    CHECK(offered("dance \"\"").empty());
}

TEST_CASE("scripts get JSON from the version, a description and a check", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder);
    CHECK_THAT(output_of({"--version"}),
               Contains(json_of({"--version", "--json"}).at("version").get<std::string>()));
    const json described = json_of({"describe", scene, "--json"});
    CHECK(described.at("name") == "small");
    CHECK(described.at("tank") == json({1.0, 0.48}));
    CHECK(described.at("references")[0].at("available") == false);
    CHECK(described.at("cost").size() == 3);
    const json good = json_of({"check", scene, "--json"});
    CHECK(good.at("valid") == true);
    CHECK(good.at("variants") == json({"two-phase", "single-phase"}));
    REQUIRE(good.at("missing_references").size() == 1);
    const std::string curve = folder / (good.at("missing_references")[0].get<std::string>() + ".csv");
    samples::put_bytes(curve, "a,b\n1,2\n");
    const Outcome unsound = run_program({"check", scene});
    CHECK(unsound.code == 2);
    CHECK_THAT(unsound.err, Contains(curve));
    std::filesystem::remove(curve);
    samples::put_bytes(scene, samples::with("end_time = 0.2", "end_time = \"soon\""));
    const Outcome outcome = run_program({"check", scene, "--json"});
    CHECK(outcome.code == 2);
    CHECK(outcome.one_line());
    const json bad = json::parse(outcome.out);
    CHECK(bad.at("valid") == false);
    CHECK("wetdeck: " + bad.at("message").get<std::string>() + "\n" == outcome.err);
}

TEST_CASE("scripts get JSON from a plan, a run and a comparison with a baseline", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder), out = folder / "out";
    const std::vector<std::string> plan = {"suite", "--only", scene, "--out", out, "--plan", "--json"};
    const json before = json_of(plan);
    REQUIRE(before.at("rows").size() == 2);
    CHECK(before.at("rows")[1].at("state") == "to do");
    CHECK(before.at("core_s_left") > 0);
    const std::string directory = before.at("rows")[1].at("directory");
    const json run = json_of(
        {"run", scene, "--variant", "single-phase", "--dx", "0.04", "--json", "--quiet", "--out", directory});
    CHECK(run.at("status") == "ok");
    CHECK(run.at("steps") > 10);
    CHECK(json_of(plan).at("rows")[1].at("state") == "done");
    CHECK(json_of({"resume", directory, "--json"}).at("steps") == run.at("steps"));
}

TEST_CASE("quiet says what came out and nothing else, verbose where the time went", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder);
    const auto run = [&](const std::string& how, const std::string& out) {
        return output_of(
            {"run", scene, "--variant", "single-phase", "--dx", "0.04", how, "--out", folder / out});
    };
    CHECK(run("--quiet", "a") == "small single-phase dx 0.04: ok\n");
    CHECK_THAT(run("--verbose", "b"),
               Contains("momentum") && Contains("acoustic_water     set the size of "));
    const std::string suite = output_of({"suite", "--only", scene, "--quiet", "--out", folder / "out"});
    CHECK(suite == "report: " + (folder / "out/index.html").string() + "\n");
}

TEST_CASE("the page of the keys is what the program prints", "[faults]") {
    const Outcome keys = run_program({"describe", "--keys"});
    REQUIRE(keys.code == 0);
    std::ifstream file(std::string(WETDECK_SOURCE_DIR) + "/docs/keys.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    CHECK_THAT(page, Contains(keys.out));
    const auto rows = nlohmann::json::parse(run_program({"describe", "--keys", "--json"}).out);
    CHECK(rows.size() > 150);
    CHECK(run_program({"describe"}).code == 2);
    const auto scene = nlohmann::json::parse(run_program({"describe", "wedge", "--json"}).out);
    CHECK(scene.at("parameters").at("model.wall_pressure") == "shepard-water");
}
