// SPDX-License-Identifier: BSD-3-Clause
// Water under air at rest for a long time: pressure on both sides, currents that should not be, the
// interface.
#include <cmath>

#include "solver/probes/front.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/numerics.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double depth = 1, gravity = 9.81;
constexpr double duration = 10, mean_from = 8;  // in sqrt(depth / gravity)

/// Gauge pressure, zero at the lid.
double exact_pressure(double y) {
    const double air = air_density * gravity * (2 * depth - std::max(y, depth));
    return air + water_density * gravity * std::max(0.0, depth - y);
}

Simulation tank(double spacing, double smoothing_ratio) {
    const double wave_speed = std::sqrt(gravity * depth);
    // sound speeds and background pressure of the dam break scene
    const double weight = water_density * gravity * depth;
    Model model = two_phase_model(10 * wave_speed, 56 * wave_speed, 0.05 * weight, gravity);
    model.smoothing_ratio = smoothing_ratio;
    Setup setup(model, {{0, 0}, {depth, 2 * depth}}, spacing, true);
    setup.fill(Phase::water, {{0, 0}, {depth, depth}});
    setup.fill(Phase::air, {{0, depth}, {depth, 2 * depth}});
    set_initial_pressure(setup.fluid, setup.model, [](Phase, Vec2 at) { return exact_pressure(at.y()); });
    return setup.simulate();
}

struct Means {
    double water_speed = 0, air_speed = 0, water_pressure = 0, air_pressure = 0, interface = 0;
    double samples = 0;

    void sample(const Simulation& s) {
        const FluidParticles& f = s.fluid();
        const auto is_water = [&](std::size_t i) { return i < f.water; };
        const auto is_air = [&](std::size_t i) { return i >= f.water; };
        const auto speed = [&](std::size_t i) { return f.state[i].velocity().norm(); };
        const auto pressure = [&](std::size_t i) {
            return f.state[i].pressure - s.model().water.eos.background_pressure -
                   exact_pressure(f.state[i].y);
        };
        water_speed += rms(f, is_water, speed);
        air_speed += rms(f, is_air, speed);
        water_pressure += rms(f, is_water, pressure);
        air_pressure += rms(f, is_air, pressure);
        double squares = 0;
        constexpr int stations = 10;
        for (int k = 0; k < stations; ++k) {
            const double error = water_depth(s, (k + 0.5) * depth / stations, depth / stations) - depth;
            squares += error * error / stations;
        }
        interface += std::sqrt(squares);
        samples += 1;
    }
};

/// Means over the last fifth of a run; the rms speed of the water over time.
Means rest(Simulation& simulation, Curve& speed) {
    const double wave_speed = std::sqrt(gravity * depth), unit = std::sqrt(depth / gravity);
    Means means;
    advance(simulation, duration * unit, [&](const Simulation& s) {
        if (s.steps() % 20 != 0) return;
        const FluidParticles& f = s.fluid();
        speed.x.push_back(s.time() / unit);
        speed.y.push_back(rms(
                              f, [&](std::size_t i) { return i < f.water; },
                              [&](std::size_t i) { return f.state[i].velocity().norm(); }) /
                          wave_speed);
        if (s.time() > mean_from * unit) means.sample(s);
    });
    return means;
}

Curve pressure_profile(const Simulation& simulation, double dx) {
    const double weight = water_density * gravity * depth;
    const double background = simulation.model().water.eos.background_pressure;
    std::vector<std::pair<double, double>> points;
    for (const FluidState& p : simulation.fluid().state) {
        if (std::abs(p.x - 0.5 * depth) < 0.6 * dx)
            points.emplace_back((p.pressure - background) / weight, p.y / depth);
    }
    return sorted_curve(points);
}

void run(Findings& findings) {
    const double wave_speed = std::sqrt(gravity * depth), weight = water_density * gravity * depth;
    VerificationFigure profile{
        "Pressure after ten times sqrt(H/g)", "pressure over rho g H", "-", "height over H", "-", {}, {}};
    for (const double y : linspace(0, 2 * depth, 101)) {
        profile.exact.x.push_back(exact_pressure(y) / weight);
        profile.exact.y.push_back(y / depth);
    }
    std::reverse(profile.exact.x.begin(), profile.exact.x.end());
    std::reverse(profile.exact.y.begin(), profile.exact.y.end());
    VerificationFigure currents{"Spurious currents in the water",
                                "time over sqrt(H/g)",
                                "-",
                                "rms speed over sqrt(g H)",
                                "-",
                                {},
                                {}};
    for (const double dx : findings.levels({0.1, 0.05, 0.025})) {
        for (const bool wide : {false, true}) {
            const double ratio = wide ? wide_smoothing_ratio : Model{}.smoothing_ratio;
            const std::string suffix = wide ? "_wide" : "";
            std::string label = "dx/H = " + std::to_string(dx / depth).substr(0, 5);
            if (wide) label += ", h = 2 dx";
            Simulation simulation = tank(dx, ratio);
            Curve speed;
            const Means means = rest(simulation, speed);
            findings.record("currents_water" + suffix, dx / depth,
                            means.water_speed / means.samples / wave_speed);
            findings.record("currents_air" + suffix, dx / depth,
                            means.air_speed / means.samples / wave_speed);
            currents.computed.push_back({label, std::move(speed)});
            if (wide) continue;
            findings.record("pressure_water", dx / depth, means.water_pressure / means.samples / weight);
            findings.record("pressure_air", dx / depth, means.air_pressure / means.samples / weight);
            findings.record("interface", dx / depth, means.interface / means.samples / dx);
            profile.computed.push_back({label, pressure_profile(simulation, dx)});
        }
    }
    findings.figure(std::move(profile));
    findings.figure(std::move(currents));
}

}  // namespace

Problem hydrostatic_tank() {
    Problem problem;
    problem.name = "hydrostatic_tank";
    problem.title = "Water under air at rest";
    problem.exact =
        "p = rho g (surface - y) in each fluid, nothing moves. Over the last fifth of ten times sqrt(H/g), "
        "about a hundred passages of sound.";
    const std::string resolution = "dx / depth H";
    const std::string no_order =
        "; no order expected at a fixed h/dx: the lattice gives way after a time that is shorter the finer "
        "it is, and what the sum over an uneven arrangement misses is proportional to the pressure, at any "
        "spacing (Quinlan, Basa and Lastiwka 2006)";
    problem.claims = {
        {"currents_water",
         "rms speed of the water over sqrt(g H)",
         resolution,
         0.1 * std::sqrt(0.1),
         {},
         "below a tenth of sqrt(g dx), what a particle gains by falling one spacing" + no_order},
        {"currents_air",
         "rms speed of the air over sqrt(g H)",
         resolution,
         std::sqrt(0.1),
         {},
         "at most sqrt(g dx): the air, a thousandth as heavy, follows every motion of the interface" +
             no_order},
        {"currents_water_wide", "the same of the water with h = 2 dx", resolution, 0.1 * std::sqrt(0.1),
         Window{0.5, 3},
         "with more neighbours the sums over an uneven arrangement are better than what is left of the fall "
         "by one spacing: order 1/2 at least"},
        {"currents_air_wide", "the same of the air with h = 2 dx", resolution, std::sqrt(0.1), Window{0.5, 3},
         "as of the water"},
        {"pressure_water",
         "rms error of the pressure in the water over rho g H",
         resolution,
         0.01,
         {},
         "the lattice's moment of the gradient (0.26 %, no refinement at fixed h/dx changes it) and the "
         "weight of what the "
         "lattice settles by, less than a tenth of a spacing; no order expected"},
        {"pressure_air", "rms error of the pressure in the air over rho g H", resolution, 0.05,
         Window{0.5, 2.5},
         "the weight of half a spacing of water, which rests on the air's outermost particles; first order"},
        {"interface",
         "rms error of the depth at ten stations over dx",
         resolution,
         0.5,
         {},
         "half a spacing"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
