// SPDX-License-Identifier: BSD-3-Clause
// Rows of a plan as a pool of processes on this machine.
#pragma once

#include <vector>

#include "validation/jobs/plan.hpp"

namespace wetdeck {

struct LocalOptions {
    RowOptions row;      ///< without a number of threads the cores are shared among the jobs
    int jobs = 0;        ///< runs at a time; 0: one per core
    bool quiet = false;  ///< no progress, failures only
};

/// Runs the rows that are not finished in the order given, interrupted ones from their last checkpoint. A
/// signal to stop is passed on to the runs; when they have stored their state, Interrupted is thrown. Returns
/// the worst exit code of a row (0, 3, or 2 and 4 for failures); a row that is expected to become
/// unstable counts as done.
int run_rows(const std::vector<SuiteRow>& rows, const LocalOptions& options);

}  // namespace wetdeck
