// SPDX-License-Identifier: BSD-3-Clause
// Repeated measurements: the value in the middle and how far the others lie from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace wetdeck {

/// Median and median absolute deviation: a repeat that was disturbed moves neither.
struct Measured {
    double median = 0, deviation = 0;
};

/// Of a sample that is not empty; of an even number, the mean of the two in the middle.
inline double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

inline Measured measured(const std::vector<double>& values) {
    const double median = median_of(values);
    std::vector<double> distances;
    for (const double value : values) distances.push_back(std::abs(value - median));
    return {median, median_of(distances)};
}

}  // namespace wetdeck
