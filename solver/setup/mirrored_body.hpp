// SPDX-License-Identifier: BSD-3-Clause
// Boundary particles of a body that is symmetric about the axis x = 0 of its frame.
#pragma once

#include <cmath>
#include <vector>

#include "solver/particles/walls.hpp"

namespace wetdeck {

/// Makes the particles of bodies from number `first` on symmetric: those at x < 0 are replaced by mirror
/// images of the others, and those closer to the axis than `tolerance` [m] lie on it.
inline void mirror_body_points(WallParticles& walls, std::size_t first, double tolerance) {
    const std::vector<BodyPoint> points(walls.body_point.begin() + static_cast<std::ptrdiff_t>(first),
                                        walls.body_point.end());
    for_each_field(walls, [first](const auto&, auto& values) { values.resize(first); });
    for (const BodyPoint& p : points) {
        if (std::abs(p.x) <= tolerance) {
            walls.add_body_point(p.body, {0, p.y}, {0, p.ny});
        } else if (p.x > 0) {
            walls.add_body_point(p.body, {p.x, p.y}, {p.nx, p.ny});
            walls.add_body_point(p.body, {-p.x, p.y}, {-p.nx, p.ny});
        }
    }
}

}  // namespace wetdeck
