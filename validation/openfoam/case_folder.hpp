// SPDX-License-Identifier: BSD-3-Clause
// The folder of a case.
#pragma once

#include <filesystem>
#include <string>

#include "validation/openfoam/scene_case.hpp"

namespace wetdeck {

/// Writes all files of the case, run.sh (which may be run) and DIFFERENCES.md. Throws InputError where the
/// folder holds something, unless it may be replaced, and EnvironmentError where the machine refuses.
void write_case(const std::filesystem::path& folder, const Scene& scene, const SceneCase& written,
                bool replace);

/// Of all files of the case: two cases of one hash give the same results.
std::string case_hash(const SceneCase& written);

}  // namespace wetdeck
