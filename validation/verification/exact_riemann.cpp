// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/exact_riemann.hpp"

#include <algorithm>
#include <cmath>

#include "validation/verification/numerics.hpp"

namespace wetdeck::verification {
namespace {

/// Decrease of the fluid's speed towards the contact when its pressure becomes `pressure`.
double speed_lost(const FluidSide& side, double pressure) {
    const double before = side.eos.pressure(side.density);
    const double density = side.eos.density(pressure);
    if (pressure > before) return std::sqrt((pressure - before) * (1 / side.density - 1 / density));
    if (density == side.density) return 0;
    const auto sound_speed_over_density = [&](double rho) {
        const TaitEquationOfState& eos = side.eos;
        return eos.sound_speed * std::pow(rho / eos.reference_density, 0.5 * (eos.exponent - 1)) / rho;
    };
    return integral(sound_speed_over_density, side.density, density);
}

}  // namespace

Contact exact_contact(const FluidSide& left, const FluidSide& right) {
    const auto excess = [&](double pressure) {
        return speed_lost(left, pressure) + speed_lost(right, pressure) + right.velocity - left.velocity;
    };
    const double p_left = left.eos.pressure(left.density), p_right = right.eos.pressure(right.density);
    const double impedance = std::max(left.eos.reference_density * left.eos.sound_speed,
                                      right.eos.reference_density * right.eos.sound_speed);
    const double reach =
        2 * impedance * std::abs(left.velocity - right.velocity) + std::abs(p_left - p_right);
    // densities stay positive
    const double vacuum = -(1 - 1e-9) * std::min(left.eos.coefficient(), right.eos.coefficient());
    const double low = std::max(vacuum, std::min(p_left, p_right) - reach),
                 high = std::max(p_left, p_right) + reach;
    Contact contact;
    contact.pressure = root(excess, low, high);
    contact.velocity = left.velocity - speed_lost(left, contact.pressure);
    return contact;
}

}  // namespace wetdeck::verification
