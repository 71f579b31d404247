// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/poisson.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <stdexcept>

namespace wetdeck::verification {

PoissonSolution::PoissonSolution(const PoissonProblem& problem)
    : problem_(problem),
      step_((problem.box.high.x() - problem.box.low.x()) / problem.cells_x,
            (problem.box.high.y() - problem.box.low.y()) / problem.cells_y) {
    const int nx = problem.cells_x + 1, ny = problem.cells_y + 1;
    const auto index = [nx](int i, int j) { return j * nx + i; };
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right_side = Eigen::VectorXd::Constant(nx * ny, problem.source);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int row = index(i, j);
            const Side* fixed = nullptr;
            for (const auto& [on, side] : {std::pair{i == 0, &problem.left},
                                           {i == nx - 1, &problem.right},
                                           {j == 0, &problem.bottom},
                                           {j == ny - 1, &problem.top}}) {
                if (on && side->kind == Side::Kind::value) fixed = side;
            }
            if (fixed) {
                entries.emplace_back(row, row, 1);
                right_side[row] = fixed->number;
                continue;
            }
            // a mirrored node beyond a side of given slope: p(-1) = p(1) - 2 step slope
            const auto axis = [&](int k, int last, double step, const Side& low, const Side& high,
                                  auto neighbour) {
                const double w = 1 / (step * step);
                entries.emplace_back(row, row, -2 * w);
                for (const int direction : {-1, 1}) {
                    const bool beyond = k + direction < 0 || k + direction > last;
                    entries.emplace_back(row, neighbour(beyond ? -direction : direction), w);
                    if (beyond)
                        right_side[row] -= w * direction * 2 * step * (direction < 0 ? low : high).number;
                }
            };
            axis(i, nx - 1, step_.x(), problem.left, problem.right, [&](int d) { return index(i + d, j); });
            axis(j, ny - 1, step_.y(), problem.bottom, problem.top, [&](int d) { return index(i, j + d); });
        }
    }
    Eigen::SparseMatrix<double> matrix(nx * ny, nx * ny);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
    if (factors.info() != Eigen::Success)
        throw std::logic_error("Poisson's equation: no side has a given value");
    const Eigen::VectorXd solution = factors.solve(right_side);
    node_.assign(solution.begin(), solution.end());
}

double PoissonSolution::at(Vec2 position) const {
    const Vec2 scaled = (position - problem_.box.low).cwiseQuotient(step_);
    const int i = std::clamp(static_cast<int>(scaled.x()), 0, problem_.cells_x - 1);
    const int j = std::clamp(static_cast<int>(scaled.y()), 0, problem_.cells_y - 1);
    const double s = scaled.x() - i, t = scaled.y() - j;
    const auto value = [&](int a, int b) {
        return node_[static_cast<std::size_t>(b) * static_cast<std::size_t>(problem_.cells_x + 1) +
                     static_cast<std::size_t>(a)];
    };
    return (1 - s) * ((1 - t) * value(i, j) + t * value(i, j + 1)) +
           s * ((1 - t) * value(i + 1, j) + t * value(i + 1, j + 1));
}

}  // namespace wetdeck::verification
