// SPDX-License-Identifier: BSD-3-Clause
// Free fall of a wedge into water, two-dimensional, with the coefficients of its similarity flow.
#pragma once

#include <vector>

#include "validation/analytic/wedge_similarity.hpp"

namespace wetdeck {

struct FallingWedge {
    double mass = 0;        ///< kg/m
    double speed = 0;       ///< downward at contact, m/s
    double gravity = 9.81;  ///< m/s^2
    double density = 1000;  ///< of the water, kg/m^3
};

/// Histories from the contact of the apex, SI units, per metre.
struct WedgeFall {
    std::vector<double> time;
    std::vector<double> penetration;  ///< of the apex below the undisturbed level
    std::vector<double> velocity;     ///< downward
    std::vector<double> force;        ///< of the water, upward
};

/// Integrates (M + alpha rho z^2) dV/dt = M g - C_F rho z V^2 - rho g z^2 cot(deadrise), where C_F is the
/// force coefficient and alpha the added-mass coefficient of the wetted wedge, with a row every `step` [s] as
/// long as the apex is less than `depth` below the level and goes down. Holds while the face is not wetted
/// whole: to chine_wetting_penetration().
WedgeFall wedge_free_fall(const WedgeSimilarity& wedge, const FallingWedge& fall, double depth, double step);

}  // namespace wetdeck
