// SPDX-License-Identifier: BSD-3-Clause
// Where survival ends, as a number.
#pragma once

#include <functional>
#include <optional>

namespace wetdeck::stress {

/// Between `alive` and `dead` lies the limit. Neither is tried beyond the range that was searched: without
/// `dead` all of it survives, without `alive` nothing does.
struct Limit {
    std::optional<double> alive, dead;
};

/// Bisects a positive quantity on a logarithmic scale from `from`, where survival is expected, to `to`, above
/// or below it, until both sides of the limit are closer than `ratio` (> 1). Tries both ends first. Survival
/// that comes and goes along the way leaves one of its limits.
Limit find_limit(double from, double to, double ratio, const std::function<bool(double)>& survives);

}  // namespace wetdeck::stress
