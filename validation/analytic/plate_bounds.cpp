// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the flat impact of a plate on still water.
#include "validation/analytic/plate_bounds.hpp"

#include <cmath>
#include <numbers>

namespace wetdeck {

PlateBounds plate_bounds(const PlateImpact& impact) {
    PlateBounds bounds;
    const double half = impact.beam / 2;
    bounds.added_mass =
        impact.density * std::numbers::pi * half * half / 2;         // half of a plate in unbounded water
    const double share = 1 / (1 + bounds.added_mass / impact.mass);  // 1 for a plate that is held
    bounds.plastic_impulse = bounds.added_mass * impact.speed * share;
    bounds.plastic_speed_loss = bounds.plastic_impulse / impact.mass;
    bounds.elastic_impulse = 2 * bounds.plastic_impulse;
    bounds.elastic_speed_loss = 2 * bounds.plastic_speed_loss;
    bounds.acoustic_pressure = impact.density * impact.sound_speed * impact.speed;
    bounds.acoustic_force = bounds.acoustic_pressure * impact.beam;
    bounds.acoustic_relief_time = half / impact.sound_speed;
    return bounds;
}

}  // namespace wetdeck
