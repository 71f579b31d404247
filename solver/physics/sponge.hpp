// SPDX-License-Identifier: BSD-3-Clause
// Sponge layer, Yang et al. (2020), Eqs. (24)-(25): within a thickness s of the tank's walls the rates of
// density and velocity are multiplied by
//     1 - 0.9^(50 l/s),
// l the distance to the nearest wall: 0 at the wall, 0.995 where the layer begins. Sound that enters slows
// down and all of it comes back (98 to 99.8 % of a pulse, `wetdeck verify --only sponge_layer`): the layer
// delays and absorbs nothing. The factor 50 is read from a damaged equation. A layer is needed only where
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

/// The factor on the rates at `distance` from the wall, in a layer of `thickness` [m].
inline double sponge_factor(double distance, double thickness) {
    if (distance >= thickness) return 1;
    return 1 - std::pow(0.9, 50 * std::max(0.0, distance) / thickness);
}

}  // namespace wetdeck
