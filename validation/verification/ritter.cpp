// SPDX-License-Identifier: BSD-3-Clause
// A dam break on a long dry bed against Ritter's solution of the shallow-water equations.
#include <cmath>

#include "solver/probes/front.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double depth = 1, gravity = 9.81;
constexpr double reservoir = 5 * depth, bed = 9 * depth;
constexpr double duration = 4;  // in sqrt(depth / gravity)
constexpr double window_begin = -0.8,
                 window_end = 1.25;  // of x / (t sqrt(g H)), where vertical acceleration is small

/// Depth over the initial one at s = x / (t sqrt(g H)), the dam at 0.
double ritter_depth(double s) {
    if (s < -1) return 1;
    return s > 2 ? 0 : (2 - s) * (2 - s) / 9;
}

void run(Findings& findings) {
    const double wave_speed = std::sqrt(gravity * depth), time = duration * std::sqrt(depth / gravity);
    VerificationFigure figure{
        "Depth at t sqrt(g/H) = 4", "x over t sqrt(g H), dam at 0", "-", "depth over H", "-", {}, {}};
    for (double s = -1.25; s <= 2.2; s += 0.01) {
        figure.exact.x.push_back(s);
        figure.exact.y.push_back(ritter_depth(s));
    }
    for (const double dx : findings.levels({0.1, 0.05, 0.025})) {
        Model model = water_model(20 * wave_speed, gravity);
        model.negative_pressure = false;
        Setup setup(model, {{-reservoir, 0}, {bed, 2 * depth}}, dx, true);
        setup.fill(Phase::water, {{-reservoir, 0}, {0, depth}});
        set_initial_pressure(setup.fluid, model, [](Phase, Vec2 at) {
            return greco_pressure(water_density, gravity, depth, -at.x(), at.y());
        });
        Simulation simulation = setup.simulate();
        advance(simulation, 0.75 * time);
        const double front_before = front_position(simulation);
        advance(simulation, time);
        Curve profile;
        double squares = 0, count = 0;
        for (double s = -1.2; s <= 2.15; s += 0.05) {
            const double d = water_depth(simulation, s * time * wave_speed, 0.2 * depth) / depth;
            profile.x.push_back(s);
            profile.y.push_back(d);
            if (s < window_begin || s > window_end) continue;
            squares += std::pow(d - ritter_depth(s), 2);
            count += 1;
        }
        findings.record("profile", dx / depth, std::sqrt(squares / count));
        findings.record("dam_depth", dx / depth,
                        std::abs(water_depth(simulation, 0, 0.2 * depth) / depth / ritter_depth(0) - 1));
        const double front_speed = (front_position(simulation) - front_before) / (0.25 * time);
        findings.record("front_speed", dx / depth, std::abs(front_speed / (2 * wave_speed) - 1));
        figure.computed.push_back({"dx/H = " + std::to_string(dx).substr(0, 5), std::move(profile)});
    }
    findings.figure(std::move(figure));
    findings.note(
        "Ritter's solution has no vertical acceleration, the solver has: the difference that remains at fine "
        "spacings is the theory's, not the solver's, and no order is expected.");
}

}  // namespace

Problem ritter() {
    Problem problem;
    problem.name = "ritter";
    problem.title = "Dam break on a long dry bed (Ritter)";
    problem.exact =
        "Shallow water: h = (2 sqrt(g H) - x/t)^2 / (9 g) between the rarefaction's head and the front at 2 "
        "sqrt(g H) t.";
    const std::string resolution = "dx / initial depth";
    const std::string why =
        "shallow-water theory drops terms of second order in depth over length, (H / 12 H)^2 over the whole "
        "wave and more "
        "near its head, where the bend of the surface is smoothed over about one depth of the twelve";
    problem.claims = {
        {"profile",
         "rms error of the depth over H, where -0.8 < x / (t sqrt(g H)) < 1.25",
         resolution,
         0.04,
         {},
         why},
        {"dam_depth", "relative error of the depth at the dam, 4/9 H", resolution, 0.08, {}, why},
        {"front_speed", "relative error of the front's speed over 3 < t sqrt(g/H) < 4, 2 sqrt(g H)",
         resolution, 0.25, Window{0.3, 4},
         "a layer thinner than a quarter of a spacing does not exist: Ritter's is that thin beyond 2 - 3 "
         "sqrt(dx/4H) of "
         "x / (t sqrt(g H)), 24 % before the front at 10 spacings; order 1/2 at least"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
