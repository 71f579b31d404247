// SPDX-License-Identifier: BSD-3-Clause
#include "solver/setup/initial_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wetdeck {

double water_top(const std::vector<Box>& boxes, Vec2 position) {
    constexpr double tolerance = 1e-9;
    double top = position.y();
    const auto next = [&] {
        return std::find_if(boxes.begin(), boxes.end(), [&](const Box& box) {
            const bool in_column = box.low.x() <= position.x() && position.x() <= box.high.x();
            return in_column && box.low.y() <= top + tolerance && box.high.y() > top + tolerance;
        });
    };
    for (auto box = next(); box != boxes.end(); box = next()) top = box->high.y();
    return top;
}

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
