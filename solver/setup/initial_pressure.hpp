// SPDX-License-Identifier: BSD-3-Clause
// Pressure at the start, from which the initial densities follow.
#pragma once

#include "solver/particles/fluid.hpp"
#include "solver/physics/model.hpp"

namespace wetdeck {

/// Top of the water above a point in a column: of its box and of those that stand on it without a gap [m].
double water_top(const std::vector<Box>& boxes, Vec2 position);

/// Gauge pressure [Pa] in a column of water just after its gate is gone, Yang et al. (2020), Eq. (27), after
/// Greco (2001):
///     p = rho g (h - y) - (8 rho g h / pi^2) SUM_n (2n+1)^-2 exp(-k_n d) cos(k_n y),   k_n = (2n+1) pi /
///     (2h)
/// with d >= 0 the distance to the released face and y the height above the bed. Zero on the face and on the
/// surface.
/// @param distance_to_face  on either side of the column
double greco_pressure(double density, double gravity, double height, double distance_to_face, double y);

/// Sets each particle's density so that its pressure is gauge + background. The volume stays and the mass
/// follows: compressed fluid on an even lattice is heavier. With equal masses the lattice would be too wide
/// for its density, and settle: a still column then reads 1.3 % too high at depth by T = 8 instead of 0.5 %
/// (dx = 0.04).
/// @param fluid  volumes set
/// @param model  for its equations of state
/// @param gauge  gauge pressure at a position [Pa]
template <class GaugePressure>
void set_initial_pressure(FluidParticles& fluid, const Model& model, GaugePressure gauge) {
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const Phase phase = fluid.phase(i);
        const TaitEquationOfState& eos = phase == Phase::water ? model.water.eos : model.air.eos;
        FluidState& p = fluid.state[i];
        p.pressure = eos.background_pressure + gauge(phase, p.position());
        p.density = eos.density(p.pressure);
        fluid.mass[i] = p.density * p.volume;
    }
}

}  // namespace wetdeck
