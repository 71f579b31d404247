// SPDX-License-Identifier: BSD-3-Clause
// The pressure between a fluid and a boundary particle, as both of them compute it, Yang et al. (2020), Eqs.
// (16)-(19).
#pragma once

#include "solver/passes/simd/lanes.hpp"
#include "solver/physics/dissipation.hpp"
#include "solver/physics/wall_boundary.hpp"

namespace wetdeck::WETDECK_ISA {

/// What a pair with a wall computes, resolved at compile time.
struct WallTerms {
    bool no_slip;            ///< the wall drags the fluid along
    bool shepard_pressure;   ///< the wall has the mean pressure of the fluid around it
    bool harmonic_pressure;  ///< the pressure mean is harmonic
    bool graded;             ///< particles differ in their spacings
};

/// The fluid particle of a pair. Either side may be the pack.
template <class Real>
struct FluidSide {
    Real pressure, density;
};

/// The boundary particle of a pair: normal, acceleration less gravity, mean pressure of the fluid around it.
template <class Real>
struct WallSide {
    Real nx, ny, relative_x, relative_y, mean_pressure;
};

/// (x, y) leads from the wall to the fluid, (vx, vy) is the fluid's velocity relative to the wall.
struct WallPairGeometry {
    Pack x, y, vx, vy, inverse_distance;
};

/// P* of a pair. Fluid behind the face takes the one-sided pressure: the mean there belongs to the other side
/// of a thin body. An edge, which has no normal, has no dissipation: water parts there and does not stop.
/// @param fineness  of the pair
template <WallTerms terms, class Fluid, class Wall, class Fineness>
WETDECK_INLINE Pack wall_p_star(const PassInput& in, const FluidSide<Fluid>& fluid,
                                const WallSide<Wall>& wall, const WallPairGeometry& pair,
                                const Fineness& fineness, const WallCoefficients& c) {
    const Pack signed_distance = pair.x * wall.nx + pair.y * wall.ny;
    const Pack one_sided = one_sided_pressure(Pack(fluid.pressure), Pack(fluid.density), pair.x, pair.y,
                                              wall.relative_x, wall.relative_y);
    Pack p_right = one_sided;
    if constexpr (terms.shepard_pressure)
        p_right = select(signed_distance > 0.0, wall.mean_pressure, one_sided);
    const Pack normal_velocity = pair.vx * wall.nx + pair.vy * wall.ny;
    const Pack approach_speed = select(signed_distance > 0.0, -normal_velocity, normal_velocity);
    Pack p_star;
    if constexpr (terms.harmonic_pressure) {
        p_star = harmonic_mean_of_pressures(Pack(fluid.pressure), p_right, in.model->mean_guard,
                                            in.smallest_pressure) +
                 riemann_dissipation(approach_speed, c.limiter);
    } else {
        p_star = 0.5 * (fluid.pressure + p_right) + riemann_dissipation(approach_speed, c.limiter);
    }
    if constexpr (terms.no_slip) {
        const Pack approach = -(pair.vx * pair.x + pair.vy * pair.y) * pair.inverse_distance;
        p_star += fineness * c.viscosity * maximum(2.0 * approach, c.lowest_viscous_jump);
    }
    return p_star;
}

}  // namespace wetdeck::WETDECK_ISA
