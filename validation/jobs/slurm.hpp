// SPDX-License-Identifier: BSD-3-Clause
// The rows of a suite as a Slurm job array, with the report as a job behind it.
//
// What is done is known from the runs' own files, never from Slurm's accounting, which few clusters keep.
#pragma once

#include <string>
#include <vector>

#include "validation/jobs/suite.hpp"

namespace wetdeck {

struct SlurmOptions {
    std::string partition;  ///< empty: the cluster's default
    int concurrent = 0;     ///< array tasks at a time; 0: no limit
};

/// Rows by array task, longest first: short ones share a task, so that each has some minutes of work.
std::vector<std::vector<std::size_t>> grouped(const std::vector<double>& core_seconds);

/// Submits the rows that are not done, unless the last submission is still at work. Throws EnvironmentError
/// where Slurm is absent or refuses.
void submit_suite(const SuiteOptions& options, const SlurmOptions& slurm);

}  // namespace wetdeck
