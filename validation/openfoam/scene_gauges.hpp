// SPDX-License-Identifier: BSD-3-Clause
// The probes of a case that stand for the gauges of a scene.
#pragma once

#include "validation/openfoam/scene_case.hpp"

namespace wetdeck {

/// Adds the probes of pressure gauges, of pressures along faces, of gaps under faces, of the free surface, of
/// the front and of the depths of water; what is left out becomes a difference, with the reason. Of a half
/// domain, gauges on the left are read on the right.
/// @param axis  of symmetry of a half domain [m]
void add_gauges(const Scene& scene, std::optional<double> axis, SceneCase& written);

}  // namespace wetdeck
