// SPDX-License-Identifier: BSD-3-Clause
// A square of water that rotates freely: its corners fly out, its centre is under tension.
#include <cmath>

#include "solver/probes/energy.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/poisson.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double side = 1, rotation = 1;                    // [m], [1/s]
constexpr double sound_speed = 20 * 0.5 * side * rotation;  // of the speed at the middle of a side
constexpr double duration = 2;                              // in 1 / rotation

double angular_momentum(const FluidParticles& f) {
    double sum = 0;
    for (std::size_t i = 0; i < f.size(); ++i)
        sum += f.mass[i] * (f.state[i].x * f.state[i].vy - f.state[i].y * f.state[i].vx);
    return sum;
}

void run(Findings& findings) {
    PoissonProblem initial;  // grad p = -rho (v.grad) v: its divergence is that of a rigid rotation
    initial.box = {{-0.5 * side, -0.5 * side}, {0.5 * side, 0.5 * side}};
    initial.cells_x = initial.cells_y = 100;
    initial.source = 2 * water_density * rotation * rotation;
    const PoissonSolution pressure(initial);
    VerificationFigure figure{"Energy of the rotating square",
                              "time times rotation",
                              "-",
                              "energy over its start",
                              "-",
                              {{0, duration}, {1, 1}},
                              {}};
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        Setup setup(water_model(sound_speed), {{-2 * side, -2 * side}, {2 * side, 2 * side}}, dx, false);
        setup.fill(Phase::water, initial.box);
        set_initial_pressure(setup.fluid, setup.model, [&](Phase, Vec2 at) { return pressure.at(at); });
        for (FluidState& p : setup.fluid.state) {
            p.vx = -rotation * p.y;
            p.vy = rotation * p.x;
        }
        Simulation simulation = setup.simulate();
        const double momentum = angular_momentum(simulation.fluid());
        const auto energy = [&] {
            const Balance b = balance(simulation);
            return b.kinetic + b.compression;
        };
        const double start = energy();
        Curve curve{{0}, {1}};
        advance(simulation, duration / rotation, [&](const Simulation& s) {
            if (s.steps() % 10 != 0) return;
            curve.x.push_back(s.time() * rotation);
            curve.y.push_back(energy() / start);
        });
        const FluidParticles& f = simulation.fluid();
        double xx = 0, yy = 0, xy = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
            xx += f.mass[i] * f.state[i].x * f.state[i].x;
            yy += f.mass[i] * f.state[i].y * f.state[i].y;
            xy += f.mass[i] * f.state[i].x * f.state[i].y;
        }
        findings.record("angular_momentum", dx / side, std::abs(angular_momentum(f) / momentum - 1));
        findings.record("energy", dx / side, std::abs(energy() / start - 1));
        findings.record("shape", dx / side, std::hypot(xx - yy, 2 * xy) / (xx + yy));
        figure.computed.emplace_back("dx = " + std::to_string(dx).substr(0, 6) + " m", std::move(curve));
    }
    findings.figure(std::move(figure));
}

}  // namespace

Problem square_patch() {
    Problem problem;
    problem.name = "square_patch";
    problem.title = "Rotating square of water";
    problem.exact =
        "Angular momentum and energy stay; a quarter turn changes nothing. The initial pressure solves "
        "laplace(p) = 2 rho "
        "omega^2 with p = 0 on the sides. The shape itself has no closed form.";
    problem.claims = {
        {"angular_momentum",
         "relative change of the angular momentum over omega t = 2",
         "dx / side",
         1e-4,
         {},
         "pair forces are central, so that only the step's rounding and the drift between two forces changes "
         "it: second order in c dt, (0.5)^2 of "
         "the angle turned per step squared"},
        {"energy", "relative change of kinetic and elastic energy over omega t = 2", "dx / side", 0.15,
         Window{0.4, 2.5},
         "particles in a strip of one smoothing length along the four sides lack half their neighbours: 4 h "
         "/ side / 2 = 15 % of "
         "all pairs at 20 spacings; first order"},
        {"shape",
         "difference of the principal second moments of area over their sum",
         "dx / side",
         0.01,
         {},
         "a square's fourfold symmetry makes them equal; rounding grows where tension makes particles clump, "
         "at most a clump of 1 % of the particles"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
