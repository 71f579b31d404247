// SPDX-License-Identifier: BSD-3-Clause
// What the entry of a body into water asks of the sound speed and of the tank. Real water has 1450 m/s; a
// lower sound speed is a model error of slamming forces, in proportion to the square of the Mach number of
// the contact line, whose speed on a side of deadrise b is, after Wagner (1932), pi V / (2 tan b).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// The sound speed over the speed of the contact line from which slamming forces are within 2 % of those of
/// incompressible water (docs/decisions.md).
inline constexpr double sound_over_contact_line = 12;

/// The loss of slamming force by compressibility over the square of the contact line's Mach number: 2.5 % at
/// 10, measured at 20 and 30 degrees (docs/decisions.md).
inline constexpr double loss_by_compressibility = 2.5;

/// The side of a body on which the contact line is fastest.
struct FastestContactLine {
    std::string body;
    double entry_speed = 0;  ///< of the body where it meets the water [m/s]
    double deadrise = 0;     ///< of the side [rad]
    double speed = 0;        ///< of the contact line [m/s]
};

/// Over all bodies that start above the water and all their sides that face down at a deadrise of 4 to 85
/// degrees and take at least a twentieth of the beam; none where there is no such side. Flatter sides meet
/// the water at once: no finite sound speed is twelve times as fast.
std::optional<FastestContactLine> fastest_contact_line(const Scene& scene);

/// A sentence where water.sound_speed is less than the fastest contact line asks for, and one where a force,
/// pressure or acceleration is asked for at a time when sound has come back to a body from the floor or from
/// a side of the tank. The latter only for an artificial sound speed, below 1000 m/s. Neither
/// where the table accepted_doubts of the scene gives a reason.
std::vector<std::string> doubtful_impacts(const Scene& scene);

/// A sentence for each body with a flat bottom, whose first pressure rho c V depends on the sound speed, and
/// the reasons why doubts are accepted.
std::vector<std::string> impact_remarks(const Scene& scene);

}  // namespace wetdeck
