// SPDX-License-Identifier: BSD-3-Clause
// Poisson's equation on a rectangle by second-order finite differences and a sparse factorisation: pressures
// without a closed form, independent of the particles.
#pragma once

#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck::verification {

struct Side {
    enum class Kind { value, slope } kind = Kind::value;
    double number = 0;  ///< the value, or the derivative along the coordinate (not the outward one)
};

struct PoissonProblem {
    Box box;
    int cells_x = 0, cells_y = 0;
    double source = 0;  ///< Laplacian of the solution
    Side left, right, bottom, top;
};

/// The solution on the nodes, bilinear between them.
class PoissonSolution {
  public:
    explicit PoissonSolution(const PoissonProblem& problem);
    double at(Vec2 position) const;

  private:
    PoissonProblem problem_;
    Vec2 step_;
    std::vector<double> node_;
};

}  // namespace wetdeck::verification
