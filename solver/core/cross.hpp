// SPDX-License-Identifier: BSD-3-Clause
// Cross product of vectors in the plane.
#pragma once

#include "solver/core/vec2.hpp"

namespace wetdeck {

/// The component out of the plane, positive where b lies to the left of a.
inline double cross(Vec2 a, Vec2 b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace wetdeck
