// SPDX-License-Identifier: BSD-3-Clause
// Balances over all fluid, per metre of span. Sums run in particle order on one thread: the same bits on any
// machine size.
#pragma once

#include "solver/simulation.hpp"

namespace wetdeck {

/// Sums over all fluid at one time.
struct Balance {
    double kinetic = 0;              ///< [J/m]
    double potential = 0;            ///< [J/m], zero at the origin
    double compression = 0;          ///< [J/m] against the reference density, background pressure left out
    Vec2 momentum = Vec2::Zero();    ///< [N s/m]
    double mass = 0;                 ///< [kg/m]
    double water_density_error = 0;  ///< largest |rho/rho0 - 1| of water
    std::size_t outside = 0;         ///< particles beyond the tank's faces by more than a quarter spacing
};

/// At the present time of the simulation.
Balance balance(const Simulation& simulation);

}  // namespace wetdeck
