// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck suite`: every run of a tier, their comparisons and the report.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/references.hpp"
#include "validation/commands/report.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/jobs/local.hpp"
#include "validation/jobs/slurm.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/progress.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

struct SuiteOptions {
    PlanOptions plan;
    RowOptions row;
    std::string directory;
    std::optional<Fields> fields;
    int jobs = 0;
    std::string executor = "local";
    std::string partition;
    int concurrent = 0;
    bool print_plan = false, json = false, quiet = false;
    std::optional<std::size_t> row_number;
};

/// What is there of a row, and the program revision that did it.
struct RowState {
    std::string name;  ///< "done", "interrupted" or "to do"
    std::string revision = {};
};

RowState state_of(const SuiteRow& row) {
    if (finished(row)) return {"done", provenance_entry(read_run(run_file(row.directory)), "commit")};
    return {interrupted(row) ? "interrupted" : "to do"};
}

/// The rows with their numbers, cost estimates and states.
void print_plan(const PlanOptions& options, bool as_json) {
    double left = 0;
    nlohmann::json plan = nlohmann::json::array();
    if (!as_json)
        fmt::print("{:>4}  {:>10}  {:>11}  {:>12}  {}\n", "row", "core s", "state", "revision", "run");
    for (const SuiteRow& row : suite_rows(options)) {
        const RowState state = state_of(row);
        if (state.name != "done") left += row.estimated_core_seconds;
        if (!as_json)
            fmt::print("{:>4}  {:>10.4g}  {:>11}  {:>12}  {}\n", plan.size(), row.estimated_core_seconds,
                       state.name, state.revision.substr(0, 12), row_name(row));
        plan.push_back(
            {{"row", plan.size()},
             {"scene", row.scene},
             {"variant", row.variant},
             {"dx", row.particle_spacing},
             {"overrides", row.overrides},
             {"core_s", row.estimated_core_seconds},
             {"state", state.name},
             {"revision", state.revision.empty() ? nlohmann::json() : nlohmann::json(state.revision)},
             {"directory", row.directory.string()}});
    }
    if (as_json) {
        const nlohmann::json all = {{"tier", options.tier}, {"core_s_left", left}, {"rows", plan}};
        return fmt::print("{}\n", all.dump(1));
    }
    fmt::print("about {} of work for one core remain\n", duration_text(left));
}

/// Each doubt about the rows, once for each scene and variant.
void print_doubts(const std::vector<SuiteRow>& rows) {
    std::set<std::string> told;
    for (const SuiteRow& row : rows) {
        const Scene scene = read_scene(find_scene(row.scene), row.variant, row.overrides);
        for (const std::string& doubt : doubts_of_run(scene, row.particle_spacing)) {
            const std::string line = fmt::format("doubt: {} {}: {}", scene.name(), row.variant, doubt);
            if (told.insert(line).second) fmt::print(stderr, "{}\n", line);
        }
    }
}

LocalOptions local_options(const SuiteOptions& options) {
    return {options.row, options.jobs, options.quiet};
}

int run_one_row(const SuiteOptions& options, std::size_t number) {
    const std::vector<SuiteRow> rows = suite_rows(options.plan);
    if (number >= rows.size())
        throw InputError(
            fmt::format("--row is {}, expected one of 0 to {}, see --plan", number, rows.size() - 1));
    check_references({rows[number]});
    return run_rows({rows[number]}, local_options(options));
}

int run_suite(SuiteOptions options) {
    catch_stop_signals();
    PlanOptions& plan = options.plan;
    options.row.fields = options.fields.value_or(plan.tier == "quick" ? Fields::key : Fields::all);
    plan.directory =
        options.directory.empty() ? fs::path("results") / plan.tier : fs::path(options.directory);
    if (options.print_plan) return print_plan(plan, options.json), exit_done;
    if (options.row_number) return run_one_row(options, *options.row_number);
    const std::vector<SuiteRow> rows = suite_rows(plan);
    print_doubts(rows);
    check_references(rows);
    std::vector<std::string> planned;
    for (const SuiteRow& row : rows) planned.push_back(fs::relative(row.directory, plan.directory).string());
    write_suite_plan(plan.directory, plan.tier, planned);
    if (options.executor == "slurm")
        return submit_suite(plan, {options.row, options.partition, options.concurrent}), exit_done;
    const int worst = run_rows(rows, local_options(options));
    const int verdict = print_verdict(make_report(plan.directory), plan.directory);
    return worst != 0 ? worst : verdict;
}

void add_slurm(CLI::App& command, SuiteOptions& options) {
    command
        .add_option("--executor", options.executor,
                    "local, or slurm: submit the runs that are not finished as a job array")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--partition", options.partition, "slurm: partition (default: that of the cluster)")
        ->type_name("NAME");
    command
        .add_option("--concurrent", options.concurrent, "slurm: number of jobs at a time (default: no limit)")
        ->check(CLI::Range(1, 100000))
        ->type_name("N");
}

}  // namespace

void add_suite(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<SuiteOptions>();
    CLI::App& command = *app.add_subcommand(
        "suite", "run every scene, variant and spacing of a tier, compare the results and write the report");
    command.add_option("--tier", options->plan.tier, "quick, standard or paper")
        ->type_name("TIER")
        ->capture_default_str();
    add_only(command, options->plan.scenes, "scenes (names or paths)", "SCENE");
    add_out(command, options->directory, "results/TIER");
    command
        .add_option("--replicates", options->plan.replicates,
                    "runs with other arrangements of the particles, of each variant that a scene names for "
                    "it (default: as the scene says; 0: none)")
        ->check(CLI::Range(0, 1000))
        ->type_name("N");
    add_jobs(command, options->jobs);
    add_threads(command, options->row.threads,
                "number of threads of each run (default: the cores divided by the number of jobs)");
    command.add_flag("--plan", options->print_plan,
                     "print the runs with their estimated cost and state, without running them");
    command.add_option("--row", options->row_number, "run only this row of the plan, without a report")
        ->type_name("N");
    add_slurm(command, *options);
    add_fields(command, options->fields,
               "key in the quick tier, all in the others; runs of studies have none");
    add_fresh(command, options->row.fresh);
    add_checkpoint_interval(command, options->row.checkpoint_interval);
    add_json(command, options->json, "with --plan: print JSON, for scripts");
    add_quiet(command, options->quiet);
    command.callback([options, &exit_code] { exit_code = run_suite(*options); });
}

}  // namespace wetdeck
