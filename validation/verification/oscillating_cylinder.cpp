// SPDX-License-Identifier: BSD-3-Clause
// A cylinder that is moved to and fro in the middle of a round tank full of water: its added mass.
#include <cmath>
#include <numbers>

#include "solver/setup/cut_cells.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double radius = 0.1, outer_radius = 0.3, amplitude = 0.005, period = 0.4;  // [m], [s]
constexpr double frequency = 2 * pi / period;
constexpr double sound_speed = 60;  // crosses the tank in a fortieth of the period

/// The middle of a closed ring of fluid that moves with small amplitude in a fixed one, Lamb, art. 103.
constexpr double added_mass = water_density * pi * radius * radius *
                              (outer_radius * outer_radius + radius * radius) /
                              (outer_radius * outer_radius - radius * radius);

Outline circle(double r, Vec2 centre, int sides) {
    Outline outline;
    const double same_area = r * std::sqrt(2 * pi / (sides * std::sin(2 * pi / sides)));
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * pi * (k + 0.5) / sides;
        outline.push_back(centre + same_area * Vec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

/// The water has cut cells along both circles, so that it fills the ring without a void, and a pressure that
/// the motion does not use up.
Simulation basin(double dx) {
    constexpr double pressure_at_rest = 1000;  // eight times what the motion makes [Pa]
    const double side = 2 * outer_radius + 0.1;
    const Vec2 middle(0.5 * side, 0.5 * side);
    Setup setup(water_model(sound_speed), {{0, 0}, {side, side}}, dx, true);
    setup.fill(Phase::water, setup.domain);
    std::vector<Outline> outlines = parts_outside(setup.domain, circle(outer_radius, middle, 96));
    outlines.push_back(circle(radius, middle, 96));
    cut_cells(setup.fluid, outlines, dx);
    set_initial_pressure(setup.fluid, setup.model, [](Phase, Vec2) { return pressure_at_rest; });
    const double support = 2 * setup.model.smoothing_ratio * dx;
    std::uint32_t number = 0;
    for (const Outline& outline : outlines) {
        RigidBody body;
        body.free = {false, false, false};
        body.position = area_moments(outline).centroid;
        if (number + 1 < outlines.size()) {
            add_solid_particles(setup.walls, number, outline, body.position, dx, support, setup.domain);
        } else {
            body.guide.motion[0] = harmonic_motion({amplitude, period, 0, period});
            add_body_particles(setup.walls, number, outline, body.position, dx, support);
        }
        setup.bodies.push_back(body);
        ++number;
    }
    return setup.simulate();
}

void run(Findings& findings) {
    VerificationFigure figure{"Force on an oscillating cylinder",
                              "time over the period",
                              "-",
                              "force over added mass times largest acceleration",
                              "-",
                              {},
                              {}};
    const double scale = added_mass * amplitude * frequency * frequency;
    for (int k = 0; k <= 200; ++k) {
        figure.exact.x.push_back(1 + k / 100.0);
        figure.exact.y.push_back(std::sin(2 * pi * figure.exact.x.back()));
    }
    for (const double dx : findings.levels({0.02, 0.01, 0.005})) {
        Simulation simulation = basin(dx);
        double in_phase = 0, squares = 0, farthest = 0, before = period;
        Curve force;
        advance(simulation, 3 * period, [&](const Simulation& s) {
            const RigidBody& body = s.bodies().back();
            const MotionState given = body.guide.motion[0](s.time());
            farthest =
                std::max(farthest, std::abs(body.position.x() - body.guide.start.x() - given.displacement));
            if (s.time() < period) return;
            const double dt = s.time() - before;
            before = s.time();
            in_phase -= dt * body.force.x() * given.acceleration;
            squares += dt * given.acceleration * given.acceleration;
            force.x.push_back(s.time() / period);
            force.y.push_back(body.force.x() / scale);
        });
        findings.record("added_mass", dx / radius, std::abs(in_phase / squares / added_mass - 1));
        findings.record("prescribed_motion", dx / radius, farthest / amplitude);
        figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 5) + " m", std::move(force)});
    }
    findings.figure(std::move(figure));
}

}  // namespace

Problem oscillating_cylinder() {
    Problem problem;
    problem.name = "oscillating_cylinder";
    problem.title = "Oscillating cylinder in a round tank";
    problem.exact =
        "Potential flow between two circles: added mass rho pi a^2 (b^2 + a^2) / (b^2 - a^2) for radii a "
        "and b.";
    const std::string resolution = "dx / radius";
    problem.claims = {
        {"added_mass",
         "relative error of the force in phase with the acceleration, over two periods",
         resolution,
         0.03,
         {},
         "the cut cells hold the areas of both circles, so that no face is misplaced by half a spacing; what "
         "stays is the sound, (2 pi b / (c period))^2 / 2, 0.3 %, and the amplitude, a twentieth of the "
         "radius: no order expected"},
        {"prescribed_motion",
         "largest departure from the given motion over its amplitude",
         resolution,
         1e-10,
         {},
         "the position follows the formula: rounding"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
