// SPDX-License-Identifier: BSD-3-Clause
// What makes the flow of a run doubtful, whatever its quantities say.
#pragma once

#include <string>
#include <vector>

#include "validation/store/run_record.hpp"

namespace wetdeck {

/// A weakly compressible flow is compressed by about a per cent; beyond this largest |rho/rho0 - 1| the sound
/// speed is too low for the speeds, or the spacing too coarse for the impacts.
inline constexpr double largest_sound_density_error = 0.05;

/// One sentence each where the largest density error of the water is above largest_sound_density_error, and
/// where fluid particles are beyond the faces of the tank.
std::vector<std::string> flow_flags(const RunRecord& record);

}  // namespace wetdeck
