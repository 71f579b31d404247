// SPDX-License-Identifier: BSD-3-Clause
// Water that falls from rest on air which cannot escape. A layer of air d deep under a depth H of water, with
// the pressure p = B [(rho/rho_0)^gamma - 1], is squeezed to the share x of its volume where the fall has no
// energy left; water that comes with the speed V has more of it:
//     rho H V^2 / 2 + rho g H (1 - x) d = B d [ (x^(1 - gamma) - 1) / (gamma - 1) - (1 - x) ].
#pragma once

#include <optional>
#include <string>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Share of its volume below which squeezed air leaks through walls (`wetdeck stress --only falling_column`).
inline constexpr double least_squeezed_share = 1.0 / 3;

/// The share x to which air of this stiffness B [Pa] and exponent gamma is squeezed by a weight rho g H [Pa]
/// and the energy of motion per volume of the air, rho H V^2 / (2 d) [Pa].
double squeezed_share(double weight, double stiffness, double exponent, double energy_of_motion = 0);

/// A sentence where water spans the tank above air and falls on it from rest so hard that it squeezes the air
/// to less than the least share.
std::optional<std::string> doubtful_trapped_air(const Scene& scene);

}  // namespace wetdeck
