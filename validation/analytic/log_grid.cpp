// SPDX-License-Identifier: BSD-3-Clause
// Integration on an equidistant grid, as the logarithmic coordinates of the wedge solution need it.
#include "validation/analytic/log_grid.hpp"

#include <cmath>
#include <numbers>

namespace wetdeck {

Eigen::ArrayXd running_integral(const Eigen::ArrayXd& f, double h, double before) {
    const Eigen::Index n = f.size();
    Eigen::ArrayXd integral(n);
    integral(0) = before;
    for (Eigen::Index i = 0; i + 1 < n; ++i) {
        const double left = i > 0 ? f(i - 1) : f(0) * f(0) / f(1);
        const double right = i + 2 < n ? f(i + 2) : f(i + 1) * f(i + 1) / f(i);
        integral(i + 1) = integral(i) + h / 24 * (13 * (f(i) + f(i + 1)) - left - right);
    }
    return integral;
}

LogKernel::LogKernel(Eigen::Index nodes, double h) : h_(h), kernel_(2 * nodes - 1) {
    for (Eigen::Index k = 1 - nodes; k < nodes; ++k) {
        const double distance = static_cast<double>(k) * h;
        // On the singular node the cell counts as log(h/2 pi).
        kernel_(k + nodes - 1) =
            k == 0 ? std::log(h / (2 * std::numbers::pi)) : std::log(std::abs(std::expm1(distance)));
    }
}

Eigen::ArrayXd LogKernel::convolve(const Eigen::ArrayXd& g) const {
    constexpr double zeta_prime_2 = -0.030448457058393270780;  // derivative of Riemann's zeta at -2
    const Eigen::Index n = g.size();
    Eigen::ArrayXd result(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const bool inside = i > 0 && i + 1 < n;
        const double second_difference = inside ? g(i + 1) - 2 * g(i) + g(i - 1) : 0;
        result(i) = h_ * ((kernel_.segment(n - 1 - i, n) * g).sum() + zeta_prime_2 * second_difference);
    }
    return result;
}

}  // namespace wetdeck
