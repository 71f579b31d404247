// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/verification.hpp"

#include <algorithm>
#include <cmath>

namespace wetdeck {

std::optional<double> observed_slope(const std::vector<double>& resolution,
                                     const std::vector<double>& error) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t k = 0; k < std::min(resolution.size(), error.size()); ++k) {
        if (!(resolution[k] > 0) || !(error[k] > 0)) continue;
        const double x = std::log(resolution[k]), y = std::log(error[k]);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    if (n < 2 || !(spread > 0)) return std::nullopt;
    return (n * sxy - sx * sy) / spread;
}

void judge(VerificationRow& row) {
    row.order = observed_slope(row.resolution, row.error);
    row.within = !row.error.empty();
    const double slope = row.claim.order ? row.claim.order->begin : 0;
    for (std::size_t k = 0; k < row.error.size(); ++k) {
        const double bound = row.claim.bound * std::pow(row.resolution[k] / row.resolution.front(), slope);
        if (!(std::abs(row.error[k]) <= bound)) row.within = false;  // also where it is not a number
    }
    if (!row.claim.order || row.error.size() < 2) return;
    const Window& range = *row.claim.order;
    if (!row.order || *row.order < range.begin || *row.order > range.end) row.within = false;
}

bool any_unstable(const std::vector<VerificationProblem>& problems) {
    return std::any_of(problems.begin(), problems.end(),
                       [](const auto& problem) { return !problem.unstable.empty(); });
}

}  // namespace wetdeck
