// SPDX-License-Identifier: BSD-3-Clause
// A standing gravity wave of small amplitude in a tank, with air above and without.
#include <cmath>
#include <numbers>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double width = 1, depth = 0.5, gravity = 9.81, wave_number = pi / width;
constexpr double steepness =
    0.06;  // amplitude times wave number: the frequency of theory then falls by (0.06)^2 / 4, 0.1 %
constexpr double periods = 3;
constexpr double viscous_share = 0.03;  // 2 nu k^2 over the frequency

double frequency(bool with_air) {
    const double c = 1 / std::tanh(wave_number * depth);
    const double air = with_air ? air_density : 0;
    return std::sqrt(gravity * wave_number * (water_density - air) / ((water_density + air) * c));
}

/// Velocity of the mode over that of the crest.
Vec2 mode(Phase phase, Vec2 at) {
    const double k = wave_number, scale = 1 / std::sinh(k * depth);
    const double c = std::cos(k * at.x()), s = std::sin(k * at.x());
    if (phase == Phase::water) return {-s * std::cosh(k * at.y()) * scale, c * std::sinh(k * at.y()) * scale};
    const double below_lid = k * (2 * depth - at.y());
    return {s * std::cosh(below_lid) * scale, c * std::sinh(below_lid) * scale};
}

Simulation tank(bool with_air, double viscosity, double smoothing_ratio, double dx) {
    const double wave_speed = std::sqrt(gravity * depth), weight = water_density * gravity * depth;
    Model model = with_air ? two_phase_model(10 * wave_speed, 56 * wave_speed, 0.05 * weight, gravity)
                           : water_model(10 * wave_speed, gravity);
    model.negative_pressure = with_air;
    model.smoothing_ratio = smoothing_ratio;
    if (viscosity > 0) {
        model.viscosity = Viscosity::symmetric;
        model.water.viscosity = viscosity * water_density;
    }
    Setup setup(model, {{0, 0}, {width, 2 * depth}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {width, depth}});
    if (with_air) setup.fill(Phase::air, {{0, depth}, {width, 2 * depth}});
    const double air = with_air ? air_density : 0;
    set_initial_pressure(setup.fluid, model, [&](Phase, Vec2 at) {
        return air * gravity * (2 * depth - std::max(at.y(), depth)) +
               water_density * gravity * std::max(0.0, depth - at.y());
    });
    const double crest_speed = steepness / wave_number * frequency(with_air);
    for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
        FluidState& p = setup.fluid.state[i];
        const Vec2 v = crest_speed * mode(setup.fluid.phase(i), p.position());
        p.vx = v.x();
        p.vy = v.y();
    }
    return setup.simulate();
}

struct Oscillation {
    double frequency = 0, decay = 0;  // [1/s]
    Curve amplitude;
};

/// Frequency from the first to the last passage through zero, decay from the extremes.
Oscillation oscillate(Simulation simulation, double expected_frequency, double crest_speed) {
    Oscillation result;
    Curve& q = result.amplitude;
    advance(simulation, periods * 2 * pi / expected_frequency, [&](const Simulation& s) {
        const FluidParticles& f = s.fluid();
        double product = 0, square = 0;
        for (std::size_t i = 0; i < f.water; ++i) {
            const Vec2 m = mode(Phase::water, f.state[i].position());
            product += f.mass[i] * m.dot(f.state[i].velocity());
            square += f.mass[i] * m.squaredNorm();
        }
        q.x.push_back(s.time());
        q.y.push_back(product / square / crest_speed);
    });
    std::vector<double> crossing;
    // extremes between crossings: one per half period
    std::vector<std::pair<double, double>> extreme;
    for (std::size_t k = 1; k < q.x.size(); ++k) {
        if (q.y[k - 1] * q.y[k] < 0) {
            crossing.push_back(q.x[k - 1] + (q.x[k] - q.x[k - 1]) * q.y[k - 1] / (q.y[k - 1] - q.y[k]));
            extreme.emplace_back(0, 0);
        }
        if (!crossing.empty() && std::abs(q.y[k]) > extreme.back().second)
            extreme.back() = {q.x[k], std::abs(q.y[k])};
    }
    const auto n = static_cast<double>(crossing.size());
    if (n < 3) return result;
    result.frequency = pi * (n - 1) / (crossing.back() - crossing.front());
    extreme.pop_back();  // the last may be cut off by the end
    result.decay = std::log(extreme.front().second / extreme.back().second) /
                   (extreme.back().first - extreme.front().first);
    return result;
}

void run(Findings& findings) {
    for (const bool with_air : {false, true}) {
        const std::string name = with_air ? "two_phase" : "single_phase";
        const double omega = frequency(with_air), crest_speed = steepness / wave_number * omega;
        VerificationFigure figure{with_air ? "Standing wave, water and air" : "Standing wave, water alone",
                                  "time over the period",
                                  "-",
                                  "amplitude of the mode over its start",
                                  "-",
                                  {},
                                  {}};
        for (double t = 0; t <= periods; t += 0.01) {
            figure.exact.x.push_back(t);
            figure.exact.y.push_back(std::cos(2 * pi * t));
        }
        for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
            Oscillation inviscid =
                oscillate(tank(with_air, 0, Model{}.smoothing_ratio, dx), omega, crest_speed);
            findings.record("frequency_" + name, dx / width, std::abs(inviscid.frequency / omega - 1));
            findings.record("decay_" + name, dx / width, std::abs(inviscid.decay) / omega);
            for (double& t : inviscid.amplitude.x) t *= omega / (2 * pi);
            figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 6) + " m", inviscid.amplitude});
            if (with_air) continue;
            const Oscillation wide = oscillate(tank(false, 0, wide_smoothing_ratio, dx), omega, crest_speed);
            findings.record("decay_wide", dx / width, std::abs(wide.decay) / omega);
            const double viscosity = 0.5 * viscous_share * omega / (wave_number * wave_number);
            const Oscillation viscous =
                oscillate(tank(false, viscosity, Model{}.smoothing_ratio, dx), omega, crest_speed);
            findings.record("viscous_decay", dx / width,
                            std::abs((viscous.decay - inviscid.decay) / (viscous_share * omega) - 1));
        }
        findings.figure(std::move(figure));
    }
}

}  // namespace

Problem gravity_wave() {
    Problem problem;
    problem.name = "gravity_wave";
    problem.quick = false;
    problem.title = "Standing gravity wave";
    problem.exact =
        "Linear theory: omega^2 = g k (rho_w - rho_a) / (rho_w coth(k h_w) + rho_a coth(k h_a)); no decay "
        "without "
        "viscosity, exp(-2 nu k^2 t) with it.";
    const std::string resolution = "dx / width of the tank";
    for (const char* name : {"single_phase", "two_phase"}) {
        problem.claims.push_back(
            {std::string("frequency_") + name,
             "relative error of the frequency over three periods",
             resolution,
             0.025,
             {},
             "the surface misplaced by half a spacing, against which the frequency is insensitive "
             "(d(omega)/omega = "
             "k dx / 2 / sinh(2 k h) = 0.7 % at 20 spacings), the water's compression, (omega / (c k))^2 = "
             "0.6 %, the interface spread over one smoothing length, and 0.1 % "
             "of finite amplitude; no order expected of a sum of small terms"});
        problem.claims.push_back(
            {std::string("decay_") + name,
             "rate of decay without viscosity over the frequency",
             resolution,
             0.02,
             {},
             "diffusion of the dynamic pressure costs about D k^2 (omega / (c k))^2 / omega, below 0.1 %; "
             "the limited dissipation about as much; dissipation of a scheme of first order is bounded by 2 "
             "%. No order expected at a fixed h/dx: an arrangement under pressure resists shear by a share "
             "of the pressure, at any spacing, until it gives way; the smaller the wave, the more that "
             "costs"});
    }
    problem.claims.push_back({"decay_wide", "rate of decay of water alone over the frequency, with h = 2 dx",
                              resolution, 0.02, Window{0.5, 2.5},
                              "with more neighbours the arrangement hardly resists; first order"});
    problem.claims.push_back({"viscous_decay",
                              "relative error of the decay that viscosity adds, 2 nu k^2",
                              resolution,
                              0.3,
                              {},
                              "the moment of the lattice, 6.4 %, which stays, and the strips of one "
                              "smoothing length along two walls and bed "
                              "without viscous force, 4 h / side, half felt: 15 to 25 % at 20 spacings"});
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
