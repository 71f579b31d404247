// SPDX-License-Identifier: BSD-3-Clause
// Means of two particles' values, Yang et al. (2020), Eq. (11) and its alternatives.
//
// Arithmetic, density- and impedance-weighted means are linear in the values: one pair of weights per pair of
// phases, from reference states. The harmonic mean 2ab/(a+b) is the paper's. It is singular where a + b = 0
// and, for signed values, depends on the observer's motion; it is guarded against division by zero only.
#pragma once

#include "solver/core/scalar_math.hpp"

namespace wetdeck {

enum class Mean { arithmetic, density_weighted, impedance_weighted, harmonic };

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

}  // namespace wetdeck
