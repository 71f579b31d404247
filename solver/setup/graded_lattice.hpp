// SPDX-License-Identifier: BSD-3-Clause
// Particles that are finest in a box and grow away from it: a lattice of equal squares in the box, and around
// it rings of cells, each one cell thick, whose thickness grows by a share of itself from ring to ring up to
// a largest one. A ring is divided along itself into cells as long as it is thick. Rows follow the box, the
// level and the faces of the tank, every cell keeps its own area, and the cells of a region fill it exactly.
#pragma once

#include <vector>

#include "solver/core/domain_ends.hpp"
#include "solver/core/vec2.hpp"
#include "solver/particles/fluid.hpp"
#include "solver/particles/walls.hpp"

namespace wetdeck {

/// Beyond these a neighbourhood holds too different particles, or the step of the finest is a waste.
inline constexpr double largest_growth = 0.2, largest_coarsest = 16;

/// Where particles are finest, and how their spacing grows.
struct Grading {
    Box around;           ///< holds the finest; it may reach beyond the fluid [m]
    double finest = 0;    ///< spacing [m]
    double growth = 0;    ///< of the spacing from one cell to the next, away from the box [-]
    double coarsest = 1;  ///< largest spacing over the finest [-]

    /// Spacing at a place [m], from its larger distance along x or y from the box.
    double spacing_at(Vec2 place) const;
};

/// The cells of a region of fluid, those of the finest first. A side of the box within three spacings of a
/// side of the region moves there. Throws InputError where the box fills the region along an axis and the
/// finest spacing does not fit its side.
std::vector<Box> graded_cells(Box region, const Grading& grading);

/// Fineness of a particle of this volume [m^2]: at most 1.
double fineness_of(double volume, double finest);

/// Largest spacing over the finest, of particles with finenesses.
double coarsest_over_finest(const FluidParticles& fluid, const WallParticles& walls);

/// A particle at rest in the middle of each cell, of its mass.
void fill_cells(FluidParticles& fluid, Phase phase, const std::vector<Box>& cells, double finest,
                double density);

/// Layers of dummy particles behind the faces of a tank, each a mirror image of the cells at its face, as
/// many as the kernel's support needs.
/// @param cells   that fill the tank, whatever is in them
/// @param layers  see boundary_layers
/// @param ends    walls, or a plane of symmetry at the left, beyond which bed and lid run on
WallParticles graded_tank_walls(Box tank, const std::vector<Box>& cells, double finest, int layers,
                                DomainEnds ends = DomainEnds::walls);

}  // namespace wetdeck
