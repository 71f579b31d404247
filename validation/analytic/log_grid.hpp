// SPDX-License-Identifier: BSD-3-Clause
// Integration on an equidistant grid, as the logarithmic coordinates of the wedge solution need it.
#pragma once

#include <Eigen/Core>

namespace wetdeck {

/// Running integral of f > 0 over a grid of spacing h, fourth order, beginning with `before` at the first
/// node. Beyond the ends f goes on as the exponential through its last two values.
Eigen::ArrayXd running_integral(const Eigen::ArrayXd& f, double h, double before);

/// Convolutions with log|1 - exp(y - x)|, the kernel of a half plane in logarithmic coordinates.
class LogKernel {
  public:
    LogKernel(Eigen::Index nodes, double h);

    /// Integral of g(y) log|1 - exp(y - x)| dy at every node x; g vanishes at both ends. Trapezoidal rule
    /// with the Euler-Maclaurin terms of the logarithm at y = x, error O(h^5).
    Eigen::ArrayXd convolve(const Eigen::ArrayXd& g) const;

  private:
    double h_;
    Eigen::ArrayXd kernel_;
};

}  // namespace wetdeck
