// SPDX-License-Identifier: BSD-3-Clause
// What makes the flow of a run doubtful, whatever its quantities say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/store/run_record.hpp"

namespace wetdeck {

/// A weakly compressible flow is compressed by about a per cent; beyond this largest |rho/rho0 - 1| the sound
/// speed is too low for the speeds, or the spacing too coarse for the impacts.
inline constexpr double largest_sound_density_error = 0.05;

/// Spacing of the fluid at a body, over the finest, beyond which it is not that of the run.
inline constexpr double largest_spacing_at_bodies = 1.5;

/// One sentence each where the largest density error of the water is above largest_sound_density_error, where
/// fluid particles are beyond the faces of the tank, and where a body has met particles coarser than
/// largest_spacing_at_bodies.
std::vector<std::string> flow_flags(const RunRecord& record);

/// Change of density that a water of the chosen sound speed may have: pressures of impacts are then those of
/// nearly incompressible water. Beyond it peaks depend on the sound speed.
inline constexpr double largest_intended_compression = 0.01;

/// Where the water's density changes by more than that: by how much, and the sound speed that would keep it
/// below. Of a pressure p, the change is p / (rho c^2); the pressure of flow and weight does not depend on c,
/// that of a flat impact, rho c V, rises with it. Empty for a run without that change.
std::optional<std::string> compression_note(const RunRecord& record);

}  // namespace wetdeck
