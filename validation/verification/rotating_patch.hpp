// SPDX-License-Identifier: BSD-3-Clause
// A free square of incompressible fluid that starts to rotate rigidly, by finite elements that move with the
// fluid: cells of a lattice keep their areas, their pressures are what keeps them. No kernel, no sound.
#pragma once

#include <Eigen/Dense>

#include "solver/core/vec2.hpp"

namespace wetdeck::verification {

class RotatingPatch {
  public:
    /// The square of this side about the origin, in cells x cells cells. Density is 1.
    RotatingPatch(double side, double rotation, int cells);

    /// Moves on by the classical Runge-Kutta scheme in equal steps.
    void advance(double duration, int steps);

    /// Where the fluid now is that was at `start`.
    Vec2 place_of(Vec2 start) const;
    double largest_area_error() const;  ///< of a cell, relative

  private:
    using Vector = Eigen::VectorXd;
    int node(int column, int row) const { return column * (cells_ + 1) + row; }
    template <class Visit>
    void each_cell(Visit visit) const;
    Vector accelerations(const Vector& position, const Vector& velocity) const;

    double side_;
    int cells_;
    Vector mass_, place_, velocity_;  ///< x, y of each node
};

}  // namespace wetdeck::verification
