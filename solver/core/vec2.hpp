// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace wetdeck {

/// A point or vector of the plane, y up.
using Vec2 = Eigen::Vector2d;

/// Axis-parallel rectangle [m].
struct Box {
    Vec2 low = Vec2::Zero();   ///< lower left corner
    Vec2 high = Vec2::Zero();  ///< upper right corner
};

}  // namespace wetdeck
