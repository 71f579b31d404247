// SPDX-License-Identifier: BSD-3-Clause
// Pressure on faces: at points, and as a gauge of physical size reads it.
//
// The fluid's pressure is interpolated to the face with the kernel,
//     p(x) = SUM_j p_j V_j W_j / max( SUM_j V_j W_j, 1/4 ),
// where 1/2 is the sum of a face covered with fluid; a face that is less than half covered reads towards zero
// gauge pressure. An experiment's gauge is a disc: in two dimensions its mean is that over its height,
// weighted by the chord.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/simulation.hpp"

namespace wetdeck {

/// Gauge pressures [Pa] at points on faces of walls or bodies: the background pressure is taken off.
std::vector<double> face_pressures(const Simulation& simulation, std::span<const Vec2> points);

/// A disc on a straight face.
class PressureGauge {
  public:
    /// @param centre    of the disc, on the face [m]
    /// @param along     direction of the face
    /// @param diameter  of the disc [m]
    /// @param body      number of the body it sits on; `centre` and `along` are then in that body's frame
    PressureGauge(Vec2 centre, Vec2 along, double diameter, std::optional<std::size_t> body = std::nullopt);

    /// Throws InputError if the disc is smaller than one particle spacing: too few particles would be
    /// averaged.
    void check(double particle_spacing) const;

    /// Gauge pressure [Pa]: the background pressure is taken off.
    double sample(const Simulation& simulation) const;

  private:
    double diameter_;
    std::optional<std::size_t> body_;
    std::vector<Vec2> point_;
    std::vector<double> weight_;
};

}  // namespace wetdeck
