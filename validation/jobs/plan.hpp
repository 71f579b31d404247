// SPDX-License-Identifier: BSD-3-Clause
// The plan of a suite: which runs a tier consists of (scene x variant x spacing, and the inputs of the
// studies of one input), where each is stored, and which are done.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "validation/run/run.hpp"

namespace wetdeck {

struct SuiteRow {
    std::string scene;  ///< name or path
    std::string variant;
    double particle_spacing = 0;
    double estimated_core_seconds = 0;
    std::vector<std::string> overrides;        ///< one KEY=VALUE for a row of a study of one input
    std::filesystem::path directory;           ///< of the run
    std::optional<double> until = {};          ///< stop time [s], the scene's if absent
    bool expected_unstable = false;            ///< its variant is known to become unstable: no failure
    bool pictured = false;                     ///< whether a report may show pictures of its fields
    double fluid_particles = 0;                ///< estimated
    std::size_t frames = 0, shown_frames = 0;  ///< field files of all fields, and those that a report shows
    std::string label = {};                    ///< in messages, in place of the overrides
};

struct PlanOptions {
    std::string tier = "quick";
    std::vector<std::string> scenes;  ///< empty: all that come with the program
    std::filesystem::path directory;
    std::optional<int> replicates = {};  ///< of each variant that a scene names; empty: as the scene says
};

/// How each row is run.
struct RowOptions {
    int threads = 0;                                                ///< 0: left to the executor
    bool fresh = false;                                             ///< repeat finished runs
    double checkpoint_interval = RunOptions{}.checkpoint_interval;  ///< wall seconds
    Fields fields = Fields::all;                                    ///< of runs that belong to no study
};

/// Which fields a run of the row writes: the report shows none of studies, and of other rows only some.
Fields fields_of(const SuiteRow& row, const RowOptions& options);

/// Estimated size of the results of a row [bytes].
double estimated_bytes(const SuiteRow& row, const RowOptions& options);

/// Every row of the tier, longest first, and at the coarsest spacing of the variant two for each
/// [[sensitivity]] of a scene (low and high, default variant), two for each variant whose sound speed it
/// studies (a half and twice), and the replicates of each variant that it names. Throws InputError for an
/// unknown tier or scene, and without a run.
std::vector<SuiteRow> suite_rows(const PlanOptions& options);

/// "scene variant dx SPACING", followed by the override or, where there are several, by the name of the
/// directory.
std::string row_name(const SuiteRow& row);

/// Whether the directory holds this very run, finished.
bool finished(const SuiteRow& row);
/// Whether it holds a checkpoint of this very run.
bool interrupted(const SuiteRow& row);

/// Estimated core seconds of all rows.
double estimated_core_seconds(const std::vector<SuiteRow>& rows);

/// Folders of the studies of one input: DIR/sensitivity/SCENE/KEY=VALUE,
/// DIR/sound_speed/SCENE/VARIANT/KEY=VALUE and DIR/replicates/SCENE/VARIANT/KEY=VALUE.
inline constexpr const char* sensitivity_folder = "sensitivity";
inline constexpr const char* sound_speed_folder = "sound_speed";
inline constexpr const char* replicates_folder = "replicates";

/// DIR/runs/SCENE/VARIANT/dxDX
std::filesystem::path run_path(const std::filesystem::path& directory, const std::string& scene,
                               const std::string& variant, double particle_spacing);

}  // namespace wetdeck
