// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace wetdeck {

using Vec2 = Eigen::Vector2d;

/// Axis-parallel rectangle [m].
struct Box {
    Vec2 low = Vec2::Zero();
    Vec2 high = Vec2::Zero();
};

}  // namespace wetdeck
