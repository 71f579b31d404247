// SPDX-License-Identifier: BSD-3-Clause
// What the user may write: commands and options, as parsed and as a list for the manual and for completion.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/benchmark/benchmark.hpp"
#include "validation/commands/stress.hpp"
#include "validation/commands/verify.hpp"
#include "validation/jobs/slurm.hpp"
#include "validation/jobs/suite.hpp"

namespace wetdeck {

struct Options {
    std::string command;  ///< empty: none was given
    bool version = false;
    // run
    std::string scene;
    std::string variant;
    std::optional<double> particle_spacing;
    std::vector<std::string> overrides;
    double until = 0;
    int threads = 0;
    bool replace = false;
    double checkpoint_interval = RunOptions{}.checkpoint_interval;
    // suite
    SuiteOptions suite;
    bool plan = false;
    std::string executor = "local";
    SlurmOptions slurm;
    // bench
    BenchmarkOptions bench;
    std::string json_file;
    // verify
    VerifyOptions verify;
    // stress
    StressOptions stress;
    // report, baseline
    std::string publish, action, baseline;
    // all
    std::string out;
    bool json = false, quiet = false, verbose = false;
};

/// The options, or the exit code where the command line asks for help or is wrong, which is then said.
struct ParsedCommandLine {
    Options options;
    std::optional<int> exit_code;
};
ParsedCommandLine parse_command_line(int argc, char** argv);

std::string help_text();

struct OptionInfo {
    std::string name;   ///< "--tier", or that of a positional one: "scene"
    std::string value;  ///< what it takes: "DIR"; empty for a flag
    std::string description;
    bool positional = false;
};

struct CommandInfo {
    std::string name;
    std::string description;
    std::string footer;
    std::vector<OptionInfo> options;  ///< positional ones first
};

/// Every command, in the order of the help; the program itself, without a name, comes first.
std::vector<CommandInfo> command_list();

/// "wetdeck: MESSAGE" on stderr, one line whatever the names in it hold.
void complain(std::string message);

}  // namespace wetdeck
