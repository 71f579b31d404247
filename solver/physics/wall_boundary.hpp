// SPDX-License-Identifier: BSD-3-Clause
// Dummy-particle walls and bodies: the one-sided Riemann problem, Yang et al. (2020), Eqs. (16)-(19).
//
// The wall has the fluid's state with the normal velocity reversed about its own. The pressure behind the
// face is the fluid's plus the share of the wall's acceleration a_w and of gravity over the distance, Eq.
// (17):
//     P_R = P_L + rho_i (a_w - g) . r_iw
// taken pair by pair (one_sided), or averaged over the fluid around the boundary particle, Eq. (19): over
// both phases (shepard, as in Yang et al.), or over the water and for the water only (shepard_water), with
// pairwise pressures for the air.
//
// Eq. (17) prints the wall's own normal velocity as u_R (own), so that u* is halfway between fluid and wall
// and half of the approach is felt.
//
// Along the face the wall moves with the water around it (mirrored), so that flow that stretches along the
// wall has its full divergence there; with the reversed normal velocity alone (normal) the missing half of
// the support loses it. This share fades out close to the face, where it would let thin jets through the
// wall.
#pragma once

#include "solver/physics/interparticle_mean.hpp"

namespace wetdeck {

enum class WallSlip { free, no };
enum class WallVelocity { own, normal, mirrored };
enum class WallPressure { one_sided, shepard, shepard_water };
/// Mean of the pressures of a fluid and a boundary particle in P*.
enum class WallPairMean { arithmetic, harmonic };

/// P_R of Eq. (17) [Pa], from the separation r_i - r_w [m] and the wall's acceleration relative to gravity,
/// a_w - g [m/s^2].
template <class Real, class Scalar>
Real one_sided_pressure(Real pressure, Real density, Real separation_x, Real separation_y, Scalar relative_x,
                        Scalar relative_y) {
    return pressure + density * (relative_x * separation_x + relative_y * separation_y);
}

/// What the pressure jump P_L - P_R of Eq. (17) adds to u* along the normal [m/s], with both sides of the
/// face of the impedance rho_i c: the density cancels.
/// @param half_slowness  1 / (2 c) [s/m]
template <class Real, class Scalar>
Real wall_jump_velocity(Real separation_x, Real separation_y, Scalar relative_x, Scalar relative_y,
                        double half_slowness) {
    return -half_slowness * (relative_x * separation_x + relative_y * separation_y);
}

/// Share of the stretching along a wall that counts for a particle at `distance` from the face [spacings]:
/// all from half a spacing on, where a particle is at rest, none below a fifth.
template <class Real>
Real stretching_share(Real distance) {
    constexpr double none = 0.2, full = 0.5;
    return minimum(maximum((distance - none) * (1 / (full - none)), Real(0.0)), Real(1.0));
}

}  // namespace wetdeck
