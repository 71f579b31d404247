// SPDX-License-Identifier: BSD-3-Clause
// Water entry of a symmetric wedge at constant speed: the self-similar potential flow of Dobrovolskaya
// (1969), without gravity, air or viscosity.
#pragma once

#include <vector>

#include "solver/core/curve.hpp"

namespace wetdeck {

/// Lengths over V t, counted from the undisturbed level (z up, apex of the wedge at z = -1); pressure
/// coefficients over rho V^2/2.
struct WedgeSimilarity {
    double deadrise = 0;           ///< rad
    double contact_angle = 0;      ///< between the free surface and the face at the tip of the jet, rad
    double force_coefficient = 0;  ///< F/(rho V^3 t), both faces, per metre
    double added_mass_coefficient =
        0;                        ///< added mass/(rho (V t)^2) of the wetted wedge under its free surface
    double maximum_pressure = 0;  ///< Cp
    double maximum_pressure_height = 0;  ///< z of it; -1 where the apex has it (45 degrees and above)
    double apex_pressure = 0;            ///< Cp at the apex
    double tip_x = 0;
    double tip_z = 0;
    Curve pressure;                            ///< Cp over z along a face, from the apex to the tip
    std::vector<double> surface_x, surface_z;  ///< free surface from the tip outwards
    double closure =
        0;  ///< relative mismatch of two expressions for the wetted length that agree in the exact solution
};

/// The solution for a deadrise [rad] of 2 to 70 degrees; throws InputError outside of that.
WedgeSimilarity wedge_similarity(double deadrise);

/// Penetration [m] at which the root of the spray (the pressure maximum) reaches the end of a face
/// `half_beam` from the axis. Throws InputError from 45 degrees on, where the maximum is at the keel.
double chine_wetting_penetration(const WedgeSimilarity& wedge, double half_beam);

}  // namespace wetdeck
