// SPDX-License-Identifier: BSD-3-Clause
// One run of a scene: from its file to run.h5 and the fields beside it.
#pragma once

#include <filesystem>
#include <optional>

#include "validation/execute/progress.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

struct RunOptions {
    std::filesystem::path directory;
    double particle_spacing = 0;  ///< [m]
    std::optional<double> until;  ///< stop time [s], the scene's if absent
    int threads = 0;              ///< 0: all
    bool replace = false;         ///< replace another run that the directory holds
};

/// Runs and stores. A run that becomes unstable is stored too, with status and reason, its series and its
/// last good fields. Throws InputError (bad scene, spacing, directory in use) and EnvironmentError (disk
/// full, no permission).
RunRecord run_scene(const Scene& scene, const RunOptions& options, Progress& progress);

/// What identifies the run that these options ask for.
std::string identity_of(const Scene& scene, const RunOptions& options);

}  // namespace wetdeck
