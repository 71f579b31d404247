// SPDX-License-Identifier: BSD-3-Clause
// Comparison of a series of a run with a reference curve.
#pragma once

#include "validation/metrics/quantities.hpp"
#include "validation/metrics/resample.hpp"
#include "validation/metrics/specification.hpp"
#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// The scaled series of a comparison; shifted until its largest value is at zero, where that is asked for. A
/// series whose largest value is its first or last sample has no peak: that is then its problem.
SeriesCurve compared_series(const ComparisonSpec& spec, const RunRecord& record);

/// Compares the scaled series with the reference inside the window, or where the two overlap if there is no
/// window, without a time shift (where peaks are aligned, after that; the window is then on the aligned
/// axis):
///
///   nrmse       root mean square difference at 2000 equidistant instants over the range of the reference
///   peak_error  (largest simulated - largest reference) / |largest reference|
///   time_error  scaled time of the largest value, simulated - reference; empty where the reference has its
///               largest value at an end of the window, as a front has, and where peaks are aligned
///
/// and the features of both curves and their agreement (curve_metrics.hpp), unless the scene asks for the
/// reference to be shown and not judged. There are no metrics, `within` is
/// false, and a note says why, where the series is missing or not sound, where it covers less than
/// `required_coverage` of the part of the window that the reference spans, and where a run that stopped early
/// is compared without a window. A reference file that does not exist, is not sound or holds another
/// dimension than the series gives `available` = false and a note. A note also names a window of which the
/// reference itself spans less than `required_coverage`.
ComparisonResult compare(const ComparisonSpec& spec, const RunRecord& record, ReferenceShelf& references);

}  // namespace wetdeck
