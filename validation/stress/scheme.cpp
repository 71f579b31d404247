// SPDX-License-Identifier: BSD-3-Clause
#include "validation/stress/scheme.hpp"

namespace wetdeck::stress {

std::string name_of(Scheme scheme) {
    switch (scheme) {
        case Scheme::paper:
            return "paper";
        case Scheme::no_dissipation:
            return "no dissipation";
        case Scheme::standard:
            break;
    }
    return "default";
}

void apply(Scheme scheme, Model& model) {
    if (scheme == Scheme::standard) return;
    model.dissipation = Dissipation::none;
    model.wall_dissipation = 0;
    if (scheme == Scheme::no_dissipation) {
        model.air_dissipation = 0;
        return;
    }
    model.velocity_mean = model.pressure_mean = Mean::harmonic;
    model.full_cover = 0;
    model.hydrostatic_correction = false;
    model.viscosity = Viscosity::approaching;
    model.dissipation_switch = true;
    model.wall_pressure = WallPressure::shepard;
    model.wall_velocity = WallVelocity::normal;
    model.smoothing_ratio = 1.25;
    model.courant_number = 0.25;
    model.air.eos.sound_speed = equal_coefficient_sound_speed(
        model.water.eos, model.air.eos.reference_density, model.air.eos.exponent);
}

}  // namespace wetdeck::stress
