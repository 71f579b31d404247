// SPDX-License-Identifier: BSD-3-Clause
// Wendland C2 kernel in two dimensions, support 2 h, Yang et al. (2020), Eq. (7) with its lost pi restored:
//     W(q) = 7 / (64 pi h^2) (2 - q)^4 (2 q + 1),  q = r / h < 2
// Its slope divided by r has no singularity: -(dW/dr) / r = 10 alpha / h^2 (2 - q)^3.
#pragma once

#include <numbers>

#include "solver/core/scalar_math.hpp"

namespace wetdeck {

/// The kernel for one smoothing length.
struct WendlandC2 {
    double smoothing_length = 1;  ///< h [m]

    /// Beyond it the kernel is zero [m].
    double support_radius() const { return 2 * smoothing_length; }

    /// alpha = 7 / (64 pi h^2) [1/m^2]
    double normalisation() const { return 7 / (64 * std::numbers::pi * smoothing_length * smoothing_length); }

    /// W [1/m^2]
    double value(double distance) const { return normalisation() * shape(distance, 1 / smoothing_length); }

    /// -(dW/dr)/r [1/m^4] is slope_factor() times gradient_shape(): a pass applies the factor once per sum.
    double slope_factor() const { return 10 * normalisation() / (smoothing_length * smoothing_length); }

    /// -(dW/dr)/r [1/m^4]
    double slope_over_distance(double distance) const {
        return slope_factor() * gradient_shape(distance, 1 / smoothing_length);
    }

    /// Shape of the kernel: (2 - q)^4 (2 q + 1) inside the support, else 0.
    template <class Real, class Scale>
    static Real shape(Real distance, Scale inverse_smoothing_length) {
        const Real t = positive_part(2.0 - distance * inverse_smoothing_length);
        return t * t * t * t * (5.0 - 2.0 * t);  // 2 q + 1 = 5 - 2 t
    }

    /// Shape of its gradient: (2 - q)^3 inside the support, else 0.
    template <class Real, class Scale>
    static Real gradient_shape(Real distance, Scale inverse_smoothing_length) {
        const Real t = positive_part(2.0 - distance * inverse_smoothing_length);
        return t * t * t;
    }
};

}  // namespace wetdeck
