// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies: free fall and rotation away from any fluid, and Archimedes' force and draught in still water.
#include <cmath>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double gravity = 9.81, depth = 0.8, width = 2, beam = 0.8,
                 side = 0.4;            // of water and tank; of the body [m]
constexpr double draught = 0.5 * side;  // the body is half as heavy as water
const Outline pontoon = {{-0.5 * beam, -0.5 * side},
                         {0.5 * beam, -0.5 * side},
                         {0.5 * beam, 0.5 * side},
                         {-0.5 * beam, 0.5 * side}};

RigidBody half_as_heavy() {
    RigidBody body;
    body.mass = 0.5 * water_density * beam * side;
    body.inertia = body.mass * (beam * beam + side * side) / 12;
    return body;
}

/// A body thrown far from a puddle that falls with it.
void fly(Findings& findings) {
    const double dx = 0.05, duration = 0.5;
    Setup setup(water_model(30, gravity), {{-4, -4}, {4, 4}}, dx, false);
    setup.fill(Phase::water, {{3, 3}, {3.2, 3.2}});
    RigidBody body = half_as_heavy();
    body.velocity = {0.7, 1.1};
    body.angular_velocity = 3;
    setup.put(body, pontoon);
    Simulation simulation = setup.simulate();
    advance(simulation, duration);
    const RigidBody& end = simulation.bodies().front();
    const Vec2 exact(0.7 * duration, 1.1 * duration - 0.5 * gravity * duration * duration);
    findings.record("free_fall", 1, (end.position - exact).norm() / exact.norm());
    findings.record("free_rotation", 1, std::abs(end.angle / (3 * duration) - 1));
}

Simulation basin(double dx, bool held) {
    Model model = water_model(10 * std::sqrt(gravity * depth), gravity);
    model.negative_pressure = false;
    Setup setup(model, {{0, 0}, {width, depth + side}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {width, depth}});
    RigidBody body = half_as_heavy();
    body.position = {0.5 * width, depth};
    body.free = {!held, !held, !held};
    setup.put(body, pontoon);
    set_initial_pressure(setup.fluid, model,
                         [](Phase, Vec2 at) { return water_density * gravity * (depth - at.y()); });
    return setup.simulate();
}

void at_rest(Findings& findings) {
    const double duration = 5 * std::sqrt(depth / gravity);
    const double buoyancy = water_density * gravity * beam * draught;
    VerificationFigure figure{"Pontoon floating at half its height",
                              "time over sqrt(H/g)",
                              "-",
                              "height over that of rest, over the draught",
                              "-",
                              {{0, 5}, {0, 0}},
                              {}};
    for (const double dx : findings.levels({0.04, 0.02, 0.01})) {
        Simulation held = basin(dx, true);
        Vec2 impulse = Vec2::Zero();
        advance(held, duration, [&](const Simulation& s) {
            if (s.time() < 0.5 * duration) impulse = s.bodies().front().impulse;
        });
        const Vec2 force = (held.bodies().front().impulse - impulse) / (0.5 * duration);
        findings.record("buoyancy", dx / side, std::abs(force.y() / buoyancy - 1));
        findings.record("side_force", dx / side, std::abs(force.x() / buoyancy));
        Simulation afloat = basin(dx, false);
        Curve height;
        double sum = 0, samples = 0;
        advance(afloat, duration, [&](const Simulation& s) {
            const double y = s.bodies().front().position.y() - depth;
            height.x.push_back(s.time() / std::sqrt(depth / gravity));
            height.y.push_back(y / draught);
            if (s.time() < 0.5 * duration) return;
            sum += y;
            samples += 1;
        });
        findings.record("draught", dx / side, std::abs(sum / samples) / dx);
        findings.record("upright", dx / side, std::abs(afloat.bodies().front().angle));
        figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 5) + " m", std::move(height)});
    }
    findings.figure(std::move(figure));
}

}  // namespace

Problem free_flight() {
    Problem problem;
    problem.name = "free_flight";
    problem.title = "Free fall and rotation of a body";
    problem.exact = "Parabola and even rotation without fluid.";
    problem.claims = {
        {"free_fall",
         "distance from the parabola over the way, half a second",
         "none",
         1e-11,
         {},
         "the integrator is exact for even acceleration: rounding of some hundred steps"},
        {"free_rotation", "relative error of the angle of free rotation", "none", 1e-11, {}, "rounding"},
    };
    problem.run = fly;
    return problem;
}

Problem floating_body() {
    Problem problem;
    problem.name = "floating_body";
    problem.title = "Floating body";
    problem.exact =
        "Archimedes: a pontoon half as heavy as water floats at half its height, and held there feels its "
        "displaced weight.";
    const std::string resolution = "dx / height of the body";
    problem.claims = {
        {"buoyancy",
         "relative error of the mean force on the held body",
         resolution,
         0.02,
         {},
         "a tenth of what half a spacing of displaced water all round would add, 15 %: the faces lie where "
         "the "
         "lattice says. No order is claimed: what is left is the mean of waves that die slowly"},
        {"side_force",
         "mean sideways force over the buoyancy",
         resolution,
         0.02,
         {},
         "the set-up is symmetric but for the order of sums; what the waves of disorder leave"},
        {"draught",
         "error of the mean height afloat over dx",
         resolution,
         0.75,
         {},
         "three quarters of a spacing: half of one at the bottom, and the sides"},
        {"upright",
         "angle afloat at the end [rad]",
         resolution,
         0.02,
         {},
         "metacentric height beam^2 / (12 draught) - side / 4 = 0.17 m: it rights itself; a spacing of 0.04 "
         "m over the beam would be 0.05"},
    };
    problem.run = at_rest;
    return problem;
}

}  // namespace wetdeck::verification
