// SPDX-License-Identifier: BSD-3-Clause
// The pressure between a fluid and a boundary particle, as both of them compute it; and the passes over
// boundary particles.
#pragma once

#include "solver/passes/simd/lanes.hpp"
#include "solver/physics/dissipation.hpp"
#include "solver/physics/wall_boundary.hpp"

namespace wetdeck::WETDECK_ISA {

/// P* between a fluid particle and a boundary particle; either side may be the pack. (sx, sy) leads from the
/// wall to the fluid, (vx, vy) is the fluid's velocity relative to the wall. A fluid particle behind the face
/// takes the one-sided pressure: the mean there is that of the other side of a thin body.
template <bool no_slip, bool shepard, class Fluid, class Wall>
WETDECK_INLINE Pack wall_p_star(Fluid pressure, Fluid density, Pack sx, Pack sy, Pack vx, Pack vy,
                                Pack inverse_distance, Wall nx, Wall ny, Wall drive_x, Wall drive_y,
                                Wall mean_pressure, const WallCoefficients& c) {
    const Pack height = sx * nx + sy * ny;
    const Pack one_sided = one_sided_pressure(Pack(pressure), Pack(density), sx, sy, drive_x, drive_y);
    Pack p_right = one_sided;
    if constexpr (shepard) p_right = select(height > 0.0, mean_pressure, one_sided);
    const Pack receding = vx * nx + vy * ny;
    const Pack closing = -(vx * sx + vy * sy) * inverse_distance;
    const Wall edge = 1.0 - (nx * nx + ny * ny);  // has no normal
    const Pack approach = select(height > 0.0, -receding, receding) + edge * closing;
    Pack p_star = 0.5 * (pressure + p_right) + riemann_dissipation(approach, c.limiter);
    if constexpr (no_slip) {
        p_star += c.viscosity * maximum(2.0 * closing, c.lowest_viscous_jump);
    }
    return p_star;
}

/// Eq. (19): pressure and velocity of the fluid around each boundary particle.
void wall_means(const PassInput& in);

/// Eq. (20): the pass over the boundary particles of bodies.
Pass body_force_pass(const Model& model);

}  // namespace wetdeck::WETDECK_ISA
