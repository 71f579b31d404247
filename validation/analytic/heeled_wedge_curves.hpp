// SPDX-License-Identifier: BSD-3-Clause
// Pressure and loads of a heeled wedge as curves that a scene can name.
#pragma once

#include <string>

#include "validation/analytic/curve_header.hpp"

namespace wetdeck {

/// Throws InputError unless both faces of the values `deadrise` and `heel` [degrees] make 8 to 70 degrees
/// with the level.
void check_heeled_wedge(const CurveValues& values);

/// Text of a reference file: Cp over the distance from the apex, negative on the left face. Values:
/// deadrise, heel [degrees], horizontal (velocity to the right over the velocity downward).
std::string heeled_wedge_pressure_text(const CurveValues& values);

/// Text of a reference file: force and moment over time. Values as above and speed (downward) [m/s], beam
/// [m], gravity [m/s^2], density [kg/m^3].
std::string heeled_wedge_force_text(const CurveValues& values);

}  // namespace wetdeck
