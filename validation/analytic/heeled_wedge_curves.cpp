// SPDX-License-Identifier: BSD-3-Clause
// Pressure and loads of a heeled wedge as curves that a scene can name.
#include "validation/analytic/heeled_wedge_curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"
#include "validation/analytic/heeled_wedge.hpp"

namespace wetdeck {
namespace {

constexpr int rows = 400;
constexpr const char* citation =
    "computed here; the method extends Dobrovolskaya, Z.N. (1969), On some problems of similarity flow of "
    "fluid "
    "with a free surface, Journal of Fluid Mechanics 36, 805-829, by a flow around the apex";
constexpr const char* numerical_error =
    "numerical error seen between step widths, against the symmetric solution and against the momentum of "
    "the "
    "water; no published number of an asymmetric wedge was at hand; says nothing of gravity, air, three "
    "dimensions "
    "or separation at the apex";
constexpr const char* sign_of_heel =
    "heel counterclockwise positive: it lowers the angle of the left face and raises that "
    "of the right one";

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

HeeledWedge solution_of(const CurveValues& values) {
    const double deadrise = values.at("deadrise"), heel = values.at("heel");
    return heeled_wedge({radians(deadrise - heel), radians(deadrise + heel), values.at("horizontal")});
}

std::string method_of(const CurveValues& values) {
    return fmt::format(
        "similarity solution of a wedge of {:.6g} degrees, heeled by {:.6g} degrees, horizontal velocity "
        "{:.6g} V: conformal map to a half plane, two coupled integral equations for the slopes of the "
        "free surfaces, 581 nodes each in log coordinates",
        values.at("deadrise"), values.at("heel"), values.at("horizontal"));
}

std::string suction_note(const HeeledWedge& wedge) {
    return fmt::format(
        "Constant velocity, no gravity. The flow stays attached at the apex; its suction there reaches "
        "{:.2g} V t and takes {:.2g} of the force on a face",
        std::max(wedge.left.suction_length, wedge.right.suction_length), wedge.suction_share);
}

}  // namespace

void check_heeled_wedge(const CurveValues& values) {
    const double deadrise = values.at("deadrise"), heel = std::abs(values.at("heel"));
    if (deadrise - heel < 8 || deadrise + heel > 70) {
        throw InputError(fmt::format("faces of {:.6g} and {:.6g} degrees to the level, expected 8 to 70",
                                     deadrise - heel, deadrise + heel));
    }
}

std::string heeled_wedge_pressure_text(const CurveValues& values) {
    const HeeledWedge wedge = solution_of(values);
    std::string text = curve_header_text(
        {citation, "none", method_of(values), "0.001", numerical_error,
         fmt::format("s from the apex along the faces, negative on the left one; Cp = p/(rho V^2/2) with the "
                     "downward "
                     "velocity V, gauge; {}",
                     sign_of_heel)
             .c_str(),
         "contact of the apex",
         suction_note(wedge) + ". Points nearer than 1e-4 of the wetted length to the apex are left out"},
        "s_over_Vt [-],Cp [-]");
    const Curve &left = wedge.left.pressure, &right = wedge.right.pressure;
    for (std::size_t i = left.x.size(); i-- > 0;)
        text += fmt::format("{:.9g},{:.9g}\n", -left.x[i], left.y[i]);
    for (std::size_t i = 0; i < right.x.size(); ++i)
        text += fmt::format("{:.9g},{:.9g}\n", right.x[i], right.y[i]);
    return text;
}

std::string heeled_wedge_force_text(const CurveValues& values) {
    const HeeledWedge wedge = solution_of(values);
    const double speed = values.at("speed"), density = values.at("density"), gravity = values.at("gravity");
    const double face = values.at("beam") / 2 / std::cos(radians(values.at("deadrise")));
    const double end = face / std::max(wedge.left.loaded_length, wedge.right.loaded_length) / speed;
    const double force = density * std::pow(speed, 3), moment = force * speed;
    // Of the triangle below the undisturbed level at the depth 1.
    const double cot_left = 1 / std::tan(wedge.entry.deadrise_left),
                 cot_right = 1 / std::tan(wedge.entry.deadrise_right);
    const double area = (cot_left + cot_right) / 2, arm = (cot_right - cot_left) / 3;
    std::string text = curve_header_text(
        {citation, "none",
         fmt::format("F_x = {:.6g} rho V^3 t, F_y = {:.6g} rho V^3 t, moment = {:.6g} rho V^4 t^2; {}",
                     wedge.force_x, wedge.force_y, wedge.moment, method_of(values)),
         "0.001", numerical_error,
         fmt::format("x to the right, y upward, moment about the apex and counterclockwise positive, on the "
                     "wedge, per "
                     "metre; {}",
                     sign_of_heel)
             .c_str(),
         "contact of the apex",
         suction_note(wedge) + ". Ends when the part of a face that bears 99 % of its force reaches the "
                               "chine. The columns with buoyancy "
                               "add that of the body below the undisturbed level"},
        "t [s],F_x [N/m],F_y [N/m],moment [N],F_y_with_buoyancy [N/m],moment_with_buoyancy [N]");
    for (int i = 0; i <= rows; ++i) {
        const double t = end * i / rows, depth = speed * t;
        const double lift = density * gravity * area * depth * depth;
        text +=
            fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", t, wedge.force_x * force * t,
                        wedge.force_y * force * t, wedge.moment * moment * t * t,
                        wedge.force_y * force * t + lift, wedge.moment * moment * t * t + lift * arm * depth);
    }
    return text;
}

}  // namespace wetdeck
