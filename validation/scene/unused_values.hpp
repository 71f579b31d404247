// SPDX-License-Identifier: BSD-3-Clause
// Values that a scene file gives and that nothing in the scene reads: mostly a switch is missing.
#pragma once

#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// One line for each value of the scene's own text that neither its variant nor another one uses: a viscosity
/// without the viscous force, a table [air] without air, loads of a body that cannot move, and their like.
/// Values that come from a scheme do not count. A viscosity that another variant uses counts where it is
/// large: Re = c H / nu below 10^4, with the height H of the water.
std::vector<std::string> unused_values(const Scene& scene);

}  // namespace wetdeck
