// SPDX-License-Identifier: BSD-3-Clause
// Solution verification: observed order, Richardson value and grid convergence index of a quantity.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Exponent p of f(h) = f0 + C h^p through three values, h3 > h2 > h1 > 0: the only root of
///     (f3 - f2)/(f2 - f1) = r21^p (r32^p - 1)/(r21^p - 1),   r21 = h2/h1, r32 = h3/h2,
/// whose right side grows with p for any ratios. Negative if the differences grow under refinement. Empty if
/// the left side is not positive (no monotone sequence) or the root is beyond +-30.
std::optional<double> observed_order(double h3, double h2, double h1, double f3, double f2, double f1);

/// Convergence of one quantity over its spacings (any order, one value each; the finest three decide):
///
///   order             observed_order, where the values are monotone
///   monotone          the three values change in one direction
///   verdict           "too few spacings" (fewer than three); "oscillatory" (the differences change sign);
///                     "divergent" (order <= 0); "not asymptotic" (two of the values are the same, the order
///                     is outside [0.5, 2 formal_order], or a fourth spacing is off the curve:
///                     asymptotic_ratio outside [0.5, 2]); else "monotonic"
///   extrapolated      f1 - (f2 - f1)/(r21^p - 1), only where the verdict is monotonic
///   gci_fine          1.25 |f2 - f1|/(r21^p - 1), in the unit of the quantity, only where the verdict is
///                     monotonic
///   least_squares     of all spacings, where there are four or more
///   asymptotic_ratio  GCI43 / (r^p GCI32) with r = r32 and p of the finest three; needs four spacings, as
///                     with three it is 1 whatever the values are
///
/// The caller fills in `scene`, `variant` and `qoi`.
ConvergenceRow convergence(std::vector<std::pair<double, double>> spacing_and_value, double formal_order = 2);

/// Standard uncertainty of the finest spacing: with four or more half of that of least squares, with three
/// half the GCI or, where that is undefined, the range of the values; none with fewer.
std::optional<double> numerical_uncertainty(const ConvergenceRow& row);

}  // namespace wetdeck
