// SPDX-License-Identifier: BSD-3-Clause
// One run of a scene: from its file to run.h5 and the fields beside it.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "validation/run/progress.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// Which field files a run writes: none, those that the report shows (scene/shown_frames.hpp), or all.
enum class Fields { none, key, all };
inline constexpr std::array fields_names{"none", "key", "all"};
inline const char* name_of(Fields fields) {
    return fields_names[static_cast<std::size_t>(fields)];
}

struct RunOptions {
    std::filesystem::path directory;
    double particle_spacing = 0;      ///< [m]
    std::optional<double> until;      ///< stop time [s], the scene's if absent
    int threads = 0;                  ///< 0: all
    Fields fields = Fields::all;      ///< no part of the run's identity
    bool replace = false;             ///< replace another run that the directory holds
    double checkpoint_interval = 10;  ///< wall seconds; further apart where that would cost more than 1 %
};

/// Runs and stores. A run that becomes unstable is stored too, with status and reason, its series and its
/// last good fields. Where the directory holds a checkpoint of the same run it continues from there and ends
/// with the same bits. A run that reaches its end and writes all fields keeps the checkpoint before its last
/// step, from which it can go on to a later end. Throws InputError (bad scene, spacing, directory in use),
/// EnvironmentError (disk full, no permission) and, when a signal came and its checkpoint is written,
/// Interrupted.
RunRecord run_scene(const Scene& scene, const RunOptions& options, Progress& progress);

/// The scene and options of the run in a directory that its checkpoint can continue. With `until` [s] the run
/// is asked for anew, to that end: a run.h5 of a shorter one is removed. Throws DataError where the directory
/// holds no checkpoint that can be read, InputError for an end before the checkpoint.
std::pair<Scene, RunOptions> interrupted_run(const std::filesystem::path& directory,
                                             std::optional<double> until = std::nullopt);

/// What identifies the run that these options ask for.
std::string identity_of(const Scene& scene, const RunOptions& options);

}  // namespace wetdeck
