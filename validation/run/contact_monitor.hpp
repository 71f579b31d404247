// SPDX-License-Identifier: BSD-3-Clause
// Finds bodies that touch the tank or each other. No other check notices it: the solver knows no contact
// unless the scene switches it on, and a body would go on through the floor.
#pragma once

#include "solver/simulation.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Finds a body that touches a face of the tank or another body; to be asked after every step. Where the
/// scene has a law of contact: one that is deeper in them than a spacing. Empty where no body can move.
Simulation::StabilityMonitor contact_monitor(const Scene& scene);

}  // namespace wetdeck
