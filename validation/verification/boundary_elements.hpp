// SPDX-License-Identifier: BSD-3-Clause
// Laplace's equation in a closed region by boundary elements: value and outward slope are even along each
// straight panel (Green's third identity, collocated at the panels' middles).
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck::verification {

/// Runs counterclockwise around the region, which lies to its left.
struct Panel {
    Vec2 from, to;

    Vec2 middle() const { return 0.5 * (from + to); }
    double length() const { return (to - from).norm(); }
    Vec2 normal() const { return Vec2(to.y() - from.y(), from.x() - to.x()) / length(); }  ///< outward
};

/// Appends n equal panels along a straight line.
void append_panels(std::vector<Panel>& panels, Vec2 from, Vec2 to, int n);

/// Everywhere the outward slope, from values on the first `valued` panels and slopes on all others; and the
/// values there. Both are linear in what is given: row k of `unknown` gives the slope of panel k < valued or
/// the value of panel k >= valued, column j takes the value of panel j < valued or the slope of panel j >=
/// valued.
Eigen::MatrixXd mixed_solution(const std::vector<Panel>& panels, Eigen::Index valued);

}  // namespace wetdeck::verification
