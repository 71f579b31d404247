// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>

namespace wetdeck {

/// A point or vector of the plane, y up.
using Vec2 = Eigen::Vector2d;

/// Axis-parallel rectangle [m].
struct Box {
    Vec2 low = Vec2::Zero();   ///< lower left corner
    Vec2 high = Vec2::Zero();  ///< upper right corner
};

/// A box that holds nothing yet: its corners are exchanged.
inline Box empty_box() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {Vec2::Constant(infinity), Vec2::Constant(-infinity)};
}

/// Widens a box to hold a point.
inline void extend(Box& box, Vec2 point) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
}

}  // namespace wetdeck
