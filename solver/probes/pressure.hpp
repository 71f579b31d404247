// SPDX-License-Identifier: BSD-3-Clause
// Pressure on faces: at points, and as a gauge of physical size reads it.
//
// The fluid lies on one side of a face, its kernel-weighted centre 0.64 spacings away, so that the pressure
// of each particle j in front of the face is first carried to the point x along the slope of fluid at rest
// relative to the face, of normal n and acceleration a:
//     q_j = p_j + rho_0 [ g - (a . n) n ] . (x - x_j)
// A field that is linear with another slope still varies in q. With means < > weighted by V_j W_j,
//     C = < (x - <x>)(x - <x>)^T >,  b = < (x - <x>)(q - <q>) >,  s = C^-1 b,
//     d^2 = s . b,  e^2 = < (q - <q>)^2 > - d^2,
// s is the slope of its first-order least-squares fit, d^2 the part of the variance that s explains, e^2 the
// rest. With l h^2 the smaller eigenvalue of C, the slope counts as far as the particles bear it out: in full
// in a linear field, not at all where they are in disorder (e^2 > d^2 / 100) or lie in a line (l = 0):
//     f = max( 0, 1 - 100 e^2 / d^2 ) min( 1, l / 0.02 )^2
// The reading is
//     p(x) = m { <p> + m^2 [ <q> - <p> + f s . (x - <x>) ] },  m = min( 1, 2 SUM_j V_j W_j / S ),
// where S is the share of the kernel that walls and bodies leave to fluid: 1/2 on a face, 1/4 in a corner. A
// face that is less than half covered reads towards zero gauge pressure. Water that bears no negative
// pressure reads none. Every linear field is read exactly, along any face and in corners, as long as two rows
// of particles lie within the kernel's reach.
//
// An experiment's gauge is a disc: in two dimensions its mean is that over its height, weighted by the chord.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/simulation.hpp"

namespace wetdeck {

/// A point on a straight face of a wall or a body.
struct FacePoint {
    Vec2 place;                        ///< [m]
    Vec2 normal;                       ///< unit vector into the fluid
    Vec2 acceleration = Vec2::Zero();  ///< of the face there [m/s^2]
};

/// A point of the body's frame where the body is now, with its acceleration.
FacePoint placed(const FacePoint& point, const RigidBody& body);

/// Gauge pressures [Pa] at the points: the background pressure is taken off.
std::vector<double> face_pressures(const Simulation& simulation, std::span<const FacePoint> points);

/// The largest mean of a row of values, each of which fills an interval of width 1, over any interval of that
/// width, from 1 to the number of values: what a patch bears where it is worst loaded.
double largest_mean(std::span<const double> values, double width);

/// A disc on a straight face.
class PressureGauge {
  public:
    /// @param centre    of the disc, on the face [m]
    /// @param normal    of the face, into the fluid
    /// @param diameter  of the disc [m]
    /// @param body      number of the body it sits on; `centre` and `normal` are then in that body's frame
    PressureGauge(Vec2 centre, Vec2 normal, double diameter, std::optional<std::size_t> body = std::nullopt);

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
