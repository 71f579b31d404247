// SPDX-License-Identifier: BSD-3-Clause
// Tait equation of state with background pressure, Yang et al. (2020), Eq. (2):
//     p = (rho0 c^2 / gamma) [ (rho/rho0)^gamma - 1 ] + p0
// Pressures are gauge: zero is the air's pressure at its reference density, apart from p0.
#pragma once

#include <cmath>

#include "solver/core/scalar_math.hpp"

namespace wetdeck {

/// Pressure from density and back.
struct TaitEquationOfState {
    double reference_density = 1000;  ///< [kg/m^3]
    double sound_speed = 0;           ///< at the reference density [m/s]
    double exponent = 7;              ///< gamma
    double background_pressure = 0;   ///< p0 [Pa]

    /// rho0 c^2 / gamma [Pa]
    double coefficient() const { return reference_density * sound_speed * sound_speed / exponent; }

    /// [Pa] from [kg/m^3]
    double pressure(double density) const {
        return coefficient() * (std::pow(density / reference_density, exponent) - 1) + background_pressure;
    }

    /// [kg/m^3] from [Pa]
    double density(double pressure) const {
        return reference_density *
               std::pow((pressure - background_pressure) / coefficient() + 1, 1 / exponent);
    }

    /// Elastic energy per mass against the reference state [J/kg]: integral of (p - p0)/rho^2 d(rho), from a
    /// density and its pressure, which holds the power already.
    double compression_energy(double density, double pressure) const {
        const double volume = reference_density / density;
        const double power = (pressure - background_pressure) / coefficient() + 1;
        return coefficient() / reference_density * ((power * volume - 1) / (exponent - 1) + volume - 1);
    }
};

/// Sound speed of the second phase when both phases share the coefficient rho0 c^2 / gamma [m/s].
inline double equal_coefficient_sound_speed(const TaitEquationOfState& first, double reference_density,
                                            double exponent) {
    return std::sqrt(first.coefficient() * exponent / reference_density);
}

/// x^gamma for the two exponents in use, without pow: gamma = 7 (water) and 7/5 (air). The fifth
/// root is found by Halley's method from 1, its first step written out; one or two more reach rounding near
/// 1, four for 0.2 < x < 5.
template <class Real>
Real power_seven(Real x) {
    const Real x2 = x * x;
    return x2 * x2 * x2 * x;
}

template <class Real>
Real power_seven_fifths(Real x) {
    const Real square = x * x;
    Real root = (2.0 + 3.0 * square) / (3.0 + 2.0 * square);
    for (int step = 1; step < 5; ++step) {
        const Real root2 = root * root;
        const Real fifth = root2 * root2 * root;
        const Real miss = square - fifth;
        root = root + root * miss / (3.0 * fifth + 2.0 * square);
        if (!any_less(1e-5 * square, maximum(miss, -miss)))
            break;  // a cubically convergent step has reached rounding
    }
    return x * root;
}

}  // namespace wetdeck
