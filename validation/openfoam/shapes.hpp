// SPDX-License-Identifier: BSD-3-Clause
// The three meshes that scenes are written on: cells along the axes or locally square, which every build of
// OpenFOAM computes rightly.
#pragma once

#include "solver/core/vec2.hpp"
#include "validation/openfoam/plane_mesh.hpp"

namespace wetdeck {

/// A closed tank, patch `walls`.
PlaneMesh tank_mesh(const Box& tank, double cell);

/// The right half of a rectangle in a stream from below. Cells below its flat bottom are a tenth as high as
/// wide. Patches `body`, `symmetry`, `inflow` (below), `walls` (right), `atmosphere` (above).
struct PlateShape {
    Box tank;     ///< symmetric about the plate's middle [m]
    Box plate;    ///< [m]
    double cell;  ///< beside and below the plate, along it [m]
};
PlaneMesh plate_mesh(const PlateShape& shape);
/// Height of the cells under a plate [m].
double film_cell(double cell);

/// The right half of a wedge whose side goes on to the far boundary: the map z = w^((90 + b)/90) of squares,
/// turned so that the axis points down. Patches `body`, `symmetry`, `inflow` (below), `far` (beside, up to a
/// height), `atmosphere` (above it).
struct WedgeShape {
    Vec2 keel;             ///< [m]
    double deadrise;       ///< b [rad]
    double side;           ///< length of the wetted side, where cells have the wanted size [m]
    double radius;         ///< from the keel to the far boundary, along the axis and the side [m]
    double outflow_above;  ///< height above the keel from which the far boundary is open [m]
    double cell;           ///< [m]
};
PlaneMesh wedge_mesh(const WedgeShape& shape);

}  // namespace wetdeck
