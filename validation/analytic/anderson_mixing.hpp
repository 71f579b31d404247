// SPDX-License-Identifier: BSD-3-Clause
// Acceleration of a fixed-point iteration: Anderson, D.G. (1965), Iterative procedures for nonlinear integral
// equations, Journal of the ACM 12, 547-560.
#pragma once

#include <Eigen/Dense>
#include <algorithm>

namespace wetdeck {

/// The iteration x -> x + f(x): the step that cancels most of f among the last few.
class AndersonMixing {
  public:
    Eigen::ArrayXd next(const Eigen::ArrayXd& x, const Eigen::ArrayXd& f) {
        if (x_.size() > 0) {
            const Eigen::Index column = count_++ % depth;
            dx_.conservativeResize(x.size(), std::min(count_, depth));
            df_.conservativeResize(x.size(), std::min(count_, depth));
            dx_.col(column) = x - x_;
            df_.col(column) = f - f_;
        }
        x_ = x;
        f_ = f;
        const Eigen::ArrayXd plain = x + relaxation * f;
        if (count_ == 0) return plain;
        const Eigen::VectorXd weights = df_.colPivHouseholderQr().solve(f.matrix());
        return plain - ((dx_ + relaxation * df_) * weights).array();
    }

  private:
    static constexpr Eigen::Index depth = 6;
    static constexpr double relaxation = 0.5;
    Eigen::Index count_ = 0;
    Eigen::ArrayXd x_, f_;
    Eigen::MatrixXd dx_, df_;
};

}  // namespace wetdeck
