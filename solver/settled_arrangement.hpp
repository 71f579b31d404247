// SPDX-License-Identifier: BSD-3-Clause
// Another arrangement of the particles of a set-up, for replicates: a peak of an impact depends on where the
// particles happen to lie. Each is moved by at most a tenth of a spacing; then the fluid settles in cycles,
// with the bodies held at rest. Only places change: after each cycle every particle gets back the density,
// the mass and the velocity that it had in the set-up, so that nothing but its place tells one arrangement
// from another.
#pragma once

#include <cstdint>

#include "solver/simulation.hpp"

namespace wetdeck {

/// The fluid of the set-up, in its order, elsewhere. The same set-up and seed give the same bits.
///
/// Throws InputError where the fluid becomes unstable while it settles.
FluidParticles settled_arrangement(const SimulationSetup& setup, std::uint64_t seed);

}  // namespace wetdeck
