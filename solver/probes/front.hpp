// SPDX-License-Identifier: BSD-3-Clause
// Where the water is: leading edge, depth, surface, and the gap under a body.
#pragma once

#include <span>
#include <vector>

#include "solver/simulation.hpp"

namespace wetdeck {

/// Which water makes a front, and to which side it runs.
struct FrontProbe {
    int axis = 0;         ///< 0: along x, 1: along y
    bool forward = true;  ///< to the larger coordinate
    Box range;            ///< water whose centre lies in it counts [m]
};

/// Coordinate of the farthest water in the direction of the probe [m]: the outermost particle's centre and
/// half its width, up to the far side of the range; the near side where the range holds no water.
double front_position(const Simulation& simulation, const FrontProbe& probe);

/// The largest x of all water [m].
double front_position(const Simulation& simulation);

/// Depth of water at x [m]: volume of the water within a strip of `width` about x, over the width of its part
/// in the tank. Voids do not count.
double water_depth(const Simulation& simulation, double x, double width);

/// Height of the highest water within three quarters of a spacing of the middle of each of `count` columns of
/// equal width between `low` and `high` [m]; spray counts. The bottom of the tank where a column has no
/// water.
std::vector<double> water_top(const Simulation& simulation, double low, double high, std::size_t count);

/// Gap between a straight face of a body and the nearest water in front of it [m], zero where they touch.
/// Ends of the face in the body's frame, with the fluid on the right as one goes from `from` to `to`. The
/// tank's diagonal, less half a spacing, where no water is in front.
double gap_to_water(const Simulation& simulation, std::size_t body, Vec2 from, Vec2 to);

/// Distance from a closed polygon to the nearest water, less half a spacing, zero where they touch [m]; the
/// tank's diagonal, less half a spacing, where there is no water.
double gap_around(const Simulation& simulation, std::span<const Vec2> corners);

}  // namespace wetdeck
