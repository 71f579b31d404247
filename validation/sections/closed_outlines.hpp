// SPDX-License-Identifier: BSD-3-Clause
// Closed curves to outlines: pieces of no width vanish, lobes that touch in a point part, and curves of
// several components are added to and taken away from each other.
//
// Every curve is cut where it meets another or itself. A cut side stays if the inside lies on one hand of it
// only; sides that stay are joined into loops, at a point where several meet by the sharpest left turn.
#pragma once

#include <optional>
#include <vector>

#include "solver/setup/body_outline.hpp"

namespace wetdeck {

struct ClosedOutlines {
    std::vector<Outline> outlines;  ///< counter-clockwise, simple, from the lowest up
    std::vector<Outline> holes;     ///< clockwise
};

/// Twice enclosed points count once. Corners closer than a millionth of the extent are one corner.
/// @param added, taken_away  closed curves, either way round, that do not cross themselves [m]
ClosedOutlines closed_outlines(const std::vector<Outline>& added,
                               const std::vector<Outline>& taken_away = {});

/// Where a closed curve crosses itself; touching is no crossing.
std::optional<Vec2> self_crossing(const Outline& curve);

/// Positive where counter-clockwise [m^2].
double signed_area(const Outline& curve);

}  // namespace wetdeck
