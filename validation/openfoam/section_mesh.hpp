// SPDX-License-Identifier: BSD-3-Clause
// The mesh of any section in a tank, made by the program gmsh: cells with four corners that follow the
// section.
#pragma once

#include <string>
#include <vector>

#include "solver/core/vec2.hpp"
#include "validation/openfoam/plane_mesh.hpp"

namespace wetdeck {

/// A section in a stream from below. Patches `body`, `inflow` (floor), `walls` (sides), `atmosphere` (roof).
struct SectionShape {
    Box tank;                   ///< [m]
    std::vector<Vec2> outline;  ///< inside the tank, either way round [m]
    Box fine;                   ///< where cells have the wanted size [m]
    double cell;                ///< there, and along the section [m]
};

/// The corners between which the mesh follows an outline: corners at which it turns by 10 degrees or more,
/// and of curves that are drawn with shorter sides, corners one and a half cells apart or a little more.
std::vector<Vec2> meshed_corners(const std::vector<Vec2>& outline, double cell);

/// The input of gmsh: the tank without the section, its sides named after their patches.
std::string section_geometry(const SectionShape& shape);

/// A mesh file of gmsh (version 2.2, text) of one surface whose sides are named. Throws DataError where the
/// mesh is not what a case needs: triangles, cells that are not convex, sides without a name, or a patch that
/// is missing.
/// @param patches  that must be there
PlaneMesh mesh_of_gmsh(const std::string& text, const std::vector<std::string>& patches);

/// Runs gmsh on the geometry. Throws EnvironmentError where it is not installed or fails, and what
/// mesh_of_gmsh throws.
PlaneMesh section_mesh(const SectionShape& shape);

}  // namespace wetdeck
