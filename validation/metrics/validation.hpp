// SPDX-License-Identifier: BSD-3-Clause
// Comparison error and validation uncertainty in the sense of ASME V&V 20. An uncertainty that is
// not stated stays unknown and is never taken as zero.
#pragma once

#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// What runs of all variants say of the effects of inputs and of the particles' arrangement.
struct InputStudies {
    const std::vector<SensitivityRow>& sensitivity;
    const std::vector<ReplicateRow>& replicates;
};

/// The rows of one scene: for the finest run of each variant that ended well, every judged value
/// (judged_values.hpp) that an experiment gives a value for, or a source of unsaid kind.
///   u_grid     half of the 95 % uncertainty of the finest spacing: of least squares with four or more
///              spacings, of the grid convergence index with three; where these do not converge
///              monotonically, the range of their values. Where the values oscillate, or differ by no more
///              than replicates do, and there are replicates: sqrt(max(0, v - s^2)) with the variance v over
///              the spacings and the standard deviation s of the replicates
///   u_scatter  s, from the replicates of this variant or, where it has none, of the default variant
///   u_num      root of the sum of both squares; unknown with fewer than three spacings
///   u_data     stated with the expected value, or relative to the curve
///   u_input    root of the sum of squares over the inputs that the studies name for this variant and value
///              or, where this variant has no study, for the default variant; unknown without
/// Only the default variant and those with at least three spacings have rows. `verdict` and `sentence` are
/// those of verdict.hpp.
///
/// Beside them stand, in the same way, the rows against exact solutions, other codes and values stated in
/// publications: the same inputs, so that u_input is zero; u_data of an exact solution is zero unless it is
/// stated.
struct JudgedRows {
    std::vector<ValidationRow> validation, agreement;
};
JudgedRows judged_rows(const AnalysisSpec& scene, const std::vector<RunSummary>& runs,
                       const InputStudies& studies);

/// The effect of each varied input on the quantities and the curves (by the names of `judged_rows`), from
/// pairs of runs with the key at its low and its high value.
std::vector<SensitivityRow> sensitivity_rows(const AnalysisSpec& scene,
                                             const std::vector<SensitivityRun>& runs);

}  // namespace wetdeck
