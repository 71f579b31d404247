// SPDX-License-Identifier: BSD-3-Clause
// Spacings that grow away from a box: what sound, a standing wave, a vortex and water at rest make of them,
// beside what they make of equal spacings.
#include <cmath>
#include <numbers>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/numerics.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double coarsest = 4;  // largest spacing over the finest
constexpr double gravity = 9.81;

/// 0: equal spacings.
std::string suffix_of(double growth) {
    return growth == 0 ? "equal" : growth < 0.075 ? "growth_5" : "growth_10";
}

void fill(Setup& setup, double level, Box around, double growth) {
    if (growth > 0) return setup.fill_graded(level, {around, setup.particle_spacing, growth, coarsest});
    setup.fill_graded(level, {setup.domain, setup.particle_spacing, 0.05, 1});
}

const std::string long_steps = "_long_steps";

/// A pulse of sound that runs from fine particles to coarse ones, in a channel that is closed at both ends.
struct Pulse {
    static constexpr double sound_speed = 30, height = 0.12, fine = 1, length = 2.4, start = 0.5, width = 0.1,
                            end = 1.7, amplitude = 1e-4;

    Model model = water_model(sound_speed);

    double shape(double x) const { return std::exp(-std::pow((x - start) / width, 2)); }
    double scale() const { return amplitude * model.water.eos.coefficient() * model.water.eos.exponent; }

    /// @param substeps  steps of the fine particles in one of the coarse
    Simulation simulate(double dx, double growth, int substeps) const {
        Setup setup(model, {{0, 0}, {length, height}}, dx);
        setup.model.coarse_substeps = substeps;
        fill(setup, height, {{0, 0}, {fine, height}}, growth);
        set_initial_pressure(setup.fluid, model, [&](Phase, Vec2 at) { return scale() * shape(at.x()); });
        for (FluidState& p : setup.fluid.state) p.vx = p.pressure / (1000 * sound_speed);
        return setup.simulate();
    }
};

/// What a pulse leaves behind itself.
void pulses(Findings& findings) {
    const Pulse pulse;
    VerificationFigure figure{
        "Sound pulse from fine to coarse particles", "x", "m", "pressure over the pulse's", "-", {}, {}};
    const auto levels = findings.levels({1.0 / 100, 1.0 / 200, 1.0 / 400});
    for (const double dx : levels) {
        for (const auto& [growth, substeps] :
             {std::pair{0.0, 1}, std::pair{0.05, 1}, std::pair{0.1, 1}, std::pair{0.1, 3}}) {
            Simulation simulation = pulse.simulate(dx, growth, substeps);
            advance(simulation, (pulse.end - pulse.start) / pulse.sound_speed);
            double behind = 0, area = 0;
            std::vector<std::pair<double, double>> points;
            for (const FluidState& p : simulation.fluid().state) {
                const double share = p.pressure / pulse.scale();
                if (p.x < pulse.fine) behind = std::max(behind, std::abs(share));
                if (p.x > pulse.fine) area += share * p.volume / pulse.height;
                if (dx == levels.back() && std::abs(p.y - 0.5 * pulse.height) < simulation.spacing_of(p))
                    points.emplace_back(p.x, share);
            }
            const std::string name = suffix_of(growth) + (substeps > 1 ? long_steps : "");
            findings.record("reflection_" + name, dx / pulse.width, behind);
            findings.record("transmission_" + name, dx / pulse.width,
                            std::abs(area / (pulse.width * std::sqrt(pi)) - 1));
            if (dx == levels.back()) figure.computed.push_back({name, sorted_curve(points)});
        }
    }
    for (const double x : linspace(0, pulse.length, 241)) {
        figure.exact.x.push_back(x);
        figure.exact.y.push_back(pulse.shape(x - (pulse.end - pulse.start)));
    }
    findings.figure(std::move(figure));
}

/// A standing wave in water alone: frequency by linear theory.
double wave_frequency_error(double dx, double growth) {
    constexpr double width = 1, depth = 0.5, k = pi / width, steepness = 0.06, periods = 2;
    const double omega = std::sqrt(gravity * k * std::tanh(k * depth));
    Model model = water_model(10 * std::sqrt(gravity * depth), gravity);
    model.negative_pressure = false;
    Setup setup(model, {{0, 0}, {width, 2 * depth}}, dx);
    fill(setup, depth, {{0.4, depth - 0.1}, {0.6, depth + 0.1}}, growth);
    set_initial_pressure(setup.fluid, model,
                         [&](Phase, Vec2 at) { return 1000 * gravity * (depth - at.y()); });
    const auto mode = [&](Vec2 at) -> Vec2 {
        return Vec2(-std::sin(k * at.x()) * std::cosh(k * at.y()),
                    std::cos(k * at.x()) * std::sinh(k * at.y())) /
               std::sinh(k * depth);
    };
    for (FluidState& p : setup.fluid.state) {
        const Vec2 v = steepness / k * omega * mode(p.position());
        p.vx = v.x();
        p.vy = v.y();
    }
    Simulation simulation = setup.simulate();
    std::vector<double> crossings;
    double before = 1, time = 0;
    advance(simulation, periods * 2 * pi / omega, [&](const Simulation& s) {
        double product = 0;
        for (std::size_t i = 0; i < s.fluid().size(); ++i)
            product +=
                s.fluid().mass[i] * mode(s.fluid().state[i].position()).dot(s.fluid().state[i].velocity());
        if (before * product < 0) crossings.push_back(time + (s.time() - time) * before / (before - product));
        before = product;
        time = s.time();
    });
    if (crossings.size() < 3) return 1;
    const double found =
        pi * (static_cast<double>(crossings.size()) - 1) / (crossings.back() - crossings.front());
    return std::abs(found / omega - 1);
}

/// Rate of decay of a Taylor-Green vortex in a free-slip box, until half of its energy is left.
double vortex_decay_error(double dx, double growth) {
    constexpr double side = 1, speed = 1, k = pi / side, viscosity = 0.1, duration = 0.2;
    Model model = water_model(20 * speed);
    model.water.eos.background_pressure = water_density * speed * speed;
    model.viscosity = Viscosity::symmetric;
    model.water.viscosity = viscosity * water_density;
    model.dissipation = Dissipation::none;
    model.wall_dissipation = 0;
    Setup setup(model, {{0, 0}, {side, side}}, dx);
    fill(setup, side, {{0.4, 0.4}, {0.6, 0.6}}, growth);
    set_initial_pressure(setup.fluid, model, [&](Phase, Vec2 at) {
        return 0.25 * water_density * speed * speed * (std::cos(2 * k * at.x()) + std::cos(2 * k * at.y()));
    });
    for (FluidState& p : setup.fluid.state) {
        p.vx = speed * std::sin(k * p.x) * std::cos(k * p.y);
        p.vy = -speed * std::cos(k * p.x) * std::sin(k * p.y);
    }
    Simulation simulation = setup.simulate();
    const auto energy = [&] {
        double sum = 0;
        const FluidParticles& f = simulation.fluid();
        for (std::size_t i = 0; i < f.size(); ++i) sum += f.mass[i] * f.state[i].velocity().squaredNorm();
        return sum;
    };
    const double start = energy();
    advance(simulation, duration * side / speed);
    const double rate = -std::log(energy() / start) / (2 * simulation.time());
    return std::abs(rate / (2 * viscosity * k * k) - 1);
}

/// Water at rest: rms pressure error over the head, and rms speed over sqrt(g H), after some passages of
/// sound.
std::pair<double, double> rest(double dx, double growth) {
    constexpr double depth = 1, width = 1.6, duration = 1;
    Model model = water_model(10 * std::sqrt(gravity * depth), gravity);
    Setup setup(model, {{0, 0}, {width, 1.5 * depth}}, dx);
    fill(setup, depth, {{0.6, 0.8}, {1.0, 1.1}}, growth);
    const auto exact = [](Vec2 at) { return 1000 * gravity * (depth - at.y()); };
    set_initial_pressure(setup.fluid, model, [&](Phase, Vec2 at) { return exact(at); });
    Simulation simulation = setup.simulate();
    const double unit = std::sqrt(depth / gravity);
    double pressure = 0, speed = 0, samples = 0;
    advance(simulation, duration * unit, [&](const Simulation& s) {
        if (s.time() < 0.5 * duration * unit || s.steps() % 20 != 0) return;
        double squares = 0, motion = 0, mass = 0;
        for (std::size_t i = 0; i < s.fluid().size(); ++i) {
            const FluidState& p = s.fluid().state[i];
            squares += s.fluid().mass[i] * std::pow(p.pressure - exact(p.position()), 2);
            motion += s.fluid().mass[i] * p.velocity().squaredNorm();
            mass += s.fluid().mass[i];
        }
        pressure += std::sqrt(squares / mass);
        speed += std::sqrt(motion / mass);
        samples += 1;
    });
    return {pressure / samples / (1000 * gravity * depth), speed / samples / std::sqrt(gravity * depth)};
}

void run(Findings& findings) {
    pulses(findings);
    for (const double growth : {0.0, 0.05, 0.1}) {
        const std::string name = suffix_of(growth);
        for (const double dx : findings.levels({1.0 / 40, 1.0 / 80, 1.0 / 160})) {
            findings.record("frequency_" + name, dx, wave_frequency_error(dx, growth));
            findings.record("decay_" + name, dx, vortex_decay_error(dx, growth));
            const auto [pressure, speed] = rest(dx, growth);
            findings.record("pressure_" + name, dx, pressure);
            findings.record("currents_" + name, dx, speed);
        }
    }
}

}  // namespace

Problem graded_spacing() {
    Problem problem;
    problem.name = "graded_spacing";
    problem.title = "Spacings that grow away from a box";
    problem.exact =
        "Sound, a standing wave, a Taylor-Green vortex and water at rest, each as if all spacings were "
        "equal: in one "
        "water nothing is reflected. The finest spacing is dx, the coarsest four times that.";
    const std::string pulse = "dx / half width of the pulse", side = "dx / width of the tank";
    const std::string no_order = "; no order expected where the coarsest particles are four times as large";
    for (const auto& [growth, words] :
         {std::pair{0.0, "equal spacings"}, {0.05, "5 % a spacing"}, {0.1, "10 % a spacing"}}) {
        const std::string name = suffix_of(growth), of = std::string(", ") + words;
        const auto claim = [&](const char* quantity, const std::string& meaning,
                               const std::string& resolution, double bound, const std::string& reason,
                               const std::string& kind = "") {
            problem.claims.push_back(
                {quantity + name + kind, meaning + of, resolution, bound, {}, reason + no_order});
        };
        const double reflection = growth == 0 ? 0.01 : growth < 0.075 ? 0.02 : 0.05;
        const std::string what_reflects =
            growth == 0 ? "what diffusion and the walls of the channel leave behind"
                        : "less than the scatter of a slam's peak among arrangements of the particles";
        const std::string what_slows =
            "walls take up to half the divergence in a strip of one smoothing length, 6 % of the sound speed "
            "at 12 spacings across";
        const std::string behind = "largest pressure that a pulse leaves behind over its own",
                          ahead = "relative error of the area of the pulse that goes on";
        claim("reflection_", behind, pulse, reflection, what_reflects);
        claim("transmission_", ahead, pulse, 0.06, what_slows);
        if (growth == 0.1) {
            const std::string slow = ", longer steps of the coarse particles";
            claim("reflection_", behind + slow, pulse, reflection, what_reflects, long_steps);
            claim("transmission_", ahead + slow, pulse, 0.06, what_slows, long_steps);
        }
        claim("frequency_", "relative error of the frequency of a standing wave", side, 0.04,
              "that of equal spacings four times as large, first order: 1 % at 40 spacings across");
        claim("decay_", "relative error of the decay of a vortex until half its energy is left", side, 0.15,
              "the moment of a lattice that the vortex has turned about, 12 % with equal spacings");
        claim("pressure_", "rms error of the pressure of water at rest over rho g H", side, 0.015,
              "the moment of the lattice and the weight of what it settles by, as in hydrostatic_tank, and "
              "sound that "
              "is on its way to rest");
        claim("currents_", "rms speed of water at rest over sqrt(g H)", side, 0.01,
              "a tenth of sqrt(g dx) at 100 spacings");
    }
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
