// SPDX-License-Identifier: BSD-3-Clause
// Two equal blocks of water meet head on. Incompressible fluid loses, at that instant, the kinetic energy
// of the motion that the impulse stops: sound carries it to and fro until it is damped. Water that bears no
// tension gives it back: the compression wave returns from the free sides as one that lets the blocks go.
#include <cmath>
#include <numbers>

#include "solver/probes/energy.hpp"
#include "validation/verification/numerics.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double height = 1, length = 1, speed = 1;
constexpr double sound_speed = 100 * speed;
constexpr double duration = 0.1;  // in height / speed: ten passages of sound

/// Share of the kinetic energy that is lost. The impulse obeys Laplace's equation, vanishes on the three free
/// sides, and has the slope -rho U at the plane of contact; by Kelvin the loss is U/2 times its integral
/// there:
///     8 H / (pi^3 L) SUM_odd tanh(n pi L / H) / n^3
double exact_loss() {
    double sum = 0;
    for (int n = 1; n < 2001; n += 2) sum += std::tanh(n * pi * length / height) / std::pow(n, 3);
    return 8 * height / (std::pow(pi, 3) * length) * sum;
}

/// Two blocks that fly at each other, their facing rows `gap` apart.
Setup blocks(double dx, double gap, bool tension) {
    Model model = water_model(sound_speed);
    model.negative_pressure = tension;
    Setup setup(model, {{-1.2 * length, -0.5}, {1.2 * length, height + 0.5}}, dx, false);
    setup.fill(Phase::water, {{-length, 0}, {0, height}});
    setup.fill(Phase::water, {{0, 0}, {length, height}});
    for (FluidState& p : setup.fluid.state) {
        const double side = p.x < 0 ? -1 : 1;
        p.vx = -side * speed;
        p.x += side * 0.5 * (gap - dx);
    }
    return setup;
}

/// The largest and the least pressure so far, over that of a water hammer, rho c U.
struct Extremes {
    double highest = 0, lowest = 0;

    void widen(const Simulation& simulation) {
        for (const FluidState& p : simulation.fluid().state) {
            const double ratio = p.pressure / (water_density * sound_speed * speed);
            highest = std::max(highest, ratio);
            lowest = std::min(lowest, ratio);
        }
    }
};

/// Pressures until the facing rows are 1.5 spacings apart: from out of each other's reach on.
Extremes approach(double dx) {
    constexpr double far = 3, near = 1.5;
    Simulation simulation = blocks(dx, far * dx, false).simulate();
    Extremes extremes;
    advance(simulation, 0.5 * (far - near) * dx / speed, [&](const Simulation& s) { extremes.widen(s); });
    return extremes;
}

/// When plane columns stand still: their momentum over the pressure P of the shock that brings water to rest,
/// U^2 = P (1/rho_0 - 1/rho(P)); L/c in the limit of slow columns.
double exact_turn() {
    const TaitEquationOfState law = water_model(sound_speed).water.eos;
    const double hammer = water_density * sound_speed * speed;
    const double pressure =
        root([&](double p) { return p * (1 / water_density - 1 / law.density(p)) - speed * speed; }, hammer,
             2 * hammer);
    return water_density * length * speed / pressure;
}

/// Energy over time of the two blocks, over its start.
Curve meet(double dx, bool tension, double& momentum, Extremes& extremes) {
    Simulation simulation = blocks(dx, dx, tension).simulate();
    const double start = balance(simulation).kinetic;
    Curve energy{{0}, {1}};
    advance(simulation, duration * height / speed, [&](const Simulation& s) {
        const Balance b = balance(s);
        energy.x.push_back(s.time() * speed / height);
        energy.y.push_back((b.kinetic + b.compression) / start);
        momentum = b.momentum.norm() / (water_density * height * length * speed);
        extremes.widen(s);
    });
    return energy;
}

/// Velocity over U of one of two columns without tension that meet between joined sides, so that sound runs
/// straight: exact from -1 to 1 in the time 2 L/c. Time in that of the exact turn.
Curve rebound(double dx) {
    constexpr double width = 0.5;
    Model model = water_model(sound_speed);
    model.negative_pressure = false;
    model.periodic_x = true;
    Setup setup(model, {{0, -1.2 * length}, {width, 1.2 * length}}, dx, false);
    setup.fill(Phase::water, {{0, -length}, {width, 0}});
    setup.fill(Phase::water, {{0, 0}, {width, length}});
    for (FluidState& p : setup.fluid.state) p.vy = p.y < 0 ? speed : -speed;
    Simulation simulation = setup.simulate();
    const auto half = static_cast<std::uint32_t>(setup.fluid.size() / 2);  // ids of the lower column
    const double turn = exact_turn();
    Curve velocity{{0}, {-1}};
    advance(simulation, 4 * length / sound_speed, [&](const Simulation& s) {
        const FluidParticles& f = s.fluid();
        double sum = 0;
        for (std::size_t i = 0; i < f.size(); ++i) sum += f.id[i] < half ? 0 : f.state[i].vy;
        velocity.x.push_back(s.time() / turn);
        velocity.y.push_back(sum / (half * speed));
    });
    return velocity;
}

void run_blocks(Findings& findings) {
    VerificationFigure figure{"Energy of two blocks that meet",
                              "time times U / H",
                              "-",
                              "energy over its start",
                              "-",
                              {{0, duration}, {1 - exact_loss(), 1 - exact_loss()}},
                              {}};
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        double momentum = 0;
        Extremes extremes, without_tension;
        Curve energy = meet(dx, true, momentum, extremes);
        findings.record("energy_loss", dx / height, std::abs((1 - energy.y.back()) / exact_loss() - 1));
        findings.record("momentum", dx / height, momentum);
        meet(dx, false, momentum, without_tension);
        findings.record("pressure_before_contact", dx / height, approach(dx).highest);
        findings.record("negative_pressure", dx / height, std::abs(without_tension.lowest));
        figure.computed.push_back({"dx/H = " + std::to_string(dx).substr(0, 6), std::move(energy)});
    }
    findings.figure(std::move(figure));
}

void run_columns(Findings& findings) {
    VerificationFigure figure{"Rebound of two columns without tension",
                              "time over that of the turn",
                              "-",
                              "velocity over U",
                              "-",
                              {{0, 2, 4}, {-1, 1, 1}},
                              {}};
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        Curve velocity = rebound(dx);
        std::size_t turn = 1;
        while (turn + 1 < velocity.x.size() && velocity.y[turn] < 0) ++turn;
        const double share = velocity.y[turn] / (velocity.y[turn] - velocity.y[turn - 1]);
        findings.record("rebound", dx / length, std::abs(velocity.y.back() - 1));
        findings.record("turn", dx / length,
                        std::abs(std::lerp(velocity.x[turn], velocity.x[turn - 1], share) - 1));
        figure.computed.push_back({"dx/L = " + std::to_string(dx).substr(0, 6), std::move(velocity)});
    }
    findings.figure(std::move(figure));
}

void run(Findings& findings) {
    run_blocks(findings);
    run_columns(findings);
    char text[120];
    std::snprintf(text, sizeof text, "Exact loss: %.4f of the kinetic energy.", exact_loss());
    findings.note(text);
}

}  // namespace

Problem block_impact() {
    Problem problem;
    problem.name = "block_impact";
    problem.title = "Impact of two equal blocks of water";
    problem.exact =
        "Pressure impulse: Laplace's equation on a block, in a series; the loss is (U/2) INT P dy over the "
        "contact. Water without tension loses none: plane sound turns the velocity of two columns round in 2 "
        "L/c.";
    problem.claims = {
        {"energy_loss", "relative error of the loss of mechanical energy after ten passages of sound",
         "dx / height", 0.15, Window{0.7, 4},
         "particles in a strip of one smoothing length along the three free sides lack half their "
         "neighbours, 3 h / H "
         "/ 2 = 11 % at 20 spacings, and the sound has to be damped; first order at least"},
        {"rebound", "error of the velocity after the rebound of two columns without tension, over U",
         "dx / length", std::sqrt(Model{}.smoothing_ratio / 20), Window{0.4, 1.5},
         "the pressure jump diffuses the density with about c h / 2, which spreads the front of the wave "
         "over 2 sqrt(h L) "
         "on its way there and back; a share sqrt(h / L) of the water leaves late: order 1/2"},
        {"turn",
         "error of the time at which the columns stand still, over the exact one",
         "dx / length",
         Model{}.smoothing_ratio / 20,
         {},
         "the places of contact and free ends are known to half a smoothing length each, with either sign: "
         "no "
         "order expected"},
        {"momentum",
         "momentum over that of one block",
         "dx / height",
         1e-12,
         {},
         "rounding: equal and opposite forces"},
        {"pressure_before_contact",
         "largest pressure before the blocks touch, over that of a water hammer, without tension",
         "dx / height",
         0.1,
         {},
         "none in an incompressible fluid. The rows of particles that face each other are still 1.5 spacings "
         "apart: their kernel sum is not full, and the upper bound of the density holds"},
        {"negative_pressure",
         "least pressure after contact, over that of a water hammer, without tension",
         "dx / height",
         1e-12,
         {},
         "none: the density has its lower bound at the reference"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
