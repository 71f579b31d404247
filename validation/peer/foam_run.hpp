// SPDX-License-Identifier: BSD-3-Clause
// Running cases of OpenFOAM where it is installed.
#pragma once

#include <filesystem>
#include <string>

#include "validation/openfoam/scene_case.hpp"

namespace wetdeck {

/// Throws EnvironmentError with what to install where the solver is not on the PATH.
void check_solver(const std::string& solver);

/// Whether the folder holds the finished run of this very case.
bool is_finished(const std::filesystem::path& folder, const SceneCase& written);

/// Writes the case and runs it to its end, with progress on stderr.
/// @param limit  wall time [s]
/// Throws EnvironmentError where the solver fails, with the last line of its log, and where the limit is
/// over.
void run_case(const std::filesystem::path& folder, const Scene& scene, const SceneCase& written,
              double limit);

/// The last time that a log of OpenFOAM names [s], 0 for none.
double last_time_in(const std::string& log);

/// Whether the installed interFoam computes slanted cells rightly: twenty steps on a sheared mesh must give
/// one largest speed whatever the thickness of the layer. Some builds compute the product of a tensor and a
/// vector in place, which spoils velocities on cells that are neither along the axes nor locally square.
/// @param folder  for the two small cases; it is made and removed
bool slanted_cells_are_sound(const std::filesystem::path& folder);

/// Throws EnvironmentError that names the fault, and what to install instead, where a mesh has slanted cells
/// and the build computes them wrongly.
void check_cells(const SceneCase& written, bool slanted_are_sound);

}  // namespace wetdeck
