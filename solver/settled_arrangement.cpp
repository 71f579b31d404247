// SPDX-License-Identifier: BSD-3-Clause
#include "solver/settled_arrangement.hpp"

#include <algorithm>
#include <numeric>

#include "solver/core/dice.hpp"
#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

constexpr double largest_displacement = 0.07;  ///< along each axis, in spacings: 0.1 in all
constexpr int cycles = 4;
constexpr double cycle_length = 50;  ///< spacings that sound of the slower fluid travels

void displace(SimulationSetup& setup, std::uint64_t seed) {
    Dice dice(seed);
    for (FluidState& p : setup.fluid.state) {
        double largest = largest_displacement * setup.particle_spacing;
        if (setup.coarsest > 1) largest /= p.fineness;
        p.x += dice.symmetric(largest);
        p.y += dice.symmetric(largest);
    }
}

void hold(RigidBody& body) {
    body.free = {false, false, false};
    body.guide = {};
    body.springs.clear();
    body.velocity.setZero();
    body.angular_velocity = 0;
}

/// Moves the particles for a time [s]; their states but for the places are those that they had.
void settle(SimulationSetup& setup, double duration) {
    Simulation simulation(setup);
    if (const auto instability = simulation.run(duration, [](const Simulation&) {}))
        throw InputError("the disturbed arrangement of the particles does not settle: " +
                         instability->describe());
    const FluidParticles& settled = simulation.fluid();
    for (std::size_t i = 0; i < settled.size(); ++i) {
        FluidState& p = setup.fluid.state[settled.id[i]];
        p.x = settled.state[i].x;
        p.y = settled.state[i].y;
    }
}

}  // namespace

FluidParticles settled_arrangement(const SimulationSetup& given, std::uint64_t seed) {
    SimulationSetup setup = given;
    std::iota(setup.fluid.id.begin(), setup.fluid.id.end(), 0U);
    for (FluidState& p : setup.fluid.state) p.vx = p.vy = 0;
    for (RigidBody& body : setup.bodies) hold(body);
    setup.tank_motion = {};
    displace(setup, seed);
    double sound = setup.model.water.eos.sound_speed;
    if (setup.fluid.water < setup.fluid.size()) sound = std::min(sound, setup.model.air.eos.sound_speed);
    for (int cycle = 0; cycle < cycles; ++cycle) settle(setup, cycle_length * setup.particle_spacing / sound);
    FluidParticles fluid = given.fluid;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        fluid.state[i].x = setup.fluid.state[i].x;
        fluid.state[i].y = setup.fluid.state[i].y;
    }
    return fluid;
}

}  // namespace wetdeck
