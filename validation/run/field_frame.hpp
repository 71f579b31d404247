// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation as a field frame.
#pragma once

#include <string>

#include "solver/simulation.hpp"
#include "validation/store/fields.hpp"

namespace wetdeck {

/// Fluid and walls; pressures without the background.
FieldFrame frame_of(const Simulation& simulation, const std::string& provenance);

}  // namespace wetdeck
