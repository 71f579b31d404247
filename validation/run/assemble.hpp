// SPDX-License-Identifier: BSD-3-Clause
// From a scene and a spacing to particles and walls.
#pragma once

#include <string>

#include "solver/simulation.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// The simulation of a scene, ready to run. Throws InputError for a spacing that does not fit.
Simulation assemble(const Scene& scene, double particle_spacing, int threads);

/// Throws InputError if the spacing does not fit the scene or its probes; nothing is run.
void check_spacing(const Scene& scene, double particle_spacing);

/// The same for a spacing of one of the scene's tiers; the error names file, variant and tier.
void check_row(const Scene& scene, const std::string& tier, double particle_spacing);

}  // namespace wetdeck
