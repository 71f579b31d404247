// SPDX-License-Identifier: BSD-3-Clause
// Sponge layer, Yang et al. (2020), Eqs. (24)-(25): within a thickness s of the tank's walls the rates of
// density and velocity are multiplied by
//     1 - 0.9^(50 l/s)  (exponential)  or  100^(-0.9^(50 l/s))  (larsen_dancy),
// l the distance to the nearest wall: 0 or 0.01 at the wall, 0.995 or 0.976 where the layer begins. The
// equation is damaged in print: the second form, that of Larsen and Dancy (1983), has a place for its number
// 100. With the first, sound that enters slows down and all of it comes back (98 to 99.8 % of a pulse,
// `wetdeck verify --only sponge_layer`): the layer delays and absorbs nothing. A layer is needed only where
// sound can return within the time simulated; a slightly larger tank does the same without changing the
// equations.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/core/vec2.hpp"

namespace wetdeck {

/// Distance of a point inside a box from its nearest side [m]; negative outside.
inline double distance_to_wall(Box box, double x, double y) {
    return std::min(std::min(x - box.low.x(), box.high.x() - x), std::min(y - box.low.y(), box.high.y() - y));
}

/// The readings of the ramp.
enum class SpongeRamp { exponential, larsen_dancy };

/// The factor on the rates at `distance` from the wall, in a layer of `thickness` [m].
inline double sponge_factor(double distance, double thickness, SpongeRamp ramp = SpongeRamp::exponential) {
    if (distance >= thickness) return 1;
    const double decay = std::pow(0.9, 50 * std::max(0.0, distance) / thickness);
    return ramp == SpongeRamp::exponential ? 1 - decay : std::pow(100, -decay);
}

}  // namespace wetdeck
