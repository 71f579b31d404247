// SPDX-License-Identifier: BSD-3-Clause
// Solution verification of whole curves.
#include "validation/metrics/curve_convergence.hpp"

#include <algorithm>
#include <cmath>

#include "validation/metrics/convergence.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

double monotone_share(const Curve& coarse, const Curve& middle, const Curve& fine, const Window& window) {
    int monotone = 0;
    for (int i = 0; i < comparison_instants; ++i) {
        const double share = static_cast<double>(i) / (comparison_instants - 1);
        const double x = std::lerp(window.begin, window.end, share);
        const double f2 = interpolate(middle, x);
        if ((interpolate(coarse, x) - f2) * (f2 - interpolate(fine, x)) > 0) ++monotone;
    }
    return static_cast<double>(monotone) / comparison_instants;
}

std::string verdict_of(const CurveConvergenceRow& row, double coarse, double fine, double formal_order) {
    if (coarse == 0 || fine == 0) return "not asymptotic";
    if (row.order && *row.order <= 0) return "divergent";
    if (row.monotone_share < 0.5) return "oscillatory";
    if (!row.order || *row.order < 0.5 || *row.order > 2 * formal_order) return "not asymptotic";
    return "monotonic";
}

}  // namespace

CurveConvergenceRow curve_convergence(std::vector<std::pair<double, Curve>> curves, const Window& window,
                                      double formal_order) {
    CurveConvergenceRow row;
    row.window = window;
    row.verdict = "too few spacings";
    std::erase_if(curves, [&](const auto& each) { return !covers(each.second, window); });
    std::sort(curves.begin(), curves.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [dx, curve] : curves) {
        row.dx.push_back(dx);
        row.window.begin = std::max(row.window.begin, curve.x.front());
        row.window.end = std::min(row.window.end, curve.x.back());
    }
    const std::size_t n = curves.size();
    for (std::size_t k = 1; k < n; ++k)
        row.difference.push_back(rms_difference(curves[k - 1].second, curves[k].second, row.window));
    if (n == 0) return row;
    const Curve finest = clip(curves.back().second, row.window);
    const auto [lowest, highest] = std::minmax_element(finest.y.begin(), finest.y.end());
    row.range = *highest - *lowest;
    if (n < 3) return row;

    const double coarse = row.difference[n - 3], fine = row.difference[n - 2];
    row.monotone_share =
        monotone_share(curves[n - 3].second, curves[n - 2].second, curves[n - 1].second, row.window);
    row.order = observed_order(row.dx[n - 3], row.dx[n - 2], row.dx[n - 1], coarse + fine, fine, 0);
    row.verdict = verdict_of(row, coarse, fine, formal_order);
    if (row.verdict == "monotonic") {
        const double ratio = row.dx[n - 2] / row.dx[n - 1];
        row.gci_fine = 1.25 * fine / std::expm1(*row.order * std::log(ratio));
    }
    return row;
}

std::vector<double> relative_differences(const CurveConvergenceRow& row) {
    std::vector<double> relative;
    if (row.range <= 0) return relative;
    for (const double difference : row.difference) relative.push_back(difference / row.range);
    return relative;
}

std::optional<double> relative_gci(const CurveConvergenceRow& row) {
    if (!row.gci_fine || row.range <= 0) return std::nullopt;
    return *row.gci_fine / row.range;
}

}  // namespace wetdeck
