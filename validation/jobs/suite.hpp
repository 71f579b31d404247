// SPDX-License-Identifier: BSD-3-Clause
// The matrix of runs of a tier: scene x variant x spacing, run by a local pool of processes, longest first.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "validation/run/run.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

struct SuiteRow {
    std::string scene;  ///< name or path
    std::string variant;
    double particle_spacing = 0;
    double estimated_core_seconds = 0;
    std::vector<std::string> overrides;  ///< one KEY=VALUE for a row of the sensitivity study
    std::filesystem::path directory;     ///< of the run
    std::optional<double> until = {};    ///< stop time [s], the scene's if absent
    bool expected_unstable = false;      ///< its variant is known to become unstable: no failure
};

struct SuiteOptions {
    std::string tier = "quick";
    std::vector<std::string> scenes;  ///< empty: all that come with the program
    std::filesystem::path directory;
    int jobs = 0;                    ///< runs at a time; 0: one per core
    int threads = 0;                 ///< of each run; 0: the cores shared out among the jobs
    bool fresh = false;              ///< run again what is finished
    bool quiet = false;              ///< no progress, failures only
    std::optional<std::size_t> row;  ///< this row of the plan alone
    double checkpoint_interval = RunOptions{}.checkpoint_interval;  ///< of each run, wall seconds
};

/// Every row of the tier, longest first, and two for each [[sensitivity]] of a scene (low and high, at the
/// middle spacing of the default variant). Throws InputError for an unknown tier or scene.
std::vector<SuiteRow> suite_rows(const SuiteOptions& options);

/// "scene variant dx SPACING", with what is changed behind it: the override, or where there are several the
/// name of the directory.
std::string row_name(const SuiteRow& row);

/// Whether the directory holds this very run, ended; whether it holds a part of it to go on from.
bool finished(const SuiteRow& row);
bool interrupted(const SuiteRow& row);

/// The rows of the tier with their number, cost estimate and whether they are done.
void print_plan(const SuiteOptions& options, bool as_json);

/// Runs the rows that are not finished, interrupted ones from their last checkpoint. A signal to stop is
/// passed on to the runs, and when they have written theirs Interrupted is thrown. Returns the worst exit
/// code of a row (0, 3, or 2 and 4 for failures), where a `paper` variant that becomes unstable has done its
/// work.
int run_suite(const SuiteOptions& options);

/// The same for these rows, started in their order.
int run_rows(const std::vector<SuiteRow>& rows, const SuiteOptions& options);

/// Where rows of the sensitivity study lie: DIR/sensitivity/SCENE/KEY=VALUE
std::filesystem::path sensitivity_path(const std::filesystem::path& directory, const std::string& scene,
                                       const std::string& assignment);

/// DIR/runs/SCENE/VARIANT/dxDX
std::filesystem::path run_path(const std::filesystem::path& directory, const std::string& scene,
                               const std::string& variant, double particle_spacing);

}  // namespace wetdeck
