// SPDX-License-Identifier: BSD-3-Clause
// Water entry at constant velocity of a wedge that is heeled or enters obliquely: the self-similar potential
// flow that stays attached to both faces, without gravity, air or viscosity. The method is that of the
// symmetric wedge (Dobrovolskaya 1969) with a flow around the apex; Semenov, Y.A. and Iafrati, A. (2006), On
// the nonlinear water entry problem of asymmetric wedges, Journal of Fluid Mechanics 547, 65-92, treat the
// same flow by another one.
#pragma once

#include <array>
#include <vector>

#include "solver/core/curve.hpp"

namespace wetdeck {

/// A wedge whose apex points down. x to the right, z up.
struct HeeledWedgeEntry {
    double deadrise_left = 0;   ///< angle of the left face to the undisturbed level, rad
    double deadrise_right = 0;  ///< the same of the right face, rad
    double horizontal = 0;      ///< velocity of the wedge to the right over its velocity V downward
};

/// What one face bears. Lengths over V t, pressure coefficients over rho V^2/2.
struct HeeledWedgeFace {
    double contact_angle = 0;     ///< between the free surface and the face at the tip of the jet, rad
    double wetted_length = 0;     ///< from the apex to the tip of the jet
    double loaded_length = 0;     ///< from the apex: the part that bears 99 % of the normal force
    double normal_force = 0;      ///< over rho V^3 t
    double peak_pressure = 0;     ///< Cp
    double peak_distance = 0;     ///< of it from the apex
    double suction_length = 0;    ///< part next to the apex with a pressure below that of the free surface
    double suction_force = 0;     ///< normal force on that part, negative
    double tip_x = 0, tip_z = 0;  ///< tip of the jet, from the point of first contact
    Curve pressure;               ///< Cp over the distance from the apex; begins at 1e-4 of the wetted length
};

struct HeeledWedge {
    HeeledWedgeEntry entry;
    HeeledWedgeFace left, right;
    double force_x = 0;  ///< on the wedge, over rho V^3 t per metre
    double force_y = 0;  ///< upward
    double moment = 0;   ///< about the apex, counterclockwise positive, over rho V^4 t^2 per metre
    /// Share of the suction at the apex in the normal force on a face, the larger of both. There the pressure
    /// of the attached flow falls without bound (integrably); where this share is large the water separates
    /// or sheds a vortex.
    double suction_share = 0;
    /// Change of force_x, force_y, moment and the relative change of the higher pressure peak when the step
    /// of the grids is halved: more than the error of what is handed out.
    double force_x_change = 0, force_y_change = 0, moment_change = 0, peak_change = 0;
    /// force_x, force_y and moment from the rate of change of the momentum of the water, which uses the free
    /// surface and the potential instead of the pressure on the faces.
    double momentum_force_x = 0, momentum_force_y = 0, momentum_moment = 0;
    double potential_jump = 0;  ///< of the potential at the apex, from face to face; 0 in the exact solution
};

/// The solution for faces of 8 to 70 degrees. Throws InputError outside of that, and where the suction at the
/// apex takes more than 2 % of the force on a face or the attached flow is not found: an ideal flow that
/// stays attached says little about a real one there.
HeeledWedge heeled_wedge(const HeeledWedgeEntry& entry);

}  // namespace wetdeck
