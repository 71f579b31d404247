// SPDX-License-Identifier: BSD-3-Clause
// Still water in a tank that moves: the surface in a tank that is accelerated, and in one that is rolled
// slowly.
#include <cmath>
#include <numbers>

#include "solver/probes/front.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double gravity = 9.81, depth = 0.4, width = 1, height = 0.7;  // of water and tank [m]
constexpr double acceleration = 0.15 * gravity;                         // of the tank [m/s^2]
constexpr double roll = 0.12;                                           // [rad]

/// The longest wave in the tank: its half length is the width.
double sloshing_period() {
    const double k = pi / width;
    return 2 * pi / std::sqrt(gravity * k * std::tanh(k * depth));
}

/// A value that grows from 0 to `end` like a half cosine over a time.
MotionState grown(double end, double over, double time) {
    if (time >= over) return {end, 0, 0};
    const double w = pi / over;
    return {0.5 * end * (1 - std::cos(w * time)), 0.5 * end * w * std::sin(w * time),
            0.5 * end * w * w * std::cos(w * time)};
}

/// A tank whose motion begins over two periods of sloshing.
Simulation tank(double dx, bool rolls, double over) {
    Model model = water_model(10 * std::sqrt(gravity * depth), gravity);
    model.negative_pressure = false;
    Setup setup(model, {{0, 0}, {width, height}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {width, depth}});
    set_initial_pressure(setup.fluid, model,
                         [](Phase, Vec2 at) { return water_density * gravity * (depth - at.y()); });
    setup.tank_motion.centre = {0.5 * width, 0.3};
    if (rolls)
        setup.tank_motion.motion[2] = [over](double time) { return grown(roll, over, time); };
    else  // the acceleration alone matters to what is in the tank
        setup.tank_motion.motion[0] = [over](double time) {
            return MotionState{0, 0, grown(acceleration, over, time).displacement};
        };
    return setup.simulate();
}

/// The exact surface at the end over x, as seen from the tank [m].
double exact_surface(bool rolls, double x) {
    const double slope = rolls ? -std::tan(roll) : -acceleration / gravity;
    return depth + slope * (x - 0.5 * width);
}

void run(Findings& findings) {
    const double over = 2 * sloshing_period(), end = over + 2 * sloshing_period();
    for (const bool rolls : {false, true}) {
        VerificationFigure figure{
            rolls ? "Surface in a tank rolled by 0.12 rad" : "Surface in a tank accelerated by 0.15 g",
            "x over the width",
            "-",
            "depth over that at rest",
            "-",
            {{0, 1}, {exact_surface(rolls, 0) / depth, exact_surface(rolls, width) / depth}},
            {}};
        for (const double dx : findings.levels({0.04, 0.02, 0.01})) {
            Simulation simulation = tank(dx, rolls, over);
            constexpr int columns = 9;
            std::array<double, columns> sum{};
            double samples = 0;
            advance(simulation, end, [&](const Simulation& s) {
                if (s.time() < over + sloshing_period() || s.steps() % 16 != 0) return;
                samples += 1;
                for (int k = 0; k < columns; ++k)
                    sum[static_cast<std::size_t>(k)] +=
                        water_depth(s, width * (k + 0.5) / columns, width / columns);
            });
            double worst = 0;
            Curve surface;
            for (int k = 0; k < columns; ++k) {
                const double x = width * (k + 0.5) / columns;
                const double found = sum[static_cast<std::size_t>(k)] / samples;
                worst = std::max(worst, std::abs(found - exact_surface(rolls, x)));
                surface.x.push_back(x / width);
                surface.y.push_back(found / depth);
            }
            findings.record(rolls ? "rolled_surface" : "accelerated_surface", dx / depth, worst / dx);
            figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 4) + " m", std::move(surface)});
        }
        findings.figure(std::move(figure));
    }
}

}  // namespace

Problem moving_tank() {
    Problem problem;
    problem.name = "moving_tank";
    problem.title = "Still water in a tank that moves";
    problem.exact =
        "In the tank's frame the surface is a plane across the apparent gravity: its slope is -a / g under "
        "an "
        "acceleration a, and -tan(theta) at a roll theta.";
    const std::string resolution = "dx / depth";
    const std::string reason =
        "half a spacing: a surface is known no better from where particles are. What sloshing is left after "
        "a start over two periods is averaged over one period";
    problem.claims = {
        {"accelerated_surface",
         "largest error over nine columns of the mean depth in one period, in spacings",
         resolution,
         0.5,
         {},
         reason},
        {"rolled_surface", "the same after a slow roll", resolution, 0.5, {}, reason},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
