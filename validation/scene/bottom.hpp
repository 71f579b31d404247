// SPDX-License-Identifier: BSD-3-Clause
// The bottom of a section: its sides that face down, as slamming sees them.
#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "solver/setup/body_outline.hpp"

namespace wetdeck {

/// A side that faces down, or several that follow each other up or down where each is short.
struct BottomSide {
    double deadrise;       ///< of the line from its one end to its other [rad]
    double share_of_beam;  ///< of its horizontal length
    double top;            ///< height of its upper end [m]
};

/// Flatter sides meet the water at once; steeper ones are sides of the hull [rad].
inline constexpr double flattest_deadrise_of_wedge = 4 * std::numbers::pi / 180;
inline constexpr double steepest_deadrise_of_wedge = 85 * std::numbers::pi / 180;

/// The share of the beam from which a side counts.
inline constexpr double least_share_of_beam = 0.05;

/// In the order of the corners. Sides of less than the least share that follow each other and rise, or sink,
/// together are one: a curve that is drawn with short sides has the slopes of its pieces.
std::vector<BottomSide> bottom_sides(const Outline& outline);

/// The least deadrise of the sides that count, flat ones aside [rad].
std::optional<double> flattest_deadrise(const Outline& outline);

/// Whether a side that counts is flatter than that.
bool has_flat_bottom(const Outline& outline);

}  // namespace wetdeck
