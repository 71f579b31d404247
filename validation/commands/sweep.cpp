// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck sweep`: one scene over a grid of the values of its keys.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/references.hpp"
#include "validation/commands/row_commands.hpp"
#include "validation/commands/stored_sweep.hpp"
#include "validation/jobs/local.hpp"
#include "validation/jobs/sweep.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/store/child_process.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

struct SweepOptions {
    std::string scene, directory, tier = "quick";
    std::optional<std::string> variant;
    std::vector<std::string> over, overrides;
    std::vector<double> spacings;
    RowExecution execution;
};

/// The plan that the options ask for.
SweepPlan plan_of(const SweepOptions& options) {
    const Scene scene = read_scene(find_scene(options.scene), options.variant, options.overrides);
    SweepPlan plan{options.scene,
                   scene.variant,
                   {},
                   options.spacings,
                   options.overrides,
                   options.directory.empty() ? fs::path("results") / "sweep" : fs::path(options.directory)};
    if (fs::exists(options.scene)) plan.scene = fs::absolute(options.scene).lexically_normal().string();
    for (const std::string& text : options.over) plan.axes.push_back(parse_axis(text, scene));
    if (plan.spacings.empty()) {
        const auto tier = scene.tiers.find(options.tier);
        if (tier != scene.tiers.end() && tier->second.contains(scene.variant))
            plan.spacings = tier->second.at(scene.variant);
        if (plan.spacings.empty())
            throw InputError(fmt::format("{}: tier '{}' has no spacing of the variant {}, expected --dx",
                                         scene.path, options.tier, scene.variant));
    }
    std::sort(plan.spacings.rbegin(), plan.spacings.rend());
    plan.spacings.erase(std::unique(plan.spacings.begin(), plan.spacings.end()), plan.spacings.end());
    return plan;
}

/// A sweep of other points in the same directory would leave runs that belong to nothing.
void check_directory(const SweepPlan& plan) {
    if (!holds_sweep(plan.directory)) return;
    const SweepPlan stored = read_sweep_plan(plan.directory);
    if (stored.scene == plan.scene && stored.variant == plan.variant) return;
    throw InputError(fmt::format("{}: holds a sweep of {}, variant {}: expected another directory",
                                 plan.directory.string(), stored.scene, stored.variant));
}

std::string sweep_arguments(const SweepPlan& plan, const SweepOptions& options) {
    std::string arguments = fmt::format(
        "sweep {} --variant {} --out {} --threads {}", shell_quoted(plan.scene), shell_quoted(plan.variant),
        shell_quoted(fs::absolute(plan.directory).string()), std::max(1, options.execution.row.threads));
    for (const std::string& over : options.over) arguments += " --over " + shell_quoted(over);
    for (const std::string& set : plan.overrides) arguments += " --set " + shell_quoted(set);
    for (const double dx : plan.spacings) arguments += fmt::format(" --dx {}", dx);
    if (options.execution.row.fresh) arguments += " --fresh";
    return arguments;
}

int run_sweep(const SweepOptions& options) {
    catch_stop_signals();
    const SweepPlan plan = plan_of(options);
    check_directory(plan);
    std::vector<SuiteRow> rows = sweep_rows(plan);
    const RowExecution& execution = options.execution;
    if (execution.print_plan) return print_rows(rows, "sweep", execution.json), exit_done;
    if (execution.row_number) return run_one_row(rows, execution);
    if (plan.spacings.size() < 3)
        fmt::print(stderr, "doubt: {} spacing{} at each point: u_num needs three and stays unknown\n",
                   plan.spacings.size(), plan.spacings.size() > 1 ? "s" : "");
    print_doubts(rows);
    check_references(rows);
    write_sweep_plan(plan);
    if (execution.executor == "slurm") {
        submit_rows(rows, plan.directory, sweep_arguments(plan, options), execution.slurm());
        return exit_done;
    }
    const int worst = run_rows(rows, execution.local());
    const int verdict = print_sweep(make_sweep_report(plan.directory), plan.directory);
    return worst != 0 ? worst : verdict;
}

}  // namespace

void add_sweep(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<SweepOptions>();
    CLI::App& command = *app.add_subcommand(
        "sweep",
        "run a scene over a grid of values of its keys, and write the design curves: DIR/sweep.csv "
        "and DIR/index.html");
    add_scene(command, options->scene);
    command
        .add_option("--over", options->over,
                    "a key of the scene file or the name of one of its parameters, and its values: "
                    "KEY=FROM:TO:COUNT, or KEY=\"FROM:TO:COUNT UNIT\"; once for each axis of the grid")
        ->required()
        ->allow_extra_args(false)
        ->type_name("KEY=FROM:TO:COUNT");
    add_variant(command, options->variant);
    command.add_option("--dx", options->spacings, "particle spacing [m] (default: those of the tier)")
        ->allow_extra_args(false)
        ->check(CLI::PositiveNumber)
        ->type_name("M");
    add_tier(command, options->tier);
    add_overrides(command, options->overrides);
    add_out(command, options->directory, "results/sweep");
    add_row_execution(command, options->execution);
    command.footer(
        "--dx may be given several times: three or more spacings give the numerical uncertainty u_num. A "
        "sweep that was "
        "interrupted continues when the same command is given again.");
    command.callback([options, &exit_code] { exit_code = run_sweep(*options); });
}

}  // namespace wetdeck
