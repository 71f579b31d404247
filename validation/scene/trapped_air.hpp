// SPDX-License-Identifier: BSD-3-Clause
// Water that falls from rest on air which cannot escape. A layer of air d deep under a depth H of water, with
// the pressure p = B [(rho/rho_0)^gamma - 1], is squeezed to the share x of its volume where the fall has no
// energy left:
//     rho g H (1 - x) d = B d [ (x^(1 - gamma) - 1) / (gamma - 1) - (1 - x) ].
#pragma once

#include <optional>
#include <string>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// The share x to which air of this stiffness B [Pa] and exponent gamma is squeezed by a weight rho g
/// H [Pa].
double squeezed_share(double weight, double stiffness, double exponent);

/// A sentence where water spans the tank above air and falls on it from rest so hard that it squeezes the air
/// to less than a third, beyond which it leaks through the walls (`wetdeck stress --only falling_column`).
std::optional<std::string> doubtful_trapped_air(const Scene& scene);

}  // namespace wetdeck
