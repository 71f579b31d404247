// SPDX-License-Identifier: BSD-3-Clause
// A floating pontoon that is heeled and let go rights itself: the period of its roll.
#include <cmath>
#include <numbers>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/linear_tank.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double gravity = 9.81, depth = 0.8, width = 3.2;      // of water and tank [m]
constexpr double beam = 0.8, side = 0.4, draught = 0.5 * side;  // of the pontoon, half as heavy as water [m]
constexpr double heel = 0.1;                                    // at the start [rad]
constexpr double body_mass = water_density * beam * draught;
constexpr double inertia = body_mass * (beam * beam + side * side) / 12;

/// The times at which a curve goes through zero.
std::vector<double> passages(const Curve& angle) {
    std::vector<double> times;
    for (std::size_t k = 1; k < angle.x.size(); ++k) {
        const double before = angle.y[k - 1], now = angle.y[k];
        if (before * now < 0)
            times.push_back(angle.x[k - 1] + (angle.x[k] - angle.x[k - 1]) * before / (before - now));
    }
    return times;
}

Simulation basin(double dx) {
    Model model = water_model(10 * std::sqrt(gravity * depth), gravity);
    model.negative_pressure = false;
    Setup setup(model, {{0, 0}, {width, depth + side}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {width, depth}});
    RigidBody body;
    body.mass = body_mass;
    body.inertia = inertia;
    body.position = {0.5 * width, depth};
    body.angle = heel;
    body.free = {false, false, true};
    const double a = 0.5 * beam, b = 0.5 * side;
    setup.put(body, {{-a, -b}, {a, -b}, {a, b}, {-a, b}});
    set_initial_pressure(setup.fluid, model,
                         [](Phase, Vec2 at) { return water_density * gravity * (depth - at.y()); });
    return setup.simulate();
}

void run(Findings& findings) {
    const LinearTank theory({depth, width, gravity, water_density}, {beam, draught}, {Mode::roll, inertia},
                            20);
    const Curve exact = theory.release(heel, 3);
    const std::vector<double> expected = passages(exact);
    const double end = 1.1 * expected.at(2), period = expected[2] - expected[0];
    VerificationFigure figure{"Roll of a pontoon let go with a heel",
                              "time over the period",
                              "-",
                              "angle over that of the start",
                              "-",
                              {},
                              {}};
    for (std::size_t k = 0; k < exact.x.size() && exact.x[k] <= end; ++k) {
        figure.exact.x.push_back(exact.x[k] / period);
        figure.exact.y.push_back(exact.y[k] / heel);
    }
    for (const double dx : findings.levels({0.02, 0.04 / 3, 0.01})) {
        Simulation simulation = basin(dx);
        Curve angle{{0}, {heel}};
        advance(simulation, end, [&](const Simulation& s) {
            angle.x.push_back(s.time());
            angle.y.push_back(s.bodies().front().angle);
        });
        const std::vector<double> found = passages(angle);
        const double error = found.size() < 3 ? 1 : std::abs((found[2] - found[0]) / period - 1);
        findings.record("roll_period", dx / draught, error);
        for (double& t : angle.x) t /= period;
        for (double& y : angle.y) y /= heel;
        figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 4) + " m", std::move(angle)});
    }
    findings.figure(std::move(figure));
    char text[200];
    std::snprintf(text, sizeof text,
                  "Theory: period %.4f s, added inertia of fast roll %.3f of the pontoon's.", period,
                  theory.added_inertia / inertia);
    findings.note(text);
}

}  // namespace

Problem roll_decay() {
    Problem problem;
    problem.name = "roll_decay";
    problem.title = "Roll of a floating body let go with a heel";
    problem.exact =
        "Linear waves and added inertia by boundary elements in the same tank: f_t = -g e, e_t = f_n on the "
        "surface, (I + a) theta'' = -rho g B T GM theta + g INT rho f_of_e (r x n) ds on the body.";
    problem.claims = {
        {"roll_period",
         "relative error of the period between the first and the third passage",
         "dx / draught",
         0.05,
         {},
         "a face misplaced by half a spacing of 0.02 m changes the waterline's moment of area, which goes "
         "with beam^3, by 4 %, and the period by half of that; the added inertia as much; compression of the "
         "water 1 %, which does not shrink: no order expected. With five spacings over the draught, 0.04 m, "
         "the roll dies before the third passage"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
