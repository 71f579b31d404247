// SPDX-License-Identifier: BSD-3-Clause
// Linear theory of a box that floats in the middle of a tank and is free in one degree of freedom: surface
// elevation e, potential f on the surface at rest, and the displacement q of the box (heave, or roll about
// the middle of its waterline) obey
//
//     e_t = f_n,   f_t = -g e,   (m + a) q'' = -c q + rho g INT e-to-potential(e) n_q ds,
//
// with the normal n_q of unit velocity in that degree of freedom, the added inertia a of infinitely fast
// motion and the restoring coefficient c: rho g B of heave, rho g B T GM of roll.
#pragma once

#include <Eigen/Dense>

#include "solver/core/curve.hpp"

namespace wetdeck::verification {

/// Depth and width of the water [m], gravity [m/s^2], density [kg/m^3].
struct StillTank {
    double depth, width, gravity, density;
};

/// Beam and draught of the box [m].
struct FloatingBox {
    double beam, draught;
};

enum class Mode { heave, roll };

/// A degree of freedom, with the mass [kg/m] or the moment of inertia [kg m] that belongs to it. The mass
/// centre is on the waterline.
struct FreeMotion {
    Mode mode;
    double inertia;
};

class LinearTank {
  public:
    /// @param cells  panels over the draught
    LinearTank(const StillTank& tank, const FloatingBox& box, const FreeMotion& motion, int cells);

    /// Displacement over time from the release on at `start` [m or rad] until `end` [s], by the classical
    /// Runge-Kutta scheme.
    Curve release(double start, double end) const;

    double added_inertia = 0;  ///< of infinitely fast motion [kg/m or kg m]

  private:
    double gravity_, inertia_, restoring_;
    Eigen::MatrixXd slope_of_potential_;
    Eigen::VectorXd slope_of_motion_;
    Eigen::RowVectorXd load_of_potential_;
};

}  // namespace wetdeck::verification
