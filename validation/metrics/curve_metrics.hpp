// SPDX-License-Identifier: BSD-3-Clause
// Differences of two curves, with amplitude, timing and shape apart.
#pragma once

#include <vector>

#include "solver/core/curve.hpp"
#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Features of both curves, taken over the window:
///   peak, time of peak   the largest value; only of a curve that has it inside the window, not at an end
///   rise time            from the last time below 10 % of the peak to the first at 90 % of it
///   impulse, mean        integral over the window and the same over its length (trapezoidal rule)
std::vector<CurveFeature> curve_features(const Curve& simulated, const Curve& reference,
                                         const Window& window);

/// Both curves at `comparison_instants` equidistant instants of the window, S and D:
///   magnitude  sqrt(sum S^2 / sum D^2) - 1
///   phase      arccos(sum S D / sqrt(sum S^2 sum D^2)) / pi
///   combined   sqrt(magnitude^2 + phase^2)                       (Sprague and Geers 2004)
/// and the shift in time (at most a tenth of the window, in steps of its 2000th part) and the factor a that
/// make the rms of a S(t + shift) - D(t) least; the rms that remains is a difference of shape. Empty where
/// one of the curves vanishes.
CurveAgreement curve_agreement(const Curve& simulated, const Curve& reference, const Window& window);

/// The value of a feature; empty if there is none of that name.
std::optional<double> simulated_feature(const ComparisonResult& comparison, const std::string& name);
std::optional<double> reference_feature(const ComparisonResult& comparison, const std::string& name);

/// The feature that speaks for the curve: "peak" where the reference has one that stands above both ends of
/// the window by a tenth of its range, else "mean". The last ripple of a decreasing curve is no peak.
const char* judged_feature(const ComparisonResult& comparison);

}  // namespace wetdeck
