// SPDX-License-Identifier: BSD-3-Clause
// Forces between any particles under any ingredients of the scheme: opposite, along the line between the two,
// and the same from wherever one looks.
#include <cmath>

#include "tests/property/generated_fluid.hpp"
#include "tests/support/reference_rates.hpp"

using namespace wetdeck;
using generated::draw_model;
using generated::draw_particles;

namespace {

/// Sums over all particles, and the sums of the sizes that they are measured against.
struct Sums {
    Vec2 linear = Vec2::Zero();
    double angular = 0;  ///< about the origin
    double linear_size = 0, angular_size = 0;

    void add(double mass, Vec2 position, Vec2 vector) {
        linear += mass * vector;
        angular += mass * (position.x() * vector.y() - position.y() * vector.x());
        linear_size += mass * vector.norm();
        angular_size += mass * position.norm() * vector.norm();
    }
    /// Of both sums, over the sizes.
    double largest() const {
        return std::max(linear_size > 0 ? linear.norm() / linear_size : 0,
                        angular_size > 0 ? std::abs(angular) / angular_size : 0);
    }
};

/// Forces between particles far apart are small beside their weight, and would be lost in its rounding.
Model without_gravity(Model model) {
    model.gravity = Vec2::Zero();
    return model;
}

Sums forces_of(const Simulation& simulation) {
    Sums sums;
    const FluidParticles& fluid = simulation.fluid();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        sums.add(fluid.mass[i], fluid.state[i].position(),
                 Vec2(fluid.acceleration_x[i], fluid.acceleration_y[i]));
    }
    return sums;
}

Sums momentum_of(const Simulation& simulation) {
    Sums sums;
    const FluidParticles& fluid = simulation.fluid();
    for (std::size_t i = 0; i < fluid.size(); ++i)
        sums.add(fluid.mass[i], fluid.state[i].position(), fluid.state[i].velocity());
    return sums;
}

/// Another point of view: a turn or a reflection about the origin, then a shift.
struct View {
    Eigen::Matrix2d turn;
    Vec2 shift;

    void turn_vector(double& x, double& y) const {
        const Vec2 turned = turn * Vec2(x, y);
        x = turned.x();
        y = turned.y();
    }
    void move(double& x, double& y) const {
        turn_vector(x, y);
        x += shift.x();
        y += shift.y();
    }
    samples::Setup of(samples::Setup setup) const {
        for (FluidState& p : setup.fluid.state) {
            move(p.x, p.y);
            turn_vector(p.vx, p.vy);
        }
        for (WallState& w : setup.walls.state) {
            move(w.x, w.y);
            turn_vector(w.vx, w.vy);
            turn_vector(w.nx, w.ny);
            turn_vector(w.ax, w.ay);
        }
        const Vec2 a = turn * setup.domain.low + shift, b = turn * setup.domain.high + shift;
        setup.domain = {a.cwiseMin(b), a.cwiseMax(b)};
        setup.model.gravity = turn * setup.model.gravity;
        return setup;
    }
};

/// One of the eight symmetries of a square.
View draw_view() {
    const double c = std::array{1, 0, -1, 0}[*generated::whole(0, 3).as("quarter turns")];
    const double s = std::array{0, 1, 0, -1}[c != 0 ? 0 : generated::one_of("side", {1, 3})];
    const double mirror = generated::one_of("mirror", {1, -1});
    View view;
    view.turn << mirror * c, -s, mirror * s, c;
    view.shift = {*generated::number(-3, 3).as("shift x"), *generated::number(-3, 3).as("shift y")};
    return view;
}

/// Between the rates of one setup, turned, and those of the other.
double difference(const Simulation& plain, const Simulation& viewed, const View& view) {
    const auto expected = samples::rates_by_id(plain.fluid()), found = samples::rates_by_id(viewed.fluid());
    generated::RateDifference difference;
    for (std::size_t id = 0; id < expected.size(); ++id) {
        const bool water = id < plain.fluid().water;
        const Material& material = water ? plain.model().water : plain.model().air;
        const Vec2 turned = view.turn * Vec2(expected[id][1], expected[id][2]);
        difference.add(water, material.eos.reference_density, {expected[id][0], turned.x(), turned.y()},
                       found[id]);
    }
    return difference.largest();
}

}  // namespace

TEST_CASE("Forces between any two particles are opposite and those of the plain formula",
          "[generated][conservation]") {
    generated::check(200, [] {
        const Model model = without_gravity(draw_model());
        std::vector<generated::Particle> two = draw_particles(2);
        two.resize(2);
        two[1].column = two[0].column == 0 ? 1 : two[0].column - 1;  // within reach
        two[1].row = two[0].row;
        const Simulation simulation = generated::setup_of(model, two, false).simulate();
        RC_ASSERT(forces_of(simulation).largest() < 1e-13);
        const FluidParticles& fluid = simulation.fluid();
        const Vec2 given = samples::reference_pair_force(fluid, 0, 1, model, generated::spacing);
        const Vec2 received = fluid.mass[1] * Vec2(fluid.acceleration_x[1], fluid.acceleration_y[1]);
        RC_ASSERT((received - given).norm() <= 1e-10 * given.norm());
    });
}

TEST_CASE("Forces within any set of particles add up to no force and no torque",
          "[generated][conservation]") {
    generated::check(200, [] {
        const Simulation simulation =
            generated::setup_of(without_gravity(draw_model()), draw_particles(3), false).simulate();
        RC_ASSERT(forces_of(simulation).largest() < 1e-12);
    });
}

TEST_CASE("Steps of any set of particles keep its linear and angular momentum", "[generated][conservation]") {
    generated::check(150, [] {
        Model model = without_gravity(draw_model());
        if (!model.dissipation_switch) model.air_substeps = generated::one_of("steps of the air", {1, 3});
        Simulation simulation = generated::setup_of(model, draw_particles(3), false).simulate();
        const Sums before = momentum_of(simulation);
        for (int n = 0; n < 5; ++n)
            if (simulation.step(1)) break;  // single particles may leave the range of a fluid
        Sums change = momentum_of(simulation);
        change.linear -= before.linear;
        change.angular -= before.angular;
        RC_ASSERT(change.largest() < 1e-12);
    });
}

TEST_CASE("Rates turn, reflect and move with the particles, their walls and gravity",
          "[generated][symmetry]") {
    generated::check(200, [] {
        Model model = draw_model();
        model.gravity = {*generated::number(-10, 10).as("gravity x"),
                         *generated::number(-10, 10).as("gravity y")};
        const bool with_walls = generated::one_of("walls", {false, true});
        samples::Setup setup = generated::setup_of(model, draw_particles(2), with_walls);
        const double velocity = *generated::number(-0.5, 0.5).as("wall velocity");
        for (WallState& w : setup.walls.state) {
            w.vx = velocity;
            w.ay = 10 * velocity;
        }
        const View view = draw_view();
        RC_ASSERT(difference(setup.simulate(), view.of(setup).simulate(), view) < 1e-9);
    });
}

TEST_CASE("Rates do not depend on a velocity that everything shares", "[generated][symmetry]") {
    generated::check(200, [] {
        Model model = draw_model();
        // the paper's harmonic mean of velocities and its switch take the frame of the tank
        if (model.velocity_mean == Mean::harmonic) model.velocity_mean = Mean::arithmetic;
        model.dissipation_switch = false;
        samples::Setup setup =
            generated::setup_of(model, draw_particles(2), generated::one_of("walls", {false, true}));
        const Simulation at_rest = setup.simulate();
        const Vec2 shared = {*generated::number(-3, 3).as("vx"), *generated::number(-3, 3).as("vy")};
        for (FluidState& p : setup.fluid.state) {
            p.vx += shared.x();
            p.vy += shared.y();
        }
        for (WallState& w : setup.walls.state) {
            w.vx += shared.x();
            w.vy += shared.y();
        }
        RC_ASSERT(difference(at_rest, setup.simulate(), {Eigen::Matrix2d::Identity(), Vec2::Zero()}) < 1e-9);
    });
}

TEST_CASE("Densities, pressures and viscosities times a factor leave every acceleration as it was",
          "[generated][symmetry]") {
    generated::check(150, [] {
        const Model model = draw_model();
        const auto particles = draw_particles(2);
        const double factor = *generated::number(0.1, 10).as("factor");
        Model heavy = model;
        for (Material* material : {&heavy.water, &heavy.air}) {
            material->eos.reference_density *= factor;
            material->eos.background_pressure *= factor;
            material->viscosity *= factor;
        }
        const Simulation light = generated::setup_of(model, particles, true).simulate();
        samples::Setup setup = generated::setup_of(heavy, particles, true);
        const auto expected = samples::rates_by_id(light.fluid()),
                   found = samples::rates_by_id(setup.simulate().fluid());
        double worst = 0, scale = 0;
        for (std::size_t id = 0; id < found.size(); ++id) {
            for (const std::size_t axis : {1, 2}) {
                worst = std::max(worst, std::abs(found[id][axis] - expected[id][axis]));
                scale = std::max(scale, std::abs(expected[id][axis]));
            }
        }
        RC_ASSERT(worst <= 1e-9 * scale);
    });
}
