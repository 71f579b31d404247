// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck resume`: continues an interrupted run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/run_outcome.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

struct ResumeOptions {
    std::string directory;
    Resources resources;
    Verbosity verbosity;
};

int resume(const ResumeOptions& options) {
    catch_stop_signals();
    if (!std::filesystem::is_directory(options.directory))
        throw InputError(
            fmt::format("{}: no such directory, expected that of an interrupted run", options.directory));
    if (holds_finished_run(options.directory)) {
        if (!options.verbosity.json) fmt::print("the run has finished already\n");
        return print_outcome(read_run(run_file(options.directory)), options.directory, options.verbosity);
    }
    const auto [scene, run] = interrupted_run(options.directory);
    return run_and_print(scene, run, options.resources, options.verbosity);
}

}  // namespace

void add_resume(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<ResumeOptions>();
    CLI::App& command = *app.add_subcommand(
        "resume",
        "continue an interrupted run from its last checkpoint, to the same bits as without interruption");
    add_directory(command, options->directory, "run directory");
    add_resources(command, options->resources);
    add_verbosity(command, options->verbosity);
    command.callback([options, &exit_code] { exit_code = resume(*options); });
}

}  // namespace wetdeck
