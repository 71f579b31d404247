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

Simulation tank(double spacing) {
    const double wave_speed = std::sqrt(gravity * depth);
    // sound speeds and background pressure of the dam break scene
    const double weight = water_density * gravity * depth;
    Setup setup(two_phase_model(10 * wave_speed, 56 * wave_speed, 0.05 * weight, gravity),
                {{0, 0}, {depth, 2 * depth}}, spacing, true);
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

void run(Findings& findings) {
    const double wave_speed = std::sqrt(gravity * depth), weight = water_density * gravity * depth;
    const double unit = std::sqrt(depth / gravity);
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
        Simulation simulation = tank(dx);
        Means means;
        Curve speed;
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
        findings.record("currents_water", dx / depth, means.water_speed / means.samples / wave_speed);
        findings.record("currents_air", dx / depth, means.air_speed / means.samples / wave_speed);
        findings.record("pressure_water", dx / depth, means.water_pressure / means.samples / weight);
        findings.record("pressure_air", dx / depth, means.air_pressure / means.samples / weight);
        findings.record("interface", dx / depth, means.interface / means.samples / dx);
        const std::string label = "dx/H = " + std::to_string(dx / depth).substr(0, 5);
        std::vector<std::pair<double, double>> points;
        for (const FluidState& p : simulation.fluid().state) {
            if (std::abs(p.x - 0.5 * depth) < 0.6 * dx)
                points.emplace_back((p.pressure - 0.05 * weight) / weight, p.y / depth);
        }
        profile.computed.push_back({label, sorted_curve(points)});
        currents.computed.push_back({label, speed});
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
    const std::string no_decay =
        "The currents do not fall with the spacing. The lattice, on which nothing moves, gives way after a "
        "time that is "
        "shorter the finer it is (4 sqrt(H/g) at 20 spacings, 2.5 at 40; never at 10), and the particles "
        "rearrange with an rms speed of "
        "0.0045 sqrt(g H) at either spacing, which then decays slowly.";
    problem.claims = {
        {"currents_water", "rms speed of the water over sqrt(g H)", resolution, 0.1 * std::sqrt(0.1),
         Window{0.5, 3},
         "below a tenth of sqrt(g dx), what a particle gains by falling one spacing: order 1/2 at least",
         no_decay},
        {"currents_air", "rms speed of the air over sqrt(g H)", resolution, std::sqrt(0.1), Window{0.5, 3},
         "at most sqrt(g dx): the air, a thousandth as heavy, follows every motion of the interface; order "
         "1/2 at least",
         no_decay},
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
