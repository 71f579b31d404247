// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the flat impact of a plate on still water, per metre: momentum theory and the acoustic limit.
#pragma once

namespace wetdeck {

struct PlateImpact {
    double beam = 0;         ///< m
    double speed = 0;        ///< at contact, m/s
    double mass = 0;         ///< kg/m; infinity for a plate that is held at its speed
    double density = 1000;   ///< of the water, kg/m^3
    double sound_speed = 0;  ///< of the water, m/s
};

/// Plastic: plate and water move on together. Elastic: no energy is lost, as with an ideal cushion of trapped
/// air. What is in between depends on the air; more than elastic is impossible without a further source of
/// momentum.
struct PlateBounds {
    double added_mass = 0;            ///< of the wetted plate, rho pi beam^2/8, kg/m
    double plastic_impulse = 0;       ///< N s/m
    double plastic_speed_loss = 0;    ///< m/s
    double elastic_impulse = 0;       ///< twice the plastic one
    double elastic_speed_loss = 0;    ///< m/s
    double acoustic_pressure = 0;     ///< water hammer rho c V, Pa
    double acoustic_force = 0;        ///< over the whole beam, N/m
    double acoustic_relief_time = 0;  ///< after which waves from the edges meet at the centre, beam/(2 c), s
};

PlateBounds plate_bounds(const PlateImpact& impact);

}  // namespace wetdeck
