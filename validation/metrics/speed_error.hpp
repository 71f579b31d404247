// SPDX-License-Identifier: BSD-3-Clause
// Error against cost, and the runs that no other run beats in both (Pareto front).
#pragma once

#include <string>
#include <vector>

#include "validation/metrics/quantities.hpp"
#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// One point per run of the scene: processor seconds, and how far its `error_quantity` is from the expected
/// value, over that value where it is not zero. An rms difference to a curve is an error itself. A quantity
/// without an expected value is compared with the value to which the spacings of its variant converge. Runs
/// that did not end well, and values that do not converge, have no error. `pareto` marks, among the points
/// with an error against the same thing, those that no other point beats in one of cost and error without
/// being worse in the other.
std::vector<SpeedErrorPoint> speed_error_points(const std::vector<RunSummary>& runs,
                                                const AnalysisSpec& scene,
                                                const std::vector<ConvergenceRow>& convergence);

/// For every quantity with an expected value other than zero (relative error |S - D| / |D|) and every curve
/// that is not another simulation's (nrmse): the cheapest sound run within 5 % and within 10 %, and the run
/// of the smallest error.
std::vector<CheapestRow> cheapest_rows(const std::vector<RunSummary>& runs, const AnalysisSpec& scene);

/// Other codes in the place of the scene's error quantity, where that is an rms difference to a curve: each
/// peer simulation of the same series against the same curve in the same window. Its cost and the conditions
/// of that cost are the keys `cost_core_s` and `cost_conditions` of its file, empty where it lacks them. A
/// peer that does not cover the window has no point.
std::vector<PeerPoint> peer_points(const AnalysisSpec& scene, ReferenceShelf& references);

}  // namespace wetdeck
