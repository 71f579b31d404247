// SPDX-License-Identifier: BSD-3-Clause
// Arcs and splines as chords. A chord leaves its curve by at most the tolerance.
#pragma once

#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck {

/// The shorter arc between two points, its centre to the left of the way from a to b for a positive radius,
/// to the right for a negative one.
/// @return the points between a and b, without both
/// Throws InputError where the points are further apart than the diameter (by more than 0.1 %).
std::vector<Vec2> arc_by_radius(Vec2 a, Vec2 b, double radius, double tolerance);

/// The arc whose bulge, the tangent of a quarter of its angle, is positive where it turns to the left (DXF
/// group 42).
std::vector<Vec2> arc_by_bulge(Vec2 a, Vec2 b, double bulge, double tolerance);

/// From one angle on, counter-clockwise by `turn` [rad]; both ends are among the points.
std::vector<Vec2> arc_by_angles(Vec2 centre, double radius, double begin, double turn, double tolerance);

/// A B-spline, rational where there are weights (Piegl and Tiller 1997, The NURBS Book, Algorithm A3.1 and
/// A4.1; evaluated by de Boor's recursion).
struct Spline {
    std::size_t degree = 3;
    std::vector<double> knots, weights;
    std::vector<Vec2> control;
};

/// The point at a parameter between the knots number `degree` and number of control points.
Vec2 point_on(const Spline& spline, double parameter);

/// Both ends are among the points. Throws InputError where numbers of knots, weights and control points do
/// not fit, and where knots fall.
std::vector<Vec2> chords_of(const Spline& spline, double tolerance);

}  // namespace wetdeck
