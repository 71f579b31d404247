// SPDX-License-Identifier: BSD-3-Clause
// How `wetdeck run` and `wetdeck resume` run a scene and print how it ended.
#pragma once

#include <filesystem>

#include "validation/commands/options.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// Runs the scene, from the checkpoint in the directory if there is one, and prints the outcome. Returns the
/// exit code.
int run_and_print(const Scene& scene, RunOptions run, const Resources& resources, const Verbosity& verbosity);

/// The same for a run that has finished.
int print_outcome(const RunRecord& record, const std::filesystem::path& directory,
                  const Verbosity& verbosity);

}  // namespace wetdeck
