// SPDX-License-Identifier: BSD-3-Clause
// Riemann dissipation: what the intermediate pressure gains from the velocity jump du = u_L - u_R, Yang et
// al. (2020), Eq. (10), with the limiter of Zhang, Hu and Adams (2017):
//     D = 1/2 Z beta du,   beta = clamp(slope du / c, floor, 1)
// slope 3, floor 0: low dissipation (only approaching pairs, in proportion to the jump). floor 1: the full
// Riemann value for both signs. floor 0.03, slope 0: that share of it for both signs, as pairs with air need.
// Against a wall, whose side of the jump is the other's mirror image, half the jump is taken with Z for Z/2.
//
// The switch adds 1/2 rho u du where the pressure convection rate grad(p).v exceeds rho g v_max, Eqs.
// (14)-(15). Its velocity factor u is a modulus: with a negative factor it would feed energy in.
#pragma once

#include "solver/physics/interparticle_mean.hpp"

namespace wetdeck {

enum class Dissipation { none, riemann, low_dissipation };

/// The velocity factor of the switch, a modulus: of the arithmetic or the harmonic mean of the two
/// projections on the line of the pair, or of the mean velocity vector.
enum class SwitchVelocity { arithmetic, harmonic, modulus };

/// Coefficients of D for one pair of phases.
struct DissipationLimiter {
    double half_impedance = 0;    ///< Z/2, against a wall Z [kg/(m^2 s)]
    double slope_over_speed = 0;  ///< slope / c [s/m]
    double floor = 0;             ///< least beta, for both signs of du
};

/// D [Pa]
template <class Real, class Limiter>
Real riemann_dissipation(Real velocity_jump, const Limiter& limiter) {
    const auto full = limiter.half_impedance;  // Z/2 beta is clamped as a whole: one product less a pair
    const Real half_impedance_beta = minimum(
        maximum(full * limiter.slope_over_speed * velocity_jump, Real(full * limiter.floor)), Real(full));
    return half_impedance_beta * velocity_jump;
}

}  // namespace wetdeck
