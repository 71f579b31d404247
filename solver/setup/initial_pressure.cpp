// SPDX-License-Identifier: BSD-3-Clause
#include "solver/setup/initial_pressure.hpp"

#include <cmath>
#include <numbers>

namespace wetdeck {

double greco_pressure(double density, double gravity, double height, double distance_to_face, double y) {
    using std::numbers::pi;
    constexpr int most_terms = 4000;
    double sum = 0;
    for (int n = 0; n < most_terms; ++n) {
        const double odd = 2 * n + 1;
        const double wave_number = odd * pi / (2 * height);
        const double decay = std::exp(-wave_number * distance_to_face) / (odd * odd);
        if (decay < 1e-12) break;
        sum += decay * std::cos(wave_number * y);
    }
    return density * gravity * (height - y) - 8 * density * gravity * height / (pi * pi) * sum;
}

}  // namespace wetdeck
