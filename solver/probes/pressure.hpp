// SPDX-License-Identifier: BSD-3-Clause
// Pressure on faces: at points, and as a gauge of physical size reads it.
//
// The fluid's pressure is interpolated to the face with the kernel. The particles lie on one side of it,
// their weighted centre about 0.64 spacings away, so that each pressure is first carried to the face along
// the hydrostatic slope:
//     p(x) = SUM_j V_j W_j [ p_j + rho_j g' . (x - x_j) ] / max( SUM_j V_j W_j, 1/4 ),
// where 1/2 is the sum of a face covered with fluid. g' is the part of gravity normal to the face, along
// which the sums are one-sided, and all of gravity within a smoothing length of an end of the face, where
// they are one-sided along the face, too; on a vertical face away from its ends it is zero. A face that is
// less than half covered reads towards zero gauge pressure; below the sum c = 1/4 the slope counts by (4
// c)^2. The acceleration of the face is not in the slope. An experiment's gauge is a disc: in two dimensions
// its mean is that over its height, weighted by the chord.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "solver/simulation.hpp"

namespace wetdeck {

/// A point on a straight face of a wall or a body.
struct FacePoint {
    Vec2 place;     ///< [m]
    Vec2 along;     ///< unit vector along the face, either way
    double to_end;  ///< distance to the nearer end of the face [m]
};

/// A point of the body's frame where the body is now.
FacePoint placed(const FacePoint& point, const RigidBody& body);

/// Gauge pressures [Pa] at the points: the background pressure is taken off.
std::vector<double> face_pressures(const Simulation& simulation, std::span<const FacePoint> points);

/// A disc on a straight face.
class PressureGauge {
  public:
    /// @param centre         of the disc, on the face [m]
    /// @param along          direction of the face
    /// @param diameter       of the disc [m]
    /// @param body           number of the body it sits on; `centre` and `along` are then in that body's
    /// frame
    /// @param centre_to_end  distance from the centre to the nearer end of the face [m]
    PressureGauge(Vec2 centre, Vec2 along, double diameter, std::optional<std::size_t> body = std::nullopt,
                  double centre_to_end = std::numeric_limits<double>::infinity());

    /// Throws InputError if the disc is smaller than one particle spacing: too few particles would be
    /// averaged.
    void check(double particle_spacing) const;

    /// Gauge pressure [Pa]: the background pressure is taken off.
    double sample(const Simulation& simulation) const;

  private:
    double diameter_;
    std::optional<std::size_t> body_;
    std::vector<FacePoint> point_;
    std::vector<double> weight_;
};

}  // namespace wetdeck
