// SPDX-License-Identifier: BSD-3-Clause
// Fluid around bodies whose faces do not fit the lattice.
//
// A lattice of whole particles leaves gaps beside a face that is slanted or lies between its rows. Water that
// starts under pressure runs into them, and until they are filled, some tens of milliseconds later, the
// pressure on the body is a small part of the right one. So each particle takes what the bodies leave of its
// square cell: its mass follows from that area, and it moves to the centroid. A cell that keeps less than
// half joins the nearest one that keeps more, or none where a slit is too narrow for any. The volume of the
// fluid is then exact, cell by cell, and a lattice that fits stays as it is.
#pragma once

#include <vector>

#include "solver/particles/fluid.hpp"
#include "solver/setup/body_outline.hpp"

namespace wetdeck {

/// Cuts the outlines, as placed at the start [m], out of particles on a lattice of squares. Before velocities
/// and pressures are set: what stays is laid anew, at rest and with new ids.
void cut_cells(FluidParticles& fluid, const std::vector<Outline>& outlines, double particle_spacing);

}  // namespace wetdeck
