// SPDX-License-Identifier: BSD-3-Clause
// What probes see of fluid of which half is computed: each particle, and its mirror image behind the plane of
// symmetry.
#pragma once

#include "solver/simulation.hpp"

namespace wetdeck {

/// Calls visit(number, position) for the first `count` particles and, where the left end of the domain is a
/// plane of symmetry, for their mirror images.
template <class Visit>
void for_each_in_both_halves(const Simulation& simulation, std::size_t count, const Visit& visit) {
    const FluidParticles& fluid = simulation.fluid();
    const double twice_plane = 2 * simulation.domain().low.x();
    const bool mirrors = simulation.model().mirror_x;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 at = fluid.state[i].position();
        visit(i, at);
        if (mirrors) visit(i, Vec2(twice_plane - at.x(), at.y()));
    }
}

/// The interior of the whole tank [m].
inline Box whole_tank(const Simulation& simulation) {
    Box tank = simulation.domain();
    if (simulation.model().mirror_x) tank.low.x() = 2 * tank.low.x() - tank.high.x();
    return tank;
}

}  // namespace wetdeck
