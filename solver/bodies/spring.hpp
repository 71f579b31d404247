// SPDX-License-Identifier: BSD-3-Clause
// Springs and dashpots between a body and the earth: along one degree of freedom, or along the line from a
// point of the body to a point of the earth. The elongation e is that of the degree of freedom from the
// start, or of the line beyond its free length. The pull is
//
//     T = k s + c de/dt (where s is not 0),   s = e - e_high above the play [e_low, e_high], e - e_low below
//     it, else 0,
//
// or T = table(e) + c de/dt. A play makes an end stop of a spring; a line that is slack below its free
// length is a mooring rope, e_low = -infinity.
#pragma once

#include <array>
#include <optional>

#include "solver/core/curve.hpp"
#include "solver/core/vec2.hpp"

namespace wetdeck {

struct RigidBody;
struct BodyLoad;

/// One spring with its dashpot.
struct Spring {
    /// What the spring acts along.
    enum class Direction { x, y, rotation, line };
    Direction direction = Direction::y;  ///< a degree of freedom, or a line
    Vec2 on_body = Vec2::Zero();         ///< end of the line, in the body's frame [m]
    Vec2 on_earth = Vec2::Zero();        ///< its other end, in the scene [m]
    double free_length = 0;              ///< of the line [m]
    double rest = 0;       ///< of a degree of freedom: displacement from the start without a pull
    double stiffness = 0;  ///< k [N/m^2]; of rotation [N/rad]
    double damping = 0;    ///< c [N s/m^2]; of rotation [N s/rad]
    std::array<double, 2> play = {0, 0};  ///< e_low and e_high [m] or [rad]
    Curve table;                          ///< pull over elongation in place of k s; empty: none

    /// The pull at an elongation [m] and its rate [m/s]; linear between the samples of a table, and beyond
    /// them along its last pieces [N/m].
    double pull(double elongation, double rate) const;
    /// The largest stiffness of the law [N/m^2].
    double largest_stiffness() const;
    /// The load on the body in its present pose.
    /// @param velocity          of the mass centre, when the load acts [m/s]
    /// @param angular_velocity  the same [rad/s]
    BodyLoad load(const RigidBody& body, Vec2 velocity, double angular_velocity) const;
    /// An upper bound of the square of the angular frequency with which it moves the body alone [1/s^2].
    double frequency2(const RigidBody& body) const;
};

}  // namespace wetdeck
