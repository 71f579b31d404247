// SPDX-License-Identifier: BSD-3-Clause
// The solver's intermediate states against the exact Riemann problem, and the symmetries they must have.
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/passes/pair_passes.hpp"
#include "solver/physics/riemann.hpp"
#include "validation/verification/exact_riemann.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double water_sound_speed = 30, air_sound_speed = 90;

Model riemann_model() {
    Model model = two_phase_model(water_sound_speed, air_sound_speed, 0);
    model.dissipation = Dissipation::riemann;  // the limiter makes the dissipation low on purpose
    return model;
}

const TaitEquationOfState& eos_of(const Model& model, Phase phase) {
    return phase == Phase::water ? model.water.eos : model.air.eos;
}

struct State {
    Phase phase = Phase::water;
    double velocity = 0, pressure = 0;
};

/// u* and P* by the formulas and coefficients of the pair loop.
Contact solver_contact(const Model& model, const State& left, const State& right) {
    const PairCoefficients c = pair_coefficients(model, left.phase, right.phase, 1);
    const double jump = left.velocity - right.velocity;
    Contact contact;
    contact.velocity = left.velocity - velocity_left_less_star(jump, left.pressure - right.pressure,
                                                               c.weight_right, c.mobility);
    contact.pressure =
        weighted_pressure(left.pressure, right.pressure, c.pressure_weight_left, c.pressure_weight_right) +
        riemann_dissipation(jump, c.limiter);
    return contact;
}

void against_exact(Findings& findings) {
    const Model model = riemann_model();
    struct Pair {
        const char* name;
        Phase left, right;
    };
    const Pair pairs[] = {{"water_water", Phase::water, Phase::water},
                          {"air_air", Phase::air, Phase::air},
                          {"water_air", Phase::water, Phase::air}};
    for (const Pair& pair : pairs) {
        VerificationFigure figure{std::string("Contact pressure, ") + pair.name,
                                  "amplitude du / c",
                                  "-",
                                  "P* over Z du",
                                  "-",
                                  {},
                                  {}};
        Curve computed;
        const TaitEquationOfState &a = eos_of(model, pair.left), &b = eos_of(model, pair.right);
        const double softest = std::min(a.coefficient() * a.exponent, b.coefficient() * b.exponent);
        const double slowest =
            std::min(a.sound_speed * a.reference_density, b.sound_speed * b.reference_density);
        for (const double amplitude : {0.04, 0.02, 0.01, 0.005}) {
            // both sides move and are compressed, by an amplitude of the softer one
            const double du = amplitude * softest / slowest;
            const State left{pair.left, 0.7 * du, 0.3 * amplitude * softest};
            const State right{pair.right, -0.3 * du, -0.2 * amplitude * softest};
            const Contact exact = exact_contact({a, a.density(left.pressure), left.velocity},
                                                {b, b.density(right.pressure), right.velocity});
            const Contact mine = solver_contact(model, left, right);
            const double scale = amplitude * softest;
            findings.record(std::string(pair.name) + "_pressure", amplitude,
                            std::abs(mine.pressure - exact.pressure) / (amplitude * softest));
            findings.record(std::string(pair.name) + "_velocity", amplitude,
                            std::abs(mine.velocity - exact.velocity) / du);
            figure.exact.x.insert(figure.exact.x.begin(), amplitude);
            figure.exact.y.insert(figure.exact.y.begin(), exact.pressure / scale);
            computed.x.insert(computed.x.begin(), amplitude);
            computed.y.insert(computed.y.begin(), mine.pressure / scale);
        }
        figure.computed.push_back({"linearised, of the pair loop", computed});
        findings.figure(std::move(figure));
    }
}

/// Largest breach over random pairs of states, over the sizes of the states.
void symmetries(Findings& findings) {
    Dice dice(7);
    double mirror = 0, galilean = 0;
    for (const Mean mean : {Mean::arithmetic, Mean::density_weighted, Mean::impedance_weighted}) {
        Model model = riemann_model();
        model.velocity_mean = model.pressure_mean = mean;
        for (int k = 0; k < 300; ++k) {
            const auto any_phase = [&] { return dice.symmetric(1) > 0 ? Phase::water : Phase::air; };
            const State l{any_phase(), dice.symmetric(3), dice.symmetric(1e4)};
            const State r{any_phase(), dice.symmetric(3), dice.symmetric(1e4)};
            const Contact c = solver_contact(model, l, r);
            // in units of what the states can make of each other
            const double u_scale = 3 + 1e4 / model.air.impedance(),
                         p_scale = 1e4 + 3 * model.water.impedance();
            const Contact m =
                solver_contact(model, {r.phase, -r.velocity, r.pressure}, {l.phase, -l.velocity, l.pressure});
            mirror = std::max({mirror, std::abs(m.velocity + c.velocity) / u_scale,
                               std::abs(m.pressure - c.pressure) / p_scale});
            const double boost = dice.symmetric(100);
            const Contact g = solver_contact(model, {l.phase, l.velocity + boost, l.pressure},
                                             {r.phase, r.velocity + boost, r.pressure});
            galilean = std::max({galilean, std::abs(g.velocity - boost - c.velocity) / u_scale,
                                 std::abs(g.pressure - c.pressure) / p_scale});
        }
    }
    findings.record("mirror_invariance", 1, mirror);
    findings.record("galilean_invariance", 1, galilean);
    // what a mean of 1 and -0.5 m/s becomes for an observer who moves at 1 m/s
    const auto seen = [](MeanGuard guard, double frame) {
        return harmonic_mean(1.0 + frame, -0.5 + frame, guard, 1e-12) - frame;
    };
    char text[500];
    std::snprintf(
        text, sizeof text,
        "A harmonic mean of velocities is not Galilean invariant. Of 1 and -0.5 m/s, seen at rest and from a "
        "frame that moves at 1 m/s: as printed %.3g and %.3g m/s; harmonic for one sign, else arithmetic "
        "%.3g and %.3g m/s; for one sign, else zero %.3g and %.3g m/s. The arithmetic mean is 0.25 m/s in "
        "both. Only the variants of Yang et al. (2020) use harmonic means.",
        seen(MeanGuard::division, 0), seen(MeanGuard::division, 1), seen(MeanGuard::same_sign_arithmetic, 0),
        seen(MeanGuard::same_sign_arithmetic, 1), seen(MeanGuard::same_sign_zero, 0),
        seen(MeanGuard::same_sign_zero, 1));
    findings.note(text);
}

/// Forces of a disordered blob of water and air on itself: their sum must vanish.
void pair_symmetry(Findings& findings) {
    Model model = two_phase_model(water_sound_speed, air_sound_speed, 1000);
    model.viscosity = Viscosity::symmetric;
    model.water.viscosity = 0.5;
    model.air.viscosity = 0.01;
    const double dx = 0.05;
    Setup setup(model, {{0, 0}, {1, 1}}, dx, false);
    setup.fill(Phase::water, {{0, 0}, {0.5, 1}});
    setup.fill(Phase::air, {{0.5, 0}, {1, 1}});
    shake(setup, 0.3, 3);
    Dice dice(4);
    for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
        FluidState& p = setup.fluid.state[i];
        p.vx = dice.symmetric(1);
        p.vy = dice.symmetric(1);
        p.density *= 1 + dice.symmetric(0.01);
        p.volume = setup.fluid.mass[i] / p.density;
    }
    const Simulation simulation = setup.simulate();
    const FluidParticles& f = simulation.fluid();
    Vec2 sum = Vec2::Zero();
    double sizes = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
        const Vec2 force = f.mass[i] * Vec2(f.acceleration_x[i], f.acceleration_y[i]);
        sum += force;
        sizes += force.norm();
    }
    findings.record("action_and_reaction", 1, sum.norm() / sizes);
}

/// Every mean where its weights or values vanish: values must be finite, and the guarded mean zero on its
/// pole.
void singular_points(Findings& findings) {
    double worst = 0;
    const auto expect = [&](double value, double expected) {
        worst = std::isfinite(value) ? std::max(worst, std::abs(value - expected))
                                     : std::numeric_limits<double>::infinity();
    };
    for (const double a : {0.0, 1.0, -3.0, 1e-300, 1e150}) {
        expect(guarded_harmonic_mean(a, -a, 1e-12), 0);
        expect(guarded_harmonic_mean(0.0, a, 1e-12), 0);
    }
    expect(guarded_harmonic_mean(2.0, 2.0, 1e-12), 2);
    expect(weights_by(1, 0).left, 1);
    expect(weights_by(1e-300, 1e-300).left, 0.5);
    // two particles on one place, and alike: no jump, no force
    Setup setup(water_model(30), {{0, 0}, {1, 1}}, 0.1, false);
    for (int k = 0; k < 2; ++k) setup.fluid.add(Phase::water, {0.5, 0.5}, 10, 1000);
    const Simulation simulation = setup.simulate();
    for (std::size_t i = 0; i < 2; ++i) {
        expect(simulation.fluid().acceleration_x[i], 0);
        expect(simulation.fluid().density_rate[i], 0);
    }
    findings.record("singular_points", 1, worst);
}

void run(Findings& findings) {
    against_exact(findings);
    symmetries(findings);
    pair_symmetry(findings);
    singular_points(findings);
}

}  // namespace

Problem riemann_problem() {
    Problem problem;
    problem.name = "riemann";
    problem.title = "Riemann problem of two materials";
    problem.exact =
        "Shock and rarefaction curves of two Tait fluids; the contact pressure by root finding, the "
        "rarefaction "
        "by quadrature.";
    const std::string amplitude = "pressure jump over rho c^2 of the softer side";
    const std::string why =
        "acoustic states are exact to first order in the amplitude; the second-order term has a factor of "
        "(gamma + 1)/4 "
        "per side, 2 for water. Relative to the jump the error falls with the first power";
    problem.claims = {
        {"water_water_pressure", "difference from the exact contact pressure over the jump", amplitude, 0.08,
         Window{0.8, 1.2}, why},
        {"water_water_velocity", "difference from the exact contact velocity over the jump", amplitude, 0.08,
         Window{0.8, 1.2}, why},
        {"air_air_pressure", "difference from the exact contact pressure over the jump", amplitude, 0.08,
         Window{0.8, 1.2}, why},
        {"air_air_velocity", "difference from the exact contact velocity over the jump", amplitude, 0.08,
         Window{0.8, 1.2}, why},
        {"water_air_pressure", "difference from the exact contact pressure over the jump", amplitude, 0.08,
         Window{0.8, 1.2}, why},
        {"water_air_velocity", "difference from the exact contact velocity over the jump", amplitude, 0.08,
         Window{0.8, 1.2}, why},
        {"mirror_invariance",
         "largest breach under exchange and mirroring, linear means",
         "none",
         1e-13,
         {},
         "rounding"},
        {"galilean_invariance",
         "largest breach under a boost of up to 100 m/s, linear means",
         "none",
         1e-12,
         {},
         "rounding of velocities of 100 m/s"},
        {"action_and_reaction",
         "sum of all forces of a disordered blob of water and air on itself over the sum of their sizes",
         "none",
         1e-12,
         {},
         "rounding of sums of thirty neighbours"},
        {"singular_points",
         "largest difference from the defined value where a mean's denominator or a distance vanishes",
         "none",
         1e-12,
         {},
         "the defined values are exact"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
