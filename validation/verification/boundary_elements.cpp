// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/boundary_elements.hpp"

#include <cmath>
#include <numbers>

namespace wetdeck::verification {

void append_panels(std::vector<Panel>& panels, Vec2 from, Vec2 to, int n) {
    for (int k = 0; k < n; ++k)
        panels.push_back({from + (to - from) * k / n, from + (to - from) * (k + 1) / n});
}

Eigen::MatrixXd mixed_solution(const std::vector<Panel>& panels, Eigen::Index valued) {
    // value / 2 = SUM_j (double_ij value_j - single_ij slope_j), with G = ln(r) / (2 pi)
    const auto n = static_cast<Eigen::Index>(panels.size());
    Eigen::MatrixXd unknown_side(n, n), given_side(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const Panel& panel = panels[static_cast<std::size_t>(j)];
        const Vec2 along = (panel.to - panel.from) / panel.length();
        for (Eigen::Index i = 0; i < n; ++i) {
            const Vec2 position = panels[static_cast<std::size_t>(i)].middle();
            // the panel from a to b as seen from it, at the height d on the side of its normal
            const double a = (panel.from - position).dot(along), b = (panel.to - position).dot(along);
            const double d = (panel.from - position).dot(panel.normal());
            const double angle = i == j ? 0 : std::atan2(d * (b - a), d * d + a * b);
            const auto primitive = [&](double s) {
                const double squared = s * s + d * d;
                return squared > 0 ? 0.5 * s * std::log(squared) - s : 0.0;
            };
            // INT ln r ds = [s ln r - s] + d times the angle under which the panel is seen
            const double single =
                (primitive(b) - primitive(a) + (i == j ? 0 : d * angle)) / (2 * std::numbers::pi);
            const double double_layer = angle / (2 * std::numbers::pi);  // INT d / r^2 ds
            const double of_value = (i == j ? 0.5 : 0) - double_layer;
            unknown_side(i, j) = j < valued ? single : of_value;
            given_side(i, j) = j < valued ? -of_value : -single;
        }
    }
    return unknown_side.partialPivLu().solve(given_side);
}

}  // namespace wetdeck::verification
