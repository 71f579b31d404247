// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck suite`: every run of a tier, their comparisons and the report.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/references.hpp"
#include "validation/commands/report.hpp"
#include "validation/commands/row_commands.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/stop_signal.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

struct SuiteOptions {
    PlanOptions plan;
    RowExecution execution;
    std::string directory;
    std::optional<Fields> fields;
};

int run_suite(SuiteOptions options) {
    catch_stop_signals();
    PlanOptions& plan = options.plan;
    RowExecution& execution = options.execution;
    execution.row.fields = options.fields.value_or(plan.tier == "quick" ? Fields::key : Fields::all);
    plan.directory =
        options.directory.empty() ? fs::path("results") / plan.tier : fs::path(options.directory);
    const std::vector<SuiteRow> rows = suite_rows(plan);
    if (execution.print_plan) return print_rows(rows, plan.tier, execution.json), exit_done;
    if (execution.row_number) return run_one_row(rows, execution);
    print_doubts(rows);
    check_references(rows);
    std::vector<std::string> planned;
    for (const SuiteRow& row : rows) planned.push_back(fs::relative(row.directory, plan.directory).string());
    write_suite_plan(plan.directory, plan.tier, planned);
    if (execution.executor == "slurm") {
        submit_rows(rows, plan.directory, suite_arguments(plan, execution.row), execution.slurm());
        return exit_done;
    }
    const int worst = run_rows(rows, execution.local());
    const int verdict = print_verdict(make_report(plan.directory), plan.directory);
    return worst != 0 ? worst : verdict;
}

}  // namespace

void add_suite(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<SuiteOptions>();
    CLI::App& command = *app.add_subcommand(
        "suite", "run every scene, variant and spacing of a tier, compare the results and write the report");
    add_tier(command, options->plan.tier);
    add_only(command, options->plan.scenes, "scenes (names or paths)", "SCENE");
    add_out(command, options->directory, "results/TIER");
    command
        .add_option("--replicates", options->plan.replicates,
                    "runs with other arrangements of the particles, of each variant that a scene names for "
                    "it (default: as the scene says; 0: none)")
        ->check(CLI::Range(0, 1000))
        ->type_name("N");
    add_fields(command, options->fields,
               "key in the quick tier, all in the others; runs of studies have none");
    add_row_execution(command, options->execution);
    command.callback([options, &exit_code] { exit_code = run_suite(*options); });
}

}  // namespace wetdeck
