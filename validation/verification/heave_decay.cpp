// SPDX-License-Identifier: BSD-3-Clause
// A pontoon lifted out of its equilibrium and let go: frequency and decay of its heave.
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
constexpr double lift = 0.2 * draught;
constexpr double body_mass = water_density * beam * draught;
/// The lifted pontoon leaves room that the water fills when it comes down: the level at which both rest.
constexpr double rest = lift * beam / width;

/// Over one period, from the first passage through the rest position to the third.
struct Oscillation {
    double frequency = 0, decrement = 0, trough = 0, end = 0;

    explicit Oscillation(const Curve& height) {
        std::vector<double> passage, extreme;
        double farthest = height.y[0] - rest;
        for (std::size_t k = 1; k < height.x.size() && passage.size() < 3; ++k) {
            const double before = height.y[k - 1] - rest, now = height.y[k] - rest;
            farthest = std::max(farthest, std::abs(now));
            if (before * now > 0) continue;
            passage.push_back(height.x[k - 1] + (height.x[k] - height.x[k - 1]) * before / (before - now));
            extreme.push_back(farthest);
            farthest = 0;
        }
        if (passage.size() < 3) return;
        end = passage[2];
        frequency = 2 * pi / (passage[2] - passage[0]);
        trough = extreme[1] / extreme[0];
        decrement = std::log(extreme[1] / extreme[2]);
    }
};

Simulation basin(double dx) {
    Model model = water_model(10 * std::sqrt(gravity * depth), gravity);
    model.negative_pressure = false;
    Setup setup(model, {{0, 0}, {width, depth + side}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {width, depth}});
    RigidBody body;
    body.mass = body_mass;
    body.inertia = body_mass * (beam * beam + side * side) / 12;
    body.position = {0.5 * width, depth + lift};
    body.free = {false, true, false};
    const double a = 0.5 * beam, b = 0.5 * side;
    const Outline pontoon = {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
    setup.put(body, pontoon);
    set_initial_pressure(setup.fluid, model,
                         [](Phase, Vec2 at) { return water_density * gravity * (depth - at.y()); });
    return setup.simulate();
}

/// The pontoon at the level of the start, heaving.
LinearTank linear_tank(int cells) {
    return LinearTank({depth, width, gravity, water_density}, {beam, draught}, {Mode::heave, body_mass},
                      cells);
}

void run(Findings& findings) {
    const LinearTank theory = linear_tank(20);
    const Curve exact = theory.release(lift, 3);
    const Oscillation expected(exact);
    VerificationFigure figure{"Heave of a pontoon let go above its rest",
                              "time over the period",
                              "-",
                              "height above rest, over that of the start",
                              "-",
                              {},
                              {}};
    const double period = 2 * pi / expected.frequency;
    const auto normal = [&](Curve curve) {
        for (double& t : curve.x) t /= period;
        for (double& y : curve.y) y = (y - rest) / (lift - rest);
        return curve;
    };
    for (std::size_t k = 0; k < exact.x.size() && exact.x[k] <= 1.05 * expected.end; ++k) {
        figure.exact.x.push_back(exact.x[k]);
        figure.exact.y.push_back(exact.y[k]);
    }
    figure.exact = normal(figure.exact);
    for (const double dx : findings.levels({0.04, 0.02, 0.01})) {
        Simulation simulation = basin(dx);
        Curve height{{0}, {lift}};
        advance(simulation, 1.05 * expected.end, [&](const Simulation& s) {
            height.x.push_back(s.time());
            height.y.push_back(s.bodies().front().position.y() - depth);
        });
        const Oscillation found(height);
        findings.record("heave_frequency", dx / draught, std::abs(found.frequency / expected.frequency - 1));
        findings.record("heave_decrement", dx / draught, std::abs(found.decrement - expected.decrement));
        findings.record("heave_trough", dx / draught, std::abs(found.trough - expected.trough));
        double squares = 0;
        std::size_t k = 0;
        for (std::size_t n = 0; n < height.x.size(); ++n) {
            while (k + 2 < exact.x.size() && exact.x[k + 1] < height.x[n]) ++k;
            const double share = (height.x[n] - exact.x[k]) / (exact.x[k + 1] - exact.x[k]);
            squares += std::pow(height.y[n] - std::lerp(exact.y[k], exact.y[k + 1], share), 2);
        }
        findings.record("heave_curve", dx / draught,
                        std::sqrt(squares / static_cast<double>(height.x.size())) / (lift - rest));
        figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 5) + " m", normal(height)});
    }
    findings.figure(std::move(figure));
    const LinearTank coarse = linear_tank(10);
    const Oscillation other(coarse.release(lift, 3));
    char text[300];
    std::snprintf(text, sizeof text,
                  "Theory: period %.4f s, logarithmic decrement %.4f over half a period, added mass of fast "
                  "heave %.3f of the pontoon's; with panels twice as long %.4f s, %.4f, %.3f.",
                  period, expected.decrement, theory.added_inertia / body_mass, 2 * pi / other.frequency,
                  other.decrement, coarse.added_inertia / body_mass);
    findings.note(text);
}

}  // namespace

Problem heave_decay() {
    Problem problem;
    problem.name = "heave_decay";
    problem.title = "Heave of a floating body let go";
    problem.exact =
        "Linear waves and added mass by boundary elements in the same tank: f_t = -g e, e_t = f_n on the "
        "surface, (m + a) y'' = -rho g beam y + g INT rho f_of_e n_y ds on the body.";
    const std::string resolution = "dx / draught";
    // half a spacing of draught against the draught and the added mass's own depth, pi beam / 8
    const double misplaced = 0.5 * 0.5 * 0.04 / (draught + pi * beam / 8);
    constexpr double compressed = 0.01, finite = 0.01;
    problem.claims = {
        {"heave_frequency",
         "relative error of the frequency over one period",
         resolution,
         misplaced + compressed + finite,
         {},
         "a face misplaced by half a spacing, 2 % of the root of the moving mass; compression of the water, "
         "half of (omega beam / c)^2, 1 %; a lift of a fifth of the draught, (lift / draught)^2 / 4, 1 %. "
         "The "
         "last two stay: no order expected"},
        {"heave_decrement", "error of the logarithmic decrement over half a period", resolution, 0.14,
         Window{0.5, 2.5},
         "half of what radiation takes, 0.27: with more the scheme's damping could not be told from it. "
         "Dissipation "
         "about the pontoon acts in a strip of one smoothing length: first order",
         "0.15, 0.072 and 0.035 at 40, 20 and 10 mm, order 1.1; 0.125 and 0.050 at the first two before the "
         "density of water was bounded by its cover. Why is not known."},
        {"heave_trough", "error of the depth of the first trough over the height of the start", resolution,
         0.1, Window{0.5, 2.5}, "the decrement's bound, in amplitude; first order",
         "The first trough is 0.66, 0.71 and 0.76 of the start at 40, 20 and 10 mm instead of 0.90, with an "
         "order of 0.4. Neither lift (0.1 to 0.4 of the draught), sound speed nor dissipation changes it by "
         "more than 0.02; the arrangement of the particles does (at 40 mm by 0.06 with particles shaken by a "
         "tenth of a spacing or at h = 1.7 dx instead of 1.5): the lattice of the start seems to resist "
         "shear before it gives way."},
        {"heave_curve",
         "rms difference of the height over the height of the start, until 1.05 of the third passage",
         resolution,
         0.15,
         {},
         "the frequency's bound makes a phase of 0.04 times 2.5 pi at the end, 0.3, of an amplitude that has "
         "fallen to half; what stays of the frequency stays here"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
