// SPDX-License-Identifier: BSD-3-Clause
// Fluid that has got into a body. It would stay there unnoticed: every step by itself is in order.
#pragma once

#include "solver/simulation.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Finds a fluid particle deeper inside a body of the scene than one spacing, behind two rows of the body's
/// own particles. Nothing to do where the scene has no bodies.
Simulation::StabilityMonitor watch_bodies(const Scene& scene);

}  // namespace wetdeck
