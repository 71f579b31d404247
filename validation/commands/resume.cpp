// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck resume`: continues a run that was interrupted, or that ended before the time asked for.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/references.hpp"
#include "validation/commands/run_outcome.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

struct ResumeOptions {
    std::string directory;
    std::optional<double> until;
    Resources resources;
    Verbosity verbosity;
};

/// Whether a run that has ended is asked to go on to a later time.
bool goes_on(const ResumeOptions& options) {
    if (!options.until) return false;
    const RunRecord record = read_run(run_file(options.directory));
    if (record.status != RunStatus::ok)
        throw InputError(
            fmt::format("{}: the run ended {}, it cannot go on", options.directory, record.stop_reason));
    const auto asked = record.parameters.find("run.until");
    const double end =
        asked == record.parameters.end() ? record.parameters.at("run.end_time") : asked->second;
    if (*options.until < end)
        throw InputError(fmt::format("--until is {} s, expected a time after the end of the run at {} s",
                                     *options.until, end));
    return *options.until > end;
}

int resume(const ResumeOptions& options) {
    catch_stop_signals();
    if (!std::filesystem::is_directory(options.directory))
        throw InputError(fmt::format("{}: no such directory, expected that of a run", options.directory));
    if (holds_finished_run(options.directory) && !goes_on(options)) {
        if (!options.verbosity.json) fmt::print("the run has finished already\n");
        return print_outcome(read_run(run_file(options.directory)), options.directory, options.verbosity);
    }
    const auto [scene, run] = interrupted_run(options.directory, options.until);
    check_references(scene);
    return run_and_print(scene, run, options.resources, options.verbosity);
}

}  // namespace

void add_resume(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<ResumeOptions>();
    CLI::App& command = *app.add_subcommand(
        "resume",
        "continue a run from its last checkpoint, to the same bits as without interruption: one that was "
        "interrupted, or with --until one that has ended");
    add_directory(command, options->directory, "run directory");
    add_until(command, options->until);
    add_resources(command, options->resources);
    add_verbosity(command, options->verbosity);
    command.callback([options, &exit_code] { exit_code = resume(*options); });
}

}  // namespace wetdeck
