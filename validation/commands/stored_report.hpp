// SPDX-License-Identifier: BSD-3-Clause
// From the stored runs of a directory to summary.json and index.html; nothing is run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Where the runs of ablation studies lie below a directory of runs.
inline constexpr const char* ablation_folder = "ablation";

/// Reads every run.h5 below `directory` (those below sensitivity/ as rows of that study; those of ablation
/// studies are left out: their table says what they gave) and what the other commands left there, and
/// analyses them. The tier is the one that suite.json names. Throws InputError if there is no run, DataError
/// for a run that cannot be read.
Summary analyse_directory(const std::filesystem::path& directory);

/// The same, and writes summary.json, index.html and figures/.
Summary make_report(const std::filesystem::path& directory);

/// Remembers what a suite set out to run, so that a later report knows what is missing.
void write_suite_plan(const std::filesystem::path& directory, const std::string& tier,
                      const std::vector<std::string>& run_directories);

/// Names of what lies outside its tolerance: claims of problems with exact solutions, and available
/// comparisons and expected quantities of the finest spacing of each variant but `paper`.
std::vector<std::string> outside_tolerance(const Summary& summary);

}  // namespace wetdeck
