// SPDX-License-Identifier: BSD-3-Clause
// Dummy-particle walls and bodies: the one-sided Riemann problem, Yang et al. (2020), Eqs. (16)-(19).
//
// The wall sees the fluid's state with the normal velocity reversed about its own. The pressure behind the face is the
// fluid's plus what the wall's acceleration and gravity add over the distance, Eq. (17):
//     P_R = P_L + rho_i (a_w - g) . r_iw
// taken pair by pair (one_sided), or averaged over the fluid around the boundary particle, Eq. (19) (shepard). The mean over
// both phases is the paper's; the default takes it over the water and for the water only, and leaves air pairwise: a
// mean that mixes the phases throws air particles off edges, and pairwise pressures brake the water (front speed 1.69
// instead of 1.79 at dx = 0.02).
#pragma once

#include "solver/physics/interparticle_mean.hpp"

namespace wetdeck {

enum class WallSlip { free, no };
enum class WallPressure { one_sided, shepard, shepard_water };

/// P_R of Eq. (17). `separation` is r_i - r_w, `drive` is a_w - g.
template <class Real, class Scalar>
Real one_sided_pressure(Real pressure, Real density, Real separation_x, Real separation_y, Scalar drive_x,
                        Scalar drive_y) {
    return pressure + density * (drive_x * separation_x + drive_y * separation_y);
}

}  // namespace wetdeck
