// SPDX-License-Identifier: BSD-3-Clause
// Separate lines and arcs of a drawing, joined where the ends of two meet.
#pragma once

#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck {

struct PlaneCurve {
    std::vector<Vec2> points;  ///< [m]
    bool closed = false;
    std::vector<std::size_t> pieces;  ///< numbers of the curves that it was joined of
};

struct JoinedCurves {
    std::vector<PlaneCurve> curves;
    double widest_gap = 0;  ///< that was closed [m]
};

/// Joins ends that are at most `room` [m] apart. Where three or more ends meet, as half sections do at the
/// keel, none is joined; nor are two pieces at x = 0 of which one lies to the left and the other to the right
/// unless they are as wide and as high: they may be two stations of a body plan.
JoinedCurves joined(const std::vector<PlaneCurve>& pieces, double room);

}  // namespace wetdeck
