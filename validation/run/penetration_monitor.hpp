// SPDX-License-Identifier: BSD-3-Clause
// Finds fluid that has penetrated a body. No other check notices it: every step by itself is in order.
#pragma once

#include "solver/simulation.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Finds a fluid particle deeper inside a body of the scene than one spacing, behind two rows of the body's
/// own particles. Empty where the scene has no bodies.
Simulation::StabilityMonitor penetration_monitor(const Scene& scene);

}  // namespace wetdeck
