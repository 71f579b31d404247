// SPDX-License-Identifier: BSD-3-Clause
// Comparison error and validation uncertainty in the sense of ASME V&V 20. An uncertainty that is
// not stated stays unknown and is never taken as zero.
#pragma once

#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// The rows of one scene: for the finest run of each variant that ended well, every quantity that an
/// experiment gives a value for (or a source of unsaid kind; an error measure against a curve is no such
/// quantity), and of every measured curve its peak, or its mean over the window where the reference has no
/// peak inside.
///   u_num    half of the grid convergence index (which is taken as a 95 % interval); where the three finest
///            spacings do not converge monotonically, the whole range of their values; unknown with fewer
///   u_data   stated with the expected value, or relative to the curve
///   u_input  root of the sum of squares over the inputs that `sensitivity` names for this variant and
///            quantity or, where this variant has no study, for the default variant; unknown without
/// Only the default variant and those with at least three spacings have rows. `verdict` and `sentence` are
/// those of verdict.hpp.
std::vector<ValidationRow> validation_rows(const AnalysisSpec& scene, const std::vector<RunSummary>& runs,
                                           const std::vector<SensitivityRow>& sensitivity);

/// The effect of each varied input on the quantities and the curves (by the names of `validation_rows`), from
/// pairs of runs with the key at its low and its high value.
std::vector<SensitivityRow> sensitivity_rows(const AnalysisSpec& scene,
                                             const std::vector<SensitivityRun>& runs);

}  // namespace wetdeck
