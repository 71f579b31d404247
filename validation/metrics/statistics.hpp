// SPDX-License-Identifier: BSD-3-Clause
// One pair of numbers per class of quantity over all scenes: bias and scatter, after the validation guide of
// FDS (McGrattan and Toman 2011).
#pragma once

#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// What a quantity of that dimension is, taken from a series in this unit: "pressure", "position", "time" and
/// so on.
std::string quantity_class(Dimension dimension, const std::string& series_unit);

/// The class that it is counted in: positions, velocities, angles and accelerations are all "motion", a force
/// over time or length is "force".
std::string statistics_class(const std::string& quantity_class);

/// The pairs of a scene in SI units: every expected quantity and every curve (its peak, or its mean where the
/// reference has no peak inside the window), from the finest sound run of the default variant; against exact
/// solutions those of the other variants, too. Not counted, with the reason: pairs from other simulations or
/// statements, of an unknown kind, with a value that is not positive (no logarithm), further readings of one
/// record, and curves whose class and series a quantity already represents.
std::vector<ScatterPoint> scatter_points(const AnalysisSpec& scene, const std::vector<RunSummary>& runs);

/// A value that several variants of a scene are expected to reach counts once, with the first of them.
void count_each_once(std::vector<ScatterPoint>& points);

/// Over the counted points of each class, those against measurements before those against exact solutions,
/// with L = ln(predicted / expected):
///   scatter      s, the standard deviation of L
///   sigma_data   root mean square of u_data, if every point has it
///   sigma_model  sqrt(max(0, s^2 - sigma_data^2)), if sigma_data is known
///   bias         exp(mean L + sigma_model^2 / 2 - sigma_data^2 / 2); exp(mean L) if sigma_data is unknown
///   bias_low, bias_high  Student's 95 % interval of the mean of L
/// Scatter and interval need two points.
std::vector<ClassStatistics> class_statistics(const std::vector<ScatterPoint>& points);

}  // namespace wetdeck
