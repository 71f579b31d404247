// SPDX-License-Identifier: BSD-3-Clause
// The set-up of a scene as a drawing.
#pragma once

#include <string>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// SVG drawn from the scene at its start: tank, fluids, bodies with their mass centres and velocities,
/// numbered probes with a key, and the main dimensions.
std::string sketch_svg(const Scene& scene);

}  // namespace wetdeck
