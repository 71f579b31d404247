// SPDX-License-Identifier: BSD-3-Clause
// Meshes of one layer of four-cornered cells, as OpenFOAM stores them.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck {

/// A mesh of the plane, to be drawn out to a layer.
struct PlaneMesh {
    /// A side of a cell on the boundary, with the fluid to its left from a to b.
    struct Side {
        std::size_t a = 0, b = 0, cell = 0;
        std::string patch;
    };
    std::vector<Vec2> points;                       ///< [m]
    std::vector<std::array<std::size_t, 4>> cells;  ///< corners anticlockwise
    std::vector<Side> boundary;

    std::array<Vec2, 4> corners(std::size_t cell) const;
    Vec2 centre(std::size_t cell) const;  ///< of the area
    double area(std::size_t cell) const;
};

/// Rows and columns of cells before they are placed.
struct MeshGrid {
    std::vector<double> u, v;  ///< rising
    /// Where a point of the grid lies [m]; must keep the orientation.
    std::function<Vec2(Vec2)> place = [](Vec2 p) { return p; };
    /// Whether a cell with this centre, on the grid, is left out; none: no cell is.
    std::function<bool(Vec2)> hole;
    /// Name of the patch of a side with this middle, on the grid.
    std::function<std::string(Vec2)> patch;
};
PlaneMesh mesh_of(const MeshGrid& grid);

/// Lines from `begin` to `end`, either way, whose first distance is `first` and grows by the factor `growth`
/// up to `largest`; all are stretched alike so that the last one lies on the end.
std::vector<double> graded_lines(double begin, double end, double first, double growth, double largest);
/// Lines of one distance, as near to `distance` as an even number of cells allows.
std::vector<double> even_lines(double begin, double end, double distance);
/// Two lists of lines that share a point, rising, in one.
std::vector<double> joined_lines(std::vector<double> a, const std::vector<double>& b);

/// Share of each cell's area in the boxes, which must not overlap: exact.
std::vector<double> shares_in(const PlaneMesh& mesh, const std::vector<Box>& boxes);

/// The largest distance of a cell from being a rectangle along the axes or a square in any direction: of the
/// tensor of its sides SUM S S / |S|, the off-diagonal part over the mean of the diagonal ones. 0 for both.
double slant(const PlaneMesh& mesh, std::size_t cell);

/// The files points, faces, owner, neighbour and boundary, by name. Front and back are the patch `sides` of
/// type empty.
/// @param thickness  of the layer, from z = 0 [m]
/// @param types      of the patches, by name: wall, patch, symmetryPlane
std::map<std::string, std::string> poly_mesh_files(const PlaneMesh& mesh, double thickness,
                                                   const std::map<std::string, std::string>& types);

}  // namespace wetdeck
