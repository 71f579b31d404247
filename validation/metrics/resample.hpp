// SPDX-License-Identifier: BSD-3-Clause
// Scaling, cutting and linear interpolation of curves.
#pragma once

#include <optional>
#include <string>

#include "solver/core/curve.hpp"
#include "validation/metrics/specification.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// Number of equidistant instants of every difference of two curves, both ends of the window included.
inline constexpr int comparison_instants = 2000;

/// Share of a window that a curve must span for a number to be taken from it.
inline constexpr double required_coverage = 0.98;

/// A series as a curve, or the reason why it cannot be one.
struct SeriesCurve {
    Curve curve;          ///< scaled; up to the last sound sample if there is a problem
    std::string problem;  ///< empty if the whole series is sound
    double origin = 0;    ///< on the scaled axis, of a curve that was shifted to its peak
};

/// A series under its scaling. The result names a problem, and no number may be taken from it, if the series
/// is missing or empty, is a profile without an instant (or no profile with one), or holds values that are
/// not finite or times that do not increase.
SeriesCurve series_curve(const RunRecord& record, const std::string& series,
                         const SeriesScaling& scaling = {});

/// Linear interpolation; x outside the curve takes the value of the nearer end. The curve must not be empty.
double interpolate(const Curve& curve, double x);

/// The samples inside the window and, where the curve crosses them, its interpolated ends.
Curve clip(const Curve& curve, const Window& window);

/// The part of the window that the curve spans; empty if that is a single instant or less.
std::optional<Window> overlap(const Curve& curve, const Window& window);

/// From the first to the last abscissa. The curve must not be empty.
Window extent(const Curve& curve);

/// The curve spans at least `required_coverage` of the window.
bool covers(const Curve& curve, const Window& window);

/// Average over the curve, which has two samples or more (trapezoidal rule).
double average(const Curve& curve);

/// Root mean square difference at `comparison_instants` equidistant instants of the window, both curves
/// interpolated linearly.
double rms_difference(const Curve& a, const Curve& b, const Window& window);

/// Index of the largest value of a curve that is not empty, the first one if there are several.
std::size_t index_of_maximum(const Curve& curve);

}  // namespace wetdeck
