// SPDX-License-Identifier: BSD-3-Clause
// Closed forms for the entry of a wedge at constant speed.
#include "validation/analytic/wagner.hpp"

#include <cmath>
#include <numbers>

namespace wetdeck {
namespace {

using std::numbers::pi;

/// Force of a plate of added mass rho pi c^2/2 whose half width c grows at `rate`.
double growing_plate(double rate) {
    return pi * rate * rate;
}

double cotangent(double angle) {
    return 1 / std::tan(angle);
}

}  // namespace

double wagner_contact_line_speed(double deadrise) {
    return pi / 2 * cotangent(deadrise);
}

double wagner_force_coefficient(double deadrise) {
    return growing_plate(wagner_contact_line_speed(deadrise));
}

double wagner_maximum_pressure(double deadrise) {
    const double spray_speed = wagner_contact_line_speed(deadrise);
    return spray_speed * spray_speed;
}

double wagner_rise() {
    return pi / 2 - 1;
}

double von_karman_force_coefficient(double deadrise) {
    return growing_plate(cotangent(deadrise));
}

}  // namespace wetdeck
