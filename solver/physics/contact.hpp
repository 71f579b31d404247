// SPDX-License-Identifier: BSD-3-Clause
// Contact of a corner with a face: a spring and a dashpot without friction, as in Cundall and Strack (1979),
//
//     f = max(0, k d + 2 zeta sqrt(k m) d'),
//
// with d the depth of the corner behind the face, d' its rate and m the effective mass of the contact. The
// contact ends where the force would turn into a pull. The ratio of the speeds after and before the contact
// is then, after Schwager and Poeschel (2007),
//
//     e = exp( -tan(phi) (pi - 2 phi) ),   zeta = sin(phi),
//
// from 1 without a dashpot down to exp(-2) at the critical one. Each contact loses (1 - e^2) m v^2 / 2.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wetdeck {

/// The lowest restitution that a spring and a dashpot reach, exp(-2), rounded up.
inline constexpr double lowest_restitution = 0.14;

/// The damping ratio zeta [-] of a contact with this restitution [-], from lowest_restitution to 1.
inline double damping_ratio(double restitution) {
    const double wanted = -std::log(std::clamp(restitution, lowest_restitution, 1.0));
    double low = 0, high = 0.5 * std::numbers::pi;
    for (int halving = 0; halving < 60; ++halving) {
        const double phi = 0.5 * (low + high);
        (std::tan(phi) * (std::numbers::pi - 2 * phi) < wanted ? low : high) = phi;
    }
    return std::sin(0.5 * (low + high));
}

/// The law of contact of a scene.
struct ContactLaw {
    double stiffness = 0;      ///< k of each corner and unit of width [N/m^2], 0: no contact
    double restitution = 0.5;  ///< e [-]

    /// Whether bodies push each other and the tank.
    bool on() const { return stiffness > 0; }
    /// Force on a corner [N/m], along the normal of the face.
    /// @param zeta    damping_ratio(restitution)
    /// @param depth   behind the face [m]
    /// @param rate    of the depth [m/s]
    /// @param mass    effective mass of the contact [kg/m]
    double force(double zeta, double depth, double rate, double mass) const {
        return depth > 0 ? std::max(0.0, stiffness * depth + 2 * zeta * std::sqrt(stiffness * mass) * rate)
                         : 0;
    }
    /// Energy stored in a corner at rest at this depth [J/m].
    double stored_energy(double depth) const { return depth > 0 ? 0.5 * stiffness * depth * depth : 0; }
};

}  // namespace wetdeck
