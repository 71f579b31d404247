// SPDX-License-Identifier: BSD-3-Clause
// Dummy-particle walls and bodies: the one-sided Riemann problem, Yang et al. (2020), Eqs. (16)-(19).
//
// The wall sees the fluid's state with the normal velocity reversed about its own. The pressure behind the
// face is the fluid's plus what the wall's acceleration and gravity add over the distance, Eq. (17):
//     P_R = P_L + rho_i (a_w - g) . r_iw
// taken pair by pair (one_sided), or averaged over the fluid around the boundary particle, Eq. (19)
// (shepard). The mean over both phases is the paper's; the default takes it over the water and for the water
// only, and leaves air pairwise: a mean that mixes the phases throws air particles off edges, and pairwise
// pressures brake the water (front speed 1.74 instead of 1.79 at dx = 0.02).
//
// Along the face the wall carries the velocity of the water around it (mirrored), so that flow that stretches
// along the wall has its full divergence there. With the reversed normal velocity alone (normal), the part of
// the stretching that the missing half of the support should give is lost: the bed pressure under a run-up is
// 20 % low, and the water gains energy (0.1 % of the column's at dx = 0.02) because the wall's pressure
// gradient pushes where the continuity equation sees nothing. A particle that is already close to the face is
// not let any closer by this: the term fades out there.
#pragma once

#include "solver/physics/interparticle_mean.hpp"

namespace wetdeck {

enum class WallSlip { free, no };
enum class WallVelocity { normal, mirrored };
enum class WallPressure { one_sided, shepard, shepard_water };

/// P_R of Eq. (17). `separation` is r_i - r_w, `drive` is a_w - g.
template <class Real, class Scalar>
Real one_sided_pressure(Real pressure, Real density, Real separation_x, Real separation_y, Scalar drive_x,
                        Scalar drive_y) {
    return pressure + density * (drive_x * separation_x + drive_y * separation_y);
}

/// Share of the stretching along a wall that a particle at `distance` from the face feels, in spacings: full
/// from half a spacing on, where a particle rests, none below a fifth.
template <class Real>
Real stretching_share(Real distance) {
    constexpr double none = 0.2, full = 0.5;
    return minimum(maximum((distance - none) * (1 / (full - none)), Real(0.0)), Real(1.0));
}

}  // namespace wetdeck
