// SPDX-License-Identifier: BSD-3-Clause
// What no wall can take away: momentum, mass, the path of the mass centre.
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/probes/energy.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::two_phase_model;

namespace {

/// Sum of m |v| [N s/m]: what rounding errors of momentum are measured against.
double momentum_scale(const Simulation& simulation) {
    double sum = 0;
    for (std::size_t i = 0; i < simulation.fluid().size(); ++i) {
        sum += simulation.fluid().mass[i] * simulation.fluid().state[i].velocity().norm();
    }
    return sum;
}

Vec2 mass_centre(const Simulation& simulation) {
    Vec2 sum = Vec2::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < simulation.fluid().size(); ++i) {
        sum += simulation.fluid().mass[i] * simulation.fluid().state[i].position();
        mass += simulation.fluid().mass[i];
    }
    return sum / mass;
}

}  // namespace

TEST_CASE("Momentum of a free two-phase blob is kept to rounding", "[conservation]") {
    Model model = GENERATE(two_phase_model(), samples::paper_model());
    // the paper's means of velocity and rho c end the run within few steps
    model.velocity_mean = Mean::impedance_weighted;
    model.impedance_mean = ImpedanceMean::arithmetic;
    if (!model.dissipation_switch) model.air_substeps = GENERATE(1, 3);
    model.gravity = Vec2::Zero();
    model.hydrostatic_correction = false;
    Simulation simulation = samples::shaken_blob(model, 11).simulate();
    const Balance before = balance(simulation);
    int steps = 0;  // without dissipation air is thrown off and ends the run
    while (steps < 200 && !simulation.step(1)) ++steps;
    REQUIRE(steps > 15);
    CHECK((balance(simulation).momentum - before.momentum).norm() < 1e-12 * momentum_scale(simulation));
    CHECK(balance(simulation).mass == Approx(before.mass).epsilon(1e-14));
    REQUIRE(simulation.list_builds() > 3);
}

TEST_CASE(
    "In mixed precision the momentum of a free blob drifts by less than a millionth of what its pairs "
    "exchange",
    "[conservation][mixed]") {
    samples::Setup setup = samples::shaken_blob(two_phase_model(), 11);
    setup.model.air_substeps = GENERATE(1, 3);
    setup.model.gravity = Vec2::Zero();
    setup.execution.precision = Precision::mixed;
    Simulation simulation = setup.simulate();
    const Balance before = balance(simulation);
    double exchanged = 0;  // half of the sum of the impulses of all particles [N s/m]
    for (int step = 0; step < 200; ++step) {
        REQUIRE_FALSE(simulation.step(1));
        const FluidParticles& fluid = simulation.fluid();
        for (std::size_t i = 0; i < fluid.water; ++i)
            exchanged += 0.5 * simulation.time_step().size / setup.model.air_substeps * fluid.mass[i] *
                         std::hypot(fluid.acceleration_x[i], fluid.acceleration_y[i]);
    }
    REQUIRE(exchanged > 1);
    // measured 2e-8
    CHECK((balance(simulation).momentum - before.momentum).norm() < 1e-6 * exchanged);
    CHECK(simulation.momentum_error() < 1e-7);
}

TEST_CASE("The mass centre of a free blob falls as a stone does, whatever goes on inside", "[conservation]") {
    samples::Setup setup = samples::shaken_blob(two_phase_model(), 12);
    setup.model.gravity = {1.5, -9.81};
    setup.model.air_substeps = GENERATE(1, 3);
    Simulation simulation = setup.simulate();
    const Vec2 start = mass_centre(simulation);
    const Vec2 velocity = balance(simulation).momentum / balance(simulation).mass;
    while (simulation.time() < 0.03) REQUIRE_FALSE(simulation.step(0.03 - simulation.time()));
    const Vec2 fall = 0.03 * velocity + 0.5 * 0.03 * 0.03 * setup.model.gravity;
    // velocity Verlet is exact for a constant acceleration: what is left is rounding
    CHECK((mass_centre(simulation) - start - fall).norm() < 1e-12 * fall.norm());
}

TEST_CASE("A blob at its reference density falls as one piece, exactly", "[conservation]") {
    samples::Setup setup = samples::shaken_blob(two_phase_model(), 13);
    setup.model.hydrostatic_correction =
        false;  // it takes out a pressure jump that a falling fluid does not have
    for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
        FluidState& p = setup.fluid.state[i];
        const TaitEquationOfState& eos =
            setup.fluid.phase(i) == Phase::water ? setup.model.water.eos : setup.model.air.eos;
        p.density = eos.reference_density;
        p.vx = 0.5;
        p.vy = 1;
    }
    setup.model.water.eos.background_pressure = setup.model.air.eos.background_pressure = 0;
    Simulation simulation = setup.simulate();
    while (simulation.time() < 0.05) REQUIRE_FALSE(simulation.step(0.05 - simulation.time()));
    const Vec2 fall = Vec2(0.5, 1) * 0.05 + 0.5 * 0.05 * 0.05 * Vec2(0, -9.81);
    const std::vector<FluidState> states = samples::by_id(simulation.fluid());
    double worst = 0;
    for (std::size_t id = 0; id < states.size(); ++id) {
        worst = std::max(worst, (states[id].position() - setup.fluid.state[id].position() - fall).norm());
    }
    CHECK(worst < 1e-12 * fall.norm());
}
