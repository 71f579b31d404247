// SPDX-License-Identifier: BSD-3-Clause
// The main quantities of one run, as lines for a terminal.
#pragma once

#include <string>
#include <vector>

#include "validation/metrics/quantities.hpp"

namespace wetdeck {

/// "  force_peak    29.4 kN/m, expected 26.5 kN/m within 2.65: outside" for each quantity of the variant:
/// those with an expected value first, at most eight, and then how many more there are. What was not reached
/// says why.
std::vector<std::string> quantity_lines(const AnalysisSpec& spec, const RunRecord& record,
                                        ReferenceShelf& references);

}  // namespace wetdeck
