// SPDX-License-Identifier: BSD-3-Clause
// The results of a sweep from its stored runs.
#pragma once

#include <filesystem>

#include "validation/metrics/sweep_result.hpp"

namespace wetdeck {

/// Whether a directory holds a sweep.
bool holds_sweep(const std::filesystem::path& directory);

/// Analyses the runs of the sweep in a directory, and writes sweep.csv and the report, index.html. Throws
/// DataError for stored data that are not sound.
SweepResult make_sweep_report(const std::filesystem::path& directory, bool single_file = false);

/// Prints where the results lie, the points that are missing or became unstable, and those outside their
/// tolerance; returns the exit code.
int print_sweep(const SweepResult& result, const std::filesystem::path& directory);

}  // namespace wetdeck
