// SPDX-License-Identifier: BSD-3-Clause
// What can be said about the motion of a scene before it is run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// A speed and what reaches it.
struct ExpectedSpeed {
    double speed = 0;  ///< [m/s]
    std::string of;    ///< "of body when it meets the water", ...
};

/// Middles of the intervals between all ends of the boxes of water and the walls of the tank [m].
std::vector<double> column_middles(const Scene& scene);

/// A body that starts above water and comes down to it.
struct WaterEntry {
    double speed = 0;          ///< downwards, where it meets the water [m/s]
    double time = 0;           ///< of that [s]
    double level = 0;          ///< of the water [m]
    Vec2 keel = Vec2::Zero();  ///< the lowest corner at the start [m]
};

/// By free fall under the part of gravity that its applied force leaves, or at the velocity given; none for a
/// body that starts in the water, has none below it, or does not come down.
std::optional<WaterEntry> water_entry(const Scene& scene, const BodySpec& spec);

/// The fastest of these speeds:
///     sqrt(g H)    of water that collapses, with H the largest step of its level,
///     sqrt(2 g d)  of water that falls by d to the floor or to other water,
///     sqrt(v^2 + 2 a d)  of a body that falls by d to the water or the floor, a the part of g that its
///                  applied force leaves; v alone where its motion is given,
/// each besides the speed of the body's fastest corner by its rotation.
ExpectedSpeed fastest_expected_speed(const Scene& scene);

/// The largest speed of the motion that is given for a body: of its mass centre, and of its corners by
/// `radius` [m/s]; 0 without one.
double largest_given_speed(const Scene& scene, const RigidBody& body);

/// The outline of a body at a third, two thirds and the whole of the time for which its motion is given; none
/// for a body without given motion.
std::vector<Outline> positions_given(const Scene& scene, const BodySpec& spec);

/// How the velocities and motions that are given for a body lead it out of the tank or into a solid, as far
/// as 200 instants show; nothing if they do not.
std::optional<std::string> collision_of_given_motion(const Scene& scene, const BodySpec& spec);
/// A sentence for each body whose given motion leads it out of the tank before the end.
std::vector<std::string> motions_out_of_tank(const Scene& scene);

}  // namespace wetdeck
