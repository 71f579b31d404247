// SPDX-License-Identifier: BSD-3-Clause
// The forces of a moving tank, and still water in one.
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/bodies/moving_frame.hpp"
#include "solver/core/errors.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "solver/setup/lattice.hpp"
#include "solver/simulation.hpp"

using namespace wetdeck;

namespace {

const Vec2 gravity(0, -9.81);

/// Position in the tank of a point of the earth, by the definition of the motion.
Vec2 seen_from(const MovingFrame& frame, double time, Vec2 earth) {
    const auto at = [&](std::size_t k) { return frame.motion[k] ? frame.motion[k](time).displacement : 0; };
    return frame.centre + Eigen::Rotation2Dd(-at(2)) * (earth - frame.centre - Vec2(at(0), at(1)));
}

}  // namespace

TEST_CASE("A body in free flight moves in a moving tank as it does when seen from there", "[tank]") {
    MovingFrame frame;
    frame.motion = {harmonic_motion({0.1, 0.9, 0, 0}), harmonic_motion({0.05, 0.7, 0, 0}),
                    harmonic_motion({0.3, 0.8, 0, 0})};
    frame.centre = {0.4, -0.2};
    const auto path = [&](double t) -> Vec2 {
        return seen_from(frame, t, Vec2(1, 2) + t * Vec2(0.3, 1) + 0.5 * t * t * gravity);
    };
    const double difference = 1e-4;
    for (double t = 0.1; t < 1; t += 0.13) {
        const Vec2 before = path(t - difference), now = path(t), after = path(t + difference);
        const Vec2 velocity = (after - before) / (2 * difference);
        const Vec2 acceleration = (after - 2 * now + before) / (difference * difference);
        CHECK((gravity + frame.forces(t, gravity).at(now, velocity) - acceleration).norm() < 1e-4);
    }
}

TEST_CASE("A tank that moves can be neither periodic nor have a sponge layer", "[tank]") {
    SimulationSetup setup;
    setup.particle_spacing = 0.1;
    setup.domain = {{0, 0}, {1, 1}};
    fill_box(setup.fluid, Phase::water, setup.domain, 0.1, 1000);
    setup.tank_motion.motion[0] = harmonic_motion({0.1, 1, 0, 0});
    setup.model.sponge_thickness = 0.1;
    CHECK_THROWS_AS(Simulation(setup), InputError);
}
