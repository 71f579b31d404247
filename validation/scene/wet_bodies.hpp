// SPDX-License-Identifier: BSD-3-Clause
// Bodies that start in the water.
#pragma once

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Whether a body of the scene shares a point with the water at the start.
bool starts_in_water(const Scene& scene, const BodySpec& body);

}  // namespace wetdeck
