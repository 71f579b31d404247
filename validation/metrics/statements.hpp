// SPDX-License-Identifier: BSD-3-Clause
// Statements in the text of a scene's source, each against the runs that can tell whether it holds.
#pragma once

#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// One result for each statement and variant: the measure at the finest spacing that the runs to be related
/// have in common. Behind them one for each value that the source states (a quantity of that kind), at the
/// finest spacing of each variant. Runs that became unstable do not count. Measures:
///   difference         A - B
///   ratio              A / B
///   curve_difference   rms of A(t) - B(t) over the range of B, both within the window
std::vector<StatementResult> judge_statements(const AnalysisSpec& scene, const std::vector<RunSummary>& runs);

/// Names of the measures in scene files, in the order of the enumeration.
const std::vector<std::string>& statement_measure_names();

}  // namespace wetdeck
