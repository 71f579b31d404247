// SPDX-License-Identifier: BSD-3-Clause
// The command line as data: what every command and option says of itself, what the shell may complete, and
// what is refused before anything runs.
#include "validation/program/command_line.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/program/completion.hpp"
#include "validation/run/exit_code.hpp"

using namespace wetdeck;
using Words = std::vector<std::string>;

namespace {

const OptionInfo& option_of(const CommandInfo& command, const std::string& name) {
    const auto found = std::find_if(command.options.begin(), command.options.end(),
                                    [&](const OptionInfo& option) { return option.name == name; });
    REQUIRE(found != command.options.end());
    return *found;
}

CommandInfo command_named(const std::string& name) {
    for (const CommandInfo& command : command_list())
        if (command.name == name) return command;
    FAIL("no command " << name);
    return {};
}

std::set<std::string> completed(const Words& words) {
    const Words all = completions(words);
    return {all.begin(), all.end()};
}

}  // namespace

TEST_CASE("Every command and every option has a description, and a command's name is unique", "[program]") {
    std::set<std::string> names;
    for (const CommandInfo& command : command_list()) {
        CAPTURE(command.name);
        CHECK(names.insert(command.name).second);
        CHECK_FALSE(command.description.empty());
        std::set<std::string> options;
        for (const OptionInfo& option : command.options) {
            CAPTURE(option.name);
            CHECK(options.insert(option.name).second);
            CHECK_FALSE(option.description.empty());
        }
        CHECK(options.count("-h, --help") == 1);
    }
    const Words promised = {"suite",  "sweep", "run",      "resume",   "verify", "stress",
                            "ablate", "bench", "report",   "baseline", "list",   "describe",
                            "check",  "new",   "sections", "export",   "peer",   "import"};
    for (const std::string& name : promised) CHECK(names.count(name) == 1);
}

TEST_CASE("An option of the same name and kind of value reads the same in every command", "[program]") {
    std::map<std::string, std::string> descriptions;
    for (const CommandInfo& command : command_list()) {
        for (const OptionInfo& option : command.options) {
            const std::string& name = option.name;
            for (const char* shared :
                 {"--variant", "--until", "--jobs", "--fresh", "--checkpoint-interval"}) {
                if (name != shared) continue;
                CAPTURE(command.name, name);
                CHECK(descriptions.emplace(name, option.description).first->second == option.description);
            }
        }
    }
    CHECK(descriptions.size() == 5);
}

TEST_CASE("Values, defaults and choices of options are listed, arguments come first", "[program]") {
    const CommandInfo suite = command_named("suite");
    const OptionInfo& executor = option_of(suite, "--executor");
    CHECK(executor.choices == Words{"local", "slurm"});
    CHECK(executor.description.ends_with("(default: local)"));
    CHECK(option_of(suite, "--only").value == "SCENE,...");
    CHECK(option_of(suite, "--fresh").value.empty());
    CHECK(option_of(suite, "-q, --quiet").value.empty());
    CHECK(option_of(suite, "--jobs").value == "N");
    const CommandInfo baseline = command_named("baseline");
    CHECK(baseline.options[0].positional);
    CHECK(baseline.options[0].choices == Words{"write", "compare"});
    CHECK(baseline.options[1].name == "directory");
    CHECK_FALSE(baseline.options[2].positional);
}

TEST_CASE("Completion knows a value by its name in the help", "[program]") {
    CHECK(completed({"verify", "--only", "taylor"}) == std::set<std::string>{"taylor_green"});
    CHECK(completed({"ablate", "flat"}) == std::set<std::string>{"flat_plate"});
    CHECK(completed({"suite", "--tier", ""}) == std::set<std::string>{"quick", "standard", "paper"});
    CHECK(completed({"ablate", "dam_break", "--variant", "single"}) == std::set<std::string>{"single-phase"});
    CHECK(completed({"baseline", "w"}) == std::set<std::string>{"write"});
    CHECK(completed({"check", ""}).empty());
    CHECK(completed({"report", "--publish", ""}).empty());
    CHECK(completed({"dance", ""}).empty());
    CHECK(completed({}).empty());
}

TEST_CASE("A misspelt word leads to the nearest name, a different word to none", "[program]") {
    Words names;
    for (const CommandInfo& command : command_list()) names.push_back(command.name);
    const std::map<std::string, std::string> misspelt = {
        {"suit", "suite"},        {"siute", "suite"},      {"rnu", "run"},          {"repotr", "report"},
        {"reprot", "report"},     {"resumed", "resume"},   {"chek", "check"},       {"lsit", "list"},
        {"decsribe", "describe"}, {"verfiy", "verify"},    {"strss", "stress"},     {"benhc", "bench"},
        {"ablte", "ablate"},      {"basline", "baseline"}, {"discribe", "describe"}};
    for (const auto& [word, expected] : misspelt) {
        CAPTURE(word);
        CHECK(nearest_name(word, names) == expected);
    }
    for (const std::string word : {"dance", "", "plot", "visualise"}) {
        CAPTURE(word);
        CHECK(nearest_name(word, names).empty());
    }
    CHECK(nearest_name("run", {}).empty());
}

TEST_CASE("A stop time or spacing that is not positive and finite is refused before anything runs",
          "[program]") {
    for (const std::string command : {"run", "ablate"}) {
        for (const std::string value : {"0", "-0.5", "nan", "inf"}) {
            CAPTURE(command, value);
            CHECK_THROWS_WITH(run_command_line({command, "dam_break", "--until", value}),
                              "--until is " + value + ", expected a positive time [s]");
            CHECK_THROWS_WITH(run_command_line({command, "dam_break", "--dx", value}),
                              "--dx is " + value + ", expected a positive spacing [m]");
        }
    }
}

TEST_CASE("Bad usage returns its exit code", "[program]") {
    for (const Words& words : {Words{"suit"}, Words{"run"}, Words{"run", "dam_break", "--colour"},
                               Words{"suite", "--executor", "none"}, Words{"--colour"}}) {
        CAPTURE(words.back());
        CHECK(run_command_line(words) == exit_usage);
    }
}
