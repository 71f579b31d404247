// SPDX-License-Identifier: BSD-3-Clause
// The linearised Riemann problem between two particles, Yang et al. (2020), Eq. (10), along e from left (i)
// to right (j):
//     u* = mean(u_L, u_R) + (P_L - P_R) / (2 mean(rho c)),   P* = mean(P_L, P_R) + dissipation
// With impedance weights these are the exact acoustic states of two materials:
//     u* = (Z_L u_L + Z_R u_R + P_L - P_R) / (Z_L + Z_R),    P* = (Z_R P_L + Z_L P_R + Z_L Z_R (u_L - u_R)) /
//     (Z_L + Z_R)
// The pressure jump in u* diffuses density. Only its part beyond the hydrostatic jump may do so, else a
// column at rest inflates. It is taken at the present density of the left particle: at the reference density
// the diffusion of compressed air would outrun the time step.
#pragma once

namespace wetdeck {

/// u_L - u* for a linear mean: the velocity difference in the continuity equation of the left particle.
/// @param jump  u_L - u_R [m/s]
/// @param pressure_jump  P_L - P_R beyond the hydrostatic jump [Pa]
/// @param weight_right  weight of u_R in the mean
/// @param mobility  1 / (2 mean(rho c)) [m^2 s/kg]
template <class Real, class Scalar, class Mobility>
Real velocity_left_less_star(Real jump, Real pressure_jump, Scalar weight_right, Mobility mobility) {
    return weight_right * jump - mobility * pressure_jump;
}

/// A linear mean of two pressures.
template <class Real, class Scalar>
Real weighted_pressure(Real left, Real right, Scalar weight_left, Scalar weight_right) {
    return weight_left * left + weight_right * right;
}

}  // namespace wetdeck
