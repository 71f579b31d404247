// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/row_commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/references.hpp"
#include "validation/run/progress.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

/// What is there of a row, and the program revision that did it.
struct RowState {
    std::string name;  ///< "done", "interrupted" or "to do"
    std::string revision = {};
};

RowState state_of(const SuiteRow& row) {
    if (finished(row)) return {"done", provenance_entry(read_run(run_file(row.directory)), "commit")};
    return {interrupted(row) ? "interrupted" : "to do"};
}

void add_slurm(CLI::App& command, RowExecution& execution) {
    command
        .add_option("--executor", execution.executor,
                    "local, or slurm: submit the runs that are not finished as a job array")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--partition", execution.partition, "slurm: partition (default: that of the cluster)")
        ->type_name("NAME");
    command
        .add_option("--concurrent", execution.concurrent,
                    "slurm: number of jobs at a time (default: no limit)")
        ->check(CLI::Range(1, 100000))
        ->type_name("N");
}

}  // namespace

void add_row_execution(CLI::App& command, RowExecution& execution) {
    add_jobs(command, execution.jobs);
    add_threads(command, execution.row.threads,
                "number of threads of each run (default: the cores divided by the number of jobs)");
    command.add_flag("--plan", execution.print_plan,
                     "print the runs with their estimated cost and state, without running them");
    command.add_option("--row", execution.row_number, "run only this row of the plan, without a report")
        ->type_name("N");
    add_slurm(command, execution);
    add_fresh(command, execution.row.fresh);
    add_checkpoint_interval(command, execution.row.checkpoint_interval);
    add_json(command, execution.json, "with --plan: print JSON, for scripts");
    add_quiet(command, execution.quiet);
}

void print_rows(const std::vector<SuiteRow>& rows, const std::string& tier, bool as_json) {
    double left = 0;
    nlohmann::json plan = nlohmann::json::array();
    if (!as_json)
        fmt::print("{:>4}  {:>10}  {:>11}  {:>12}  {}\n", "row", "core s", "state", "revision", "run");
    for (const SuiteRow& row : rows) {
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
        const nlohmann::json all = {{"tier", tier}, {"core_s_left", left}, {"rows", plan}};
        return fmt::print("{}\n", all.dump(1));
    }
    fmt::print("about {} of work for one core remain\n", duration_text(left));
}

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

int run_one_row(const std::vector<SuiteRow>& rows, const RowExecution& execution) {
    const std::size_t number = *execution.row_number;
    if (number >= rows.size())
        throw InputError(
            fmt::format("--row is {}, expected one of 0 to {}, see --plan", number, rows.size() - 1));
    check_references({rows[number]});
    return run_rows({rows[number]}, execution.local());
}

}  // namespace wetdeck
