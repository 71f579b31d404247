// SPDX-License-Identifier: BSD-3-Clause
// Wetting of a wall by water without air: what is between them before they touch is nothing, and must not
// press. The continuity equation counts a wall as soon as it comes within the kernel's support. Its share is
// therefore the wetness of the boundary particles near,
//     w <- max(w, clamp((c - 0.94) / 0.06, 0, 1)),   w <- 0 where c < 1/2,
// with the cover c = SUM_f V_f W_wf / (1 - SUM_w' V W_ww'), the part of a boundary particle's support in
// front of it that the water fills. A dry wall is wetted when the gap has closed; it stays wet, whatever the
// disorder of the particles, until half of the water has left. At the start, half of it is enough.
#pragma once

#include <algorithm>

#include "solver/physics/model.hpp"

namespace wetdeck {

/// Whether the walls of a run are wetted: with air there is no gap, and at the ends of a periodic domain the
/// kernel sums of walls are not whole.
inline bool wets_walls(const Model& model, bool two_phase) {
    return model.wall_wetting && !two_phase && !model.periodic_x;
}

/// Cover of a boundary particle from the kernel sums over the water in front of it and over the walls of the
/// same body; a particle deep inside a body, whose support is full of walls, has none.
inline double covered_share(double water_sum, double wall_sum) {
    constexpr double least_room = 0.01;
    return water_sum / std::max(1 - wall_sum, least_room);
}

/// The wetness after a step.
inline double next_wetness(double wetness, double cover) {
    constexpr double dry_below = 0.5, wetted_from = 0.94;
    if (cover < dry_below) return 0;
    return std::max(wetness, std::clamp((cover - wetted_from) / (1 - wetted_from), 0.0, 1.0));
}

}  // namespace wetdeck
