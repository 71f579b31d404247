// SPDX-License-Identifier: BSD-3-Clause
// The limit of stability along one quantity.
#pragma once

#include <functional>
#include <optional>

namespace wetdeck::stress {

/// The limit lies between `stable` and `unstable`. Nothing is tried beyond the range that was searched:
/// without `unstable` all of it is stable, without `stable` nothing is.
struct Limit {
    std::optional<double> stable, unstable;
};

/// Bisects a positive quantity on a logarithmic scale from `from`, where a run is expected to be stable, to
/// `to`, above or below it, until both sides of the limit are closer than `ratio` (> 1). Tries both ends
/// first. Where stability comes and goes along the way, one of its limits is found.
Limit find_limit(double from, double to, double ratio, const std::function<bool(double)>& survives);

}  // namespace wetdeck::stress
