// SPDX-License-Identifier: BSD-3-Clause
// Particles on a lattice: boxes of fluid, and dummy-particle walls around a tank.
#pragma once

#include "solver/core/domain_ends.hpp"
#include "solver/core/vec2.hpp"
#include "solver/particles/fluid.hpp"
#include "solver/particles/walls.hpp"

namespace wetdeck {

/// Fills `region` with particles of `phase` at rest, on a lattice that fits it: the spacing of each axis is
/// the side over a whole number, and masses are exact. Throws InputError where that differs from
/// `particle_spacing` by more than 2 %.
void fill_box(FluidParticles& fluid, Phase phase, Box region, double particle_spacing, double density);

/// Whether fill_box takes this spacing for a side of `length` [m].
bool spacing_fits(double length, double particle_spacing);

/// Layers of boundary particles that the kernel's support needs.
int boundary_layers(double support_radius, double particle_spacing);

/// Layers of dummy particles around the inside of `tank`, as many as the kernel's support needs, the first
/// half a spacing behind the face. Corner particles have the normal towards the corner. Where an end
/// is open, at the left of a plane of symmetry or at both of a periodic tank, bed and lid run on beyond it by
/// as many particles.
WallParticles tank_walls(Box tank, double particle_spacing, double support_radius,
                         DomainEnds ends = DomainEnds::walls);

}  // namespace wetdeck
