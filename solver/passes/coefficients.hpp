// SPDX-License-Identifier: BSD-3-Clause
// From a model to the numbers that the passes use, one set per ordered pair of phases.
#pragma once

#include "solver/particles/fluid.hpp"
#include "solver/physics/model.hpp"

namespace wetdeck {

/// Coefficients of the formulas in physics/ for one ordered pair of phases.
struct PairCoefficients {
    double weight_right = 0.5;  ///< of u_R in the velocity mean
    double mobility = 0;        ///< pressure_diffusion / (2 mean(rho0 c)); the pass takes rho for rho0
    double right_mobility =
        0;  ///< share of the right particle in it, of a harmonic mean of present states, else 0
    double hydrostatic_density = 0;  ///< of the hydrostatic part of the pressure jump
    double pressure_weight_left = 0.5, pressure_weight_right = 0.5;
    DissipationLimiter limiter;
    double viscosity = 0;            ///< lambda mu_ij / h [Pa s/m]
    double lowest_viscous_jump = 0;  ///< 0: only approaching pairs; very negative: both signs
    double half_density = 0;         ///< rho_ij / 2 of the switched dissipation
};

/// The same for pairs of a fluid particle with a boundary particle.
struct WallCoefficients {
    DissipationLimiter limiter;
    double viscosity = 0;  ///< lambda mu / h of a no-slip wall
    double lowest_viscous_jump = 0;
    double jump_half_slowness = 0;  ///< 1 / (2 c) where the jump of Eq. (17) enters u*, else 0 [s/m]
};

/// Coefficients of an ordered pair of phases under a model.
PairCoefficients pair_coefficients(const Model& model, Phase left, Phase right, double smoothing_length);
/// Coefficients of a phase and a wall.
WallCoefficients wall_coefficients(const Model& model, Phase phase, double smoothing_length);

}  // namespace wetdeck
