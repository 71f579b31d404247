// SPDX-License-Identifier: BSD-3-Clause
// Closed forms for the entry of a wedge at constant speed, for comparison with the full solution: Wagner
// (1932) and von Karman (1929). Deadrise in rad.
#pragma once

namespace wetdeck {

/// F/(rho V^3 t) of a flat plate that grows as the water piles up, half width (pi/2) V t cot(deadrise).
double wagner_force_coefficient(double deadrise);

/// Speed of the contact line along the surface, over V: pi/(2 tan(deadrise)).
double wagner_contact_line_speed(double deadrise);

/// Cp (over rho V^2/2) at the spray root.
double wagner_maximum_pressure(double deadrise);

/// z/(V t) of the spray root above the undisturbed level: pi/2 - 1 at every deadrise.
double wagner_rise();

/// F/(rho V^3 t) without pile-up, half width V t cot(deadrise).
double von_karman_force_coefficient(double deadrise);

}  // namespace wetdeck
