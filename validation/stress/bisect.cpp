// SPDX-License-Identifier: BSD-3-Clause
#include "validation/stress/bisect.hpp"

#include <cmath>

namespace wetdeck::stress {

Limit find_limit(double from, double to, double ratio, const std::function<bool(double)>& survives) {
    if (!survives(from)) return {std::nullopt, from};
    if (survives(to)) return {to, std::nullopt};
    double alive = from, dead = to;
    while (std::abs(std::log(dead / alive)) > std::log(ratio)) {
        const double middle = std::sqrt(alive * dead);
        (survives(middle) ? alive : dead) = middle;
    }
    return {alive, dead};
}

}  // namespace wetdeck::stress
