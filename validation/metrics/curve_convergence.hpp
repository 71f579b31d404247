// SPDX-License-Identifier: BSD-3-Clause
// Solution verification of whole curves.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Convergence of one curve over its spacings (any order; the finest three decide), inside the window that
/// all curves span, at `comparison_instants` equidistant instants:
///
///   difference      root mean square of each curve minus the next finer one
///   order           observed_order with the two finest differences in place of f3 - f2 and f2 - f1
///   gci_fine        1.25 difference / (r21^p - 1), only where the verdict is monotonic
///   monotone_share  share of the instants at which the three finest values change in one direction
///   verdict         "too few spacings"; "divergent" (the differences do not fall); "oscillatory" (fewer than
///                   half of the instants are monotone); "not asymptotic" (no order, or outside [0.5, 2
///                   formal_order]); else "monotonic"
///
/// A curve that does not span `required_coverage` of the window is left out. The caller fills in `scene`,
/// `variant` and `series`.
CurveConvergenceRow curve_convergence(std::vector<std::pair<double, Curve>> spacing_and_curve,
                                      const Window& window, double formal_order = 2);

/// `difference` and `gci_fine` over the range of the finest curve; empty where that curve is constant.
std::vector<double> relative_differences(const CurveConvergenceRow& row);
std::optional<double> relative_gci(const CurveConvergenceRow& row);

}  // namespace wetdeck
