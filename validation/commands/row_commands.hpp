// SPDX-License-Identifier: BSD-3-Clause
// What the commands that run many rows share: where the rows are run, their plan, one row alone, doubts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/jobs/local.hpp"
#include "validation/jobs/slurm.hpp"

namespace CLI {
class App;
}

namespace wetdeck {

/// How and where the rows of a command are run.
struct RowExecution {
    RowOptions row;
    int jobs = 0;
    std::string executor = "local";
    std::string partition;
    int concurrent = 0;
    bool print_plan = false, json = false, quiet = false;
    std::optional<std::size_t> row_number;

    LocalOptions local() const { return {row, jobs, quiet}; }
    SlurmOptions slurm() const { return {row, partition, concurrent}; }
};

/// --jobs, --threads, --plan, --row, --executor and what belongs to it, --fresh, --checkpoint-interval,
/// --json, --quiet
void add_row_execution(CLI::App& command, RowExecution& execution);

/// The rows with their numbers, cost estimates and states, as a table or as JSON.
/// @param tier  or another name of the whole
void print_rows(const std::vector<SuiteRow>& rows, const std::string& tier, bool as_json);

/// Each doubt about the rows, once for each scene and variant.
void print_doubts(const std::vector<SuiteRow>& rows);

/// Runs the row of `execution.row_number` and returns its exit code. Throws InputError for one that is not
/// there.
int run_one_row(const std::vector<SuiteRow>& rows, const RowExecution& execution);

}  // namespace wetdeck
