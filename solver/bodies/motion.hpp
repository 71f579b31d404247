// SPDX-License-Identifier: BSD-3-Clause
// Prescribed motion of one degree of freedom: a displacement as a function of time, with the velocity and the
// acceleration that belong to it.
#pragma once

#include <functional>
#include <vector>

#include "solver/core/curve.hpp"

namespace wetdeck {

/// Displacement at one time, and its derivatives.
struct MotionState {
    double displacement = 0;  ///< [m] or [rad]
    double velocity = 0;      ///< [m/s] or [rad/s]
    double acceleration = 0;  ///< [m/s^2] or [rad/s^2]
};

/// A displacement over time [s].
using Motion = std::function<MotionState(double time)>;

/// A displacement that is sampled: the monotone cubic of Fritsch and Butland (1984), which meets every
/// sample, does not overshoot, and has a steady velocity. The acceleration jumps at samples. Beyond the ends
/// it goes on at the velocity there. Throws InputError unless there are two samples, all finite, at times
/// that increase.
Motion sampled_motion(const Curve& displacement);

/// A motion whose velocity is linear between samples and constant beyond them, so that the displacement is
/// exact, 0 at time 0.
/// Throws InputError unless there is a sample, all are finite and their times increase.
Motion piecewise_linear_velocity(const Curve& velocity);

/// amplitude sin(2 pi t / period + phase) as far as it has grown: over the first `ramp` [s] it is multiplied
/// by the quintic s^3 (10 - 15 s + 6 s^2), s = t / ramp, which begins and ends without an acceleration.
struct Harmonic {
    double amplitude = 0;  ///< [m] or [rad]
    double period = 1;     ///< [s]
    double phase = 0;      ///< [rad]
    double ramp = 0;       ///< [s]; 0: it begins at full size
};
/// Throws InputError unless the period is positive and the ramp not negative.
Motion harmonic_motion(const Harmonic& harmonic);

/// The same motion with its displacement at time 0 taken off.
Motion from_start(const Motion& motion);

}  // namespace wetdeck
