// SPDX-License-Identifier: BSD-3-Clause
// Two equal blocks of water meet head on. Incompressible fluid loses, at that instant, the energy of the
// motion that the impulse takes away.
#include <cmath>
#include <numbers>

#include "solver/probes/energy.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double height = 1, length = 1, speed = 1;
constexpr double sound_speed = 100 * speed;
constexpr double duration = 0.1;     // in height / speed: ten passages of sound
constexpr double mean_start = 0.02;  // of the mean motion: eight passages

/// Share of the kinetic energy that is lost. The impulse obeys Laplace's equation, vanishes on the three free
/// sides, and has the slope -rho U at the plane of contact; by Kelvin the loss is U/2 times its integral
/// there:
///     8 H / (pi^3 L) SUM_odd tanh(n pi L / H) / n^3
double exact_loss() {
    double sum = 0;
    for (int n = 1; n < 2001; n += 2) sum += std::tanh(n * pi * length / height) / std::pow(n, 3);
    return 8 * height / (std::pow(pi, 3) * length) * sum;
}

void run(Findings& findings) {
    VerificationFigure figure{"Mechanical energy of two blocks that meet",
                              "time times U / H",
                              "-",
                              "energy over its start",
                              "-",
                              {},
                              {}};
    figure.exact = {{0, duration}, {1 - exact_loss(), 1 - exact_loss()}};
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        Model model = water_model(sound_speed);
        model.tension = false;
        Setup setup(model, {{-1.2 * length, -0.5}, {1.2 * length, height + 0.5}}, dx, false);
        setup.fill(Phase::water, {{-length, 0}, {0, height}});
        setup.fill(Phase::water, {{0, 0}, {length, height}});
        for (FluidState& p : setup.fluid.state) p.vx = p.x < 0 ? speed : -speed;
        Simulation simulation = setup.simulate();
        const double start = balance(simulation).kinetic;
        Curve energy{{0}, {1}};
        Vec2 momentum = Vec2::Zero();
        std::vector<Vec2> before(setup.fluid.size());
        double mean_from = 0;
        advance(simulation, duration * height / speed, [&](const Simulation& s) {
            const Balance b = balance(s);
            energy.x.push_back(s.time() * speed / height);
            energy.y.push_back((b.kinetic + b.compression) / start);
            momentum = b.momentum;
            if (mean_from > 0 || s.time() < mean_start * height / speed) return;
            mean_from = s.time();
            for (std::size_t i = 0; i < s.fluid().size(); ++i)
                before[s.fluid().id[i]] = s.fluid().state[i].position();
        });
        // velocities averaged over a period of sound: what the water does apart from ringing
        double mean_motion = 0;
        for (std::size_t i = 0; i < simulation.fluid().size(); ++i) {
            const Vec2 moved = simulation.fluid().state[i].position() - before[simulation.fluid().id[i]];
            mean_motion +=
                0.5 * simulation.fluid().mass[i] * (moved / (simulation.time() - mean_from)).squaredNorm();
        }
        findings.record("mean_motion", dx / height, std::abs((1 - mean_motion / start) / exact_loss() - 1));
        const double loss = 1 - energy.y.back();
        findings.record("energy_loss", dx / height, std::abs(loss / exact_loss() - 1));
        findings.record("momentum", dx / height, momentum.norm() / (water_density * height * length * speed));
        figure.computed.emplace_back("dx/H = " + std::to_string(dx).substr(0, 6), std::move(energy));
    }
    findings.figure(std::move(figure));
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
        "contact.";
    problem.claims = {
        {"energy_loss",
         "relative error of the loss of mechanical energy after ten passages of sound",
         "dx / height",
         0.2,
         {},
         "the lost motion first becomes sound, which the scheme damps: over ten passages the sound's "
         "amplitude falls by a "
         "factor of ten at least where its waves are shorter than half a block. 20 % are left to the slowest "
         "mode; no order expected",
         "The finer the spacing, the less is lost: 17, 13 and 10 % of the energy at 20, 40 and 80 spacings "
         "instead of 27 %. The rest "
         "is sound, which the limited dissipation (a tenth to a fifth of Riemann's at this Mach number) "
         "hardly damps; the motion "
         "without the sound has the exact energy."},
        {"mean_motion",
         "relative error of the loss, of the velocities averaged over eight passages of sound",
         "dx / height",
         0.15,
         {},
         "particles in a strip of one smoothing length along the three free sides lack half their "
         "neighbours: 3 h / H / 2 = 11 % at 20 spacings"},
        {"momentum",
         "momentum over that of one block",
         "dx / height",
         1e-12,
         {},
         "rounding: equal and opposite forces"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
