// SPDX-License-Identifier: BSD-3-Clause
// A pressure gauge of physical size on a vertical wall.
//
// An experiment's gauge is a disc. In two dimensions its mean is that over its height, weighted by the chord.
// At each of a fixed number of heights the fluid's pressure is interpolated to the face with the kernel,
//     p(y) = SUM_j p_j V_j W_j / max( SUM_j V_j W_j, 1/4 ),
// where 1/2 is the sum of a face covered with fluid; a face that is less than half covered reads towards zero
// gauge pressure.
#pragma once

#include <vector>

#include "solver/simulation.hpp"

namespace wetdeck {

class WallPressureProbe {
  public:
    /// @param centre    of the disc, on the face [m]
    /// @param diameter  of the disc [m]
    WallPressureProbe(Vec2 centre, double diameter);

    /// Throws InputError if the disc is smaller than one particle spacing: too few particles would be
    /// averaged.
    void check(double particle_spacing) const;

    /// Gauge pressure [Pa]: the background pressure is taken off.
    double sample(const Simulation& simulation) const;

  private:
    Vec2 centre_;
    double diameter_;
    std::vector<double> height_, weight_;
};

}  // namespace wetdeck
