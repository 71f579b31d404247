// SPDX-License-Identifier: BSD-3-Clause
#include "validation/stress/bisect.hpp"

#include <cmath>

namespace wetdeck::stress {

Limit find_limit(double from, double to, double ratio, const std::function<bool(double)>& survives) {
    if (!survives(from)) return {std::nullopt, from};
    if (survives(to)) return {to, std::nullopt};
    double stable = from, unstable = to;
    while (std::abs(std::log(unstable / stable)) > std::log(ratio)) {
        const double middle = std::sqrt(stable * unstable);
        (survives(middle) ? stable : unstable) = middle;
    }
    return {stable, unstable};
}

}  // namespace wetdeck::stress
