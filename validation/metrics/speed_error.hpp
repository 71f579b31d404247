// SPDX-License-Identifier: BSD-3-Clause
// Error against cost, and which runs are not beaten in both.
#pragma once

#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// One point per run of the scene: processor seconds and the quantity `error_quantity` as the error. Runs
/// that did not end well have no error. `pareto` marks, among the points that have one, those that no other
/// point beats in one of cost and error without being worse in the other.
std::vector<SpeedErrorPoint> speed_error_points(const std::vector<RunSummary>& runs, const std::string& scene,
                                                const std::string& error_quantity);

}  // namespace wetdeck
