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

/// Submits the rows that are not done, unless jobs of the last submission are still queued or running. Throws
/// EnvironmentError where Slurm is absent or refuses.
void submit_suite(const PlanOptions& plan, const SlurmOptions& options);

}  // namespace wetdeck
