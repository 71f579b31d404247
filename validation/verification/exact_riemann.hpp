// SPDX-License-Identifier: BSD-3-Clause
// The exact Riemann problem of two fluids with Tait equations of state: each side sends a shock (mass and
// momentum conserved) or a rarefaction (Riemann invariant) away from the contact,
//     shock:        u_* - u = -+ sqrt( (p_* - p) (1/rho - 1/rho_*) )
//     rarefaction:  u_* - u = -+ INT_rho^rho_* c / rho d(rho)
// and the pressure p_* is where both sides have one velocity. Pressure is a function of density alone: there
// is no energy equation.
#pragma once

#include "solver/physics/equation_of_state.hpp"

namespace wetdeck::verification {

struct FluidSide {
    TaitEquationOfState eos;
    double density = 0;   ///< [kg/m^3]
    double velocity = 0;  ///< to the right [m/s]
};

struct Contact {
    double pressure = 0;
    double velocity = 0;
};

Contact exact_contact(const FluidSide& left, const FluidSide& right);

}  // namespace wetdeck::verification
