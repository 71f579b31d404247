// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck run`: one run of a scene.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/references.hpp"
#include "validation/commands/run_outcome.hpp"
#include "validation/jobs/plan.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/scene/plausibility.hpp"

namespace wetdeck {
namespace {

struct RunCommand {
    std::string scene;
    RunChoice choice;
    std::vector<std::string> overrides;
    std::string directory;
    Resources resources;
    std::optional<Fields> fields;
    bool replace = false;
    Verbosity verbosity;
};

int run_command(const RunCommand& options) {
    catch_stop_signals();
    const Scene scene = read_scene(find_scene(options.scene), options.choice.variant, options.overrides);
    for (const std::string& note : scene.notes) fmt::print(stderr, "note: {}\n", note);
    check_references(scene);
    RunOptions run;
    run.particle_spacing =
        options.choice.particle_spacing ? *options.choice.particle_spacing : finest_quick_spacing(scene);
    for (const std::string& doubt : doubts_of_run(scene, run.particle_spacing, options.choice.until))
        fmt::print(stderr, "doubt: {}\n", doubt);
    run.until = options.choice.until;
    run.fields = options.fields.value_or(Fields::all);
    run.replace = options.replace;
    run.directory = options.directory.empty()
                        ? run_path("results", scene.name(), scene.variant, run.particle_spacing)
                        : std::filesystem::path(options.directory);
    return run_and_print(scene, run, options.resources, options.verbosity);
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<RunCommand>();
    CLI::App& command = *app.add_subcommand("run", "one run of a scene");
    add_scene(command, options->scene);
    add_run_choice(command, options->choice, "the finest of the quick tier");
    add_overrides(command, options->overrides);
    add_out(command, options->directory, "results/runs/SCENE/VARIANT/dxDX");
    add_fields(command, options->fields, "all");
    command.add_flag("--replace", options->replace, "replace the run that the directory holds");
    add_resources(command, options->resources);
    add_verbosity(command, options->verbosity);
    command.footer("If the directory holds a checkpoint of the same run, the run continues from there.");
    command.callback([options, &exit_code] { exit_code = run_command(*options); });
}

}  // namespace wetdeck
