// SPDX-License-Identifier: BSD-3-Clause
// Means of two particles' values, Yang et al. (2020), Eq. (11) and its alternatives.
//
// Arithmetic, density- and impedance-weighted means are linear in the values: one pair of weights per pair of
// phases, from reference states. The harmonic mean 2ab/(a+b) is that of Yang et al.: of the velocity vectors
// it is taken by component, because in v* = u* e + (v_bar - u_bar e) the mean u_bar of the projections
// cancels along e. Where a and b differ in sign it is singular at a + b = 0 and depends on the observer's
// motion; a guard says what stands there.
#pragma once

#include "solver/core/scalar_math.hpp"

namespace wetdeck {

enum class Mean { arithmetic, density_weighted, impedance_weighted, harmonic };

/// What stands for a harmonic mean where it has no meaning.
enum class MeanGuard {
    division,              ///< the formula as printed, 0 where it divides by nothing
    same_sign_arithmetic,  ///< the arithmetic mean where the signs differ
    same_sign_zero         ///< zero where the signs differ: continuous where a value passes zero
};

/// The mean of rho c in u*: of the reference states, scaled to the present density of the left particle, or
/// the harmonic mean of Yang et al. of the present states.
enum class ImpedanceMean { arithmetic, harmonic };

/// Weights of the left and right value; they add up to 1.
struct MeanWeights {
    double left = 0.5;   ///< of particle i
    double right = 0.5;  ///< of its neighbour j
};

/// Weights proportional to what each side carries: density or impedance, or nothing (arithmetic).
constexpr MeanWeights weights_by(double left, double right) {
    return {left / (left + right), right / (left + right)};
}

constexpr double harmonic_mean(double a, double b) {
    return 2 * a * b / (a + b);
}

/// 2ab/(a+b), or 0 where |a + b| <= guard.
template <class Real, class Scalar>
Real guarded_harmonic_mean(Real a, Real b, Scalar guard) {
    const Real sum = a + b;
    const auto regular = (sum > guard) | (sum < -guard);
    return select(regular, 2.0 * a * b / select(regular, sum, Real(1.0)), Real(0.0));
}

/// The harmonic mean of two signed values under a guard.
/// @param smallest  of |a + b| for a division [unit of the values]
template <class Real, class Scalar>
Real harmonic_mean(Real a, Real b, MeanGuard guard, Scalar smallest) {
    if (guard == MeanGuard::division) return guarded_harmonic_mean(a, b, smallest);
    const auto same_sign = a * b > 0.0;
    const Real other = guard == MeanGuard::same_sign_arithmetic ? 0.5 * (a + b) : Real(0.0);
    return select(same_sign, 2.0 * a * b / select(same_sign, a + b, Real(1.0)), other);
}

/// The same of two pressures, whose harmonic mean has a meaning where both are positive.
template <class Real, class Scalar>
Real harmonic_mean_of_pressures(Real a, Real b, MeanGuard guard, Scalar smallest) {
    if (guard == MeanGuard::division) return guarded_harmonic_mean(a, b, smallest);
    const auto positive = minimum(a, b) > 0.0;
    const Real other = guard == MeanGuard::same_sign_arithmetic ? 0.5 * (a + b) : Real(0.0);
    return select(positive, 2.0 * a * b / select(positive, a + b, Real(1.0)), other);
}

}  // namespace wetdeck
