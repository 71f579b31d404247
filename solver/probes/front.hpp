// SPDX-License-Identifier: BSD-3-Clause
// Where the water is: leading edge, depth, surface, and the gap under a body.
#pragma once

#include <vector>

#include "solver/simulation.hpp"

namespace wetdeck {

/// Largest x that water reaches [m]: the outermost particle's centre and half its width.
double front_position(const Simulation& simulation);

/// Depth of water at x [m]: volume of the water within a strip of `width` about x, over the width. Voids do
/// not count.
double water_depth(const Simulation& simulation, double x, double width);

/// Height of the highest water in each of `count` columns of equal width between `low` and `high` [m]; spray
/// counts. The bottom of the tank where a column has no water.
std::vector<double> water_top(const Simulation& simulation, double low, double high, std::size_t count);

/// Gap between a straight face of a body and the nearest water in front of it [m], zero where they touch.
/// Ends of the face in the body's frame, with the fluid on the right as one goes from `from` to `to`. The
/// tank's diagonal, less half a spacing, where no water is in front.
double gap_to_water(const Simulation& simulation, std::size_t body, Vec2 from, Vec2 to);

}  // namespace wetdeck
