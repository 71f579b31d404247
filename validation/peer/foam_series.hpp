// SPDX-License-Identifier: BSD-3-Clause
// The series of a scene, read from a finished case of OpenFOAM.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "validation/openfoam/scene_case.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// A record of a run with the series that the case has: force on the body, its motion, the gauges. Steps in
/// which a gauge reads nothing are left out. Throws DataError for files that are damaged.
RunRecord foam_record(const Scene& scene, const SceneCase& written, const std::filesystem::path& folder);

/// A gauge from the columns of its probes at one time, in their order: one value, or one for each place of
/// its abscissa [SI, in the frame of the scene]. NaN where it reads nothing. Throws DataError where the
/// number of probes is not that of the case.
std::vector<double> gauge_values(const FoamGauge& gauge, const std::vector<double>& probes, double time);

}  // namespace wetdeck
