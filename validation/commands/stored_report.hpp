// SPDX-License-Identifier: BSD-3-Clause
// From the stored runs of a directory to summary.json and the report; nothing is run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Folder of the runs of ablation studies, below a directory of results.
inline constexpr const char* ablation_folder = "ablation";

/// Reads and analyses every run.h5 below `directory` and the tables of the other commands. Runs below
/// sensitivity/ and sound_speed/ are rows of those studies; runs of ablation studies are left out, since a
/// table holds their results. The tier is the one that suite.json names. Throws InputError if there is no
/// run, DataError for a run that cannot be read.
Summary analyse_directory(const std::filesystem::path& directory);

/// The same, and writes summary.json, the pages of the report and figures/; see reports/report.hpp.
Summary make_report(const std::filesystem::path& directory, bool single_file = false);

/// Writes suite.json with the planned runs, so that a later report can name the missing ones.
void write_suite_plan(const std::filesystem::path& directory, const std::string& tier,
                      const std::vector<std::string>& run_directories);

/// "comparison 'TITLE' is left out: ..." for each whose reference is there but cannot be used.
std::vector<std::string> unusable_curves(const Summary& summary);

/// Names of the claims of problems with exact solutions, and of the available comparisons and expected
/// quantities of the finest spacing of each variant, that lie outside their tolerance. Variants that are
/// expected to become unstable are left out.
std::vector<std::string> outside_tolerance(const Summary& summary);

}  // namespace wetdeck
