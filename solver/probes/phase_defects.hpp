// SPDX-License-Identifier: BSD-3-Clause
// Defects of a two-phase flow that its curves do not show, as numbers: voids, phases that mix where they
// should not, fluid inside bodies.
#pragma once

#include <cstddef>
#include <span>

#include "solver/setup/body_outline.hpp"
#include "solver/simulation.hpp"

namespace wetdeck {

/// Area of the tank [m^2], bodies left out, that is farther than one spacing from every particle, to a
/// quarter of a spacing; on an undisturbed lattice the farthest point is 0.71 spacings away. Without air it
/// is the area of the tank that holds no water.
/// @param outlines  of the bodies, in their frames about the mass centre [m]
double void_area(const Simulation& simulation, std::span<const Outline> outlines);

/// Particles of each phase of whose neighbours within two spacings less than a quarter are of their own
/// phase: drops and bubbles of single particles, and films one particle thick. At a plane interface it is a
/// half.
struct MixedParticles {
    std::size_t water_in_air = 0;  ///< water particles
    std::size_t air_in_water = 0;  ///< air particles
};
/// Of all fluid, from the neighbour list.
MixedParticles mixed_particles(const Simulation& simulation);

/// Largest spacing of the fluid that touches a body, nearer than one and a half of the mean of both spacings,
/// over the finest.
double coarsest_at_bodies(const Simulation& simulation);

/// Volume of the air [m^2 a metre of span] that is cut off from the largest body of air: cavities and
/// bubbles. Air particles closer than 1.5 spacings belong together.
double enclosed_air(const Simulation& simulation);

/// Fluid particles whose centres lie inside a body. Boundary particles keep them half a spacing outside.
/// @param outlines  of the bodies, in their frames about the mass centre [m]
std::size_t particles_in_bodies(const Simulation& simulation, std::span<const Outline> outlines);

}  // namespace wetdeck
