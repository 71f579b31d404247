// SPDX-License-Identifier: BSD-3-Clause
// What a scene may mean, but what is more often a slip: of a unit, a sign, a place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// One line for each of these: the water's sound speed is below ten times the fastest speed to expect (then
/// it is compressed by more than 1 %), a body starts in the water, a body is more than 30 times heavier or
/// 60 times lighter than the water it would displace.
std::vector<std::string> doubtful(const Scene& scene);

/// A sentence where the scene's fixed time step exceeds the criteria of Eq. (26) at this spacing [m], even
/// for fluid at rest.
std::optional<std::string> doubtful_step(const Scene& scene, double particle_spacing);

}  // namespace wetdeck
