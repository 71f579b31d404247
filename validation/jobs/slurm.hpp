// SPDX-License-Identifier: BSD-3-Clause
// The rows of a plan as a Slurm job array, and a job that depends on it and writes the report.
//
// Which rows are done is read from the runs' own files, never from Slurm's accounting, which few clusters
// keep.
#pragma once

#include <string>
#include <vector>

#include "validation/jobs/plan.hpp"

namespace wetdeck {

struct SlurmOptions {
    RowOptions row;         ///< without a number of threads each run takes one
    std::string partition;  ///< empty: the cluster's default
    int concurrent = 0;     ///< array tasks at a time; 0: no limit
};

/// Rows by array task, longest first: short ones share a task, so that each has some minutes of work.
std::vector<std::vector<std::size_t>> grouped(const std::vector<double>& core_seconds);

/// Submits the rows that are not done, unless jobs of the last submission are still queued or running, and a
/// report of the directory. Throws EnvironmentError where Slurm is absent or refuses.
/// @param arguments  of this program which, with `--row N` behind them, run one row
void submit_rows(const std::vector<SuiteRow>& rows, const std::filesystem::path& directory,
                 const std::string& arguments, const SlurmOptions& options);

/// Arguments of `wetdeck suite` for submit_rows().
std::string suite_arguments(const PlanOptions& plan, const RowOptions& row);

}  // namespace wetdeck
