// SPDX-License-Identifier: BSD-3-Clause
// Where the water is: leading edge and depth.
#pragma once

#include "solver/simulation.hpp"

namespace wetdeck {

/// Largest x that water reaches [m]: the outermost particle's centre and half its width.
double front_position(const Simulation& simulation);

/// Depth of water at x [m]: volume of the water within a strip of `width` about x, over the width. Voids do
/// not count.
double water_depth(const Simulation& simulation, double x, double width);

}  // namespace wetdeck
