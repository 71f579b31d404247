// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation as a field frame.
#pragma once

#include <string>

#include "solver/simulation.hpp"
#include "validation/store/fields.hpp"

namespace wetdeck {

/// Fluid and walls in the order of their ids, 0 to N-1, in every frame; pressures without the background.
FieldFrame frame_of(const Simulation& simulation, const std::string& provenance);

}  // namespace wetdeck
