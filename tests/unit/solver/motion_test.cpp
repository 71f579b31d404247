// SPDX-License-Identifier: BSD-3-Clause
// Prescribed motion: exact at samples, with derivatives that belong together; bodies that follow it.
#include "solver/bodies/motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solver/bodies/rigid_body.hpp"
#include "solver/core/errors.hpp"

using namespace wetdeck;

namespace {

/// The largest difference between the derivatives that a motion gives and those of its differences.
double derivative_error(const Motion& motion, double time, double difference = 1e-6) {
    const MotionState before = motion(time - difference), now = motion(time),
                      after = motion(time + difference);
    const double velocity = (after.displacement - before.displacement) / (2 * difference);
    const double acceleration = (after.velocity - before.velocity) / (2 * difference);
    return std::max(std::abs(velocity - now.velocity), std::abs(acceleration - now.acceleration));
}

/// Steps of velocity Verlet without any load.
void follow(RigidBody& body, double dt, int steps, const std::function<void(double)>& each = {}) {
    body.start();
    double time = 0;
    const auto loads = [&](double remaining) {
        body.set_restraint(remaining);
        body.set_slow_load({}, Vec2::Zero());
        body.set_fast_load({}, Vec2::Zero(), time);
    };
    loads(0);
    for (int n = 0; n < steps; ++n) {
        time = (n + 0.5) * dt;
        body.kick(0.5 * dt, 1, time);
        body.drift(0.5 * dt, time);
        time = (n + 1) * dt;
        body.drift(0.5 * dt, time);
        loads(0.5 * dt);
        body.kick(0.5 * dt, 1, time);
        if (each) each(time);
    }
}

}  // namespace

TEST_CASE("A sampled motion meets every sample, does not overshoot, and its derivatives belong to it",
          "[motion]") {
    const Curve samples{{0, 0.1, 0.25, 0.3, 0.5, 0.8}, {0, 0.02, 0.3, 0.3, 0.1, -0.4}};
    const Motion motion = sampled_motion(samples);
    for (std::size_t k = 0; k < samples.x.size(); ++k)
        CHECK(motion(samples.x[k]).displacement == samples.y[k]);
    for (double t = 0.0053; t < 0.8; t += 0.0101) {
        CAPTURE(t);
        CHECK(derivative_error(motion, t) < 1e-5);
        CHECK(motion(t).displacement <= 0.3);
    }
    CHECK(motion(0.27).displacement == 0.3);  // between two equal samples
    CHECK(motion(0.9).displacement == Approx(-0.4 + 0.1 * motion(0.8).velocity));
    const double step = 1e-9;
    CHECK(std::abs(motion(0.25 - step).velocity - motion(0.25 + step).velocity) < 1e-6);
}

TEST_CASE("A straight line of samples is a steady motion", "[motion]") {
    const Motion motion = sampled_motion({{0, 0.3, 1}, {1, 0.4, -1}});
    CHECK(motion(0.77).velocity == Approx(-2));
    CHECK(motion(0.77).displacement == Approx(1 - 2 * 0.77));
    CHECK(std::abs(motion(0.77).acceleration) < 1e-12);
}

TEST_CASE("Velocities that are linear between samples are integrated exactly", "[motion]") {
    const Motion motion = piecewise_linear_velocity({{-0.1, 0.2, 0.5}, {1, 1, -2}});
    CHECK(motion(0).displacement == 0);
    CHECK(motion(0.2).displacement == Approx(0.2));
    CHECK(motion(0.5).displacement == Approx(0.2 + 0.3 * (1 - 2) / 2));
    CHECK(motion(0.7).displacement == Approx(0.2 - 0.15 - 2 * 0.2));
    CHECK(motion(0.3).acceleration == Approx(-10));
    for (const double t : {0.05, 0.3, 0.45, 0.6}) CHECK(derivative_error(motion, t) < 1e-6);
}

TEST_CASE("A harmonic motion with a ramp begins and goes on without a jump", "[motion]") {
    const Motion motion = harmonic_motion({0.05, 0.7, 0.4, 0.9});
    CHECK(motion(0).displacement == 0);
    CHECK(motion(0).velocity == 0);
    CHECK(motion(0).acceleration == 0);
    for (double t = 0.013; t < 2; t += 0.029) CHECK(derivative_error(motion, t, 1e-5) < 1e-6);
    CHECK(motion(1.4).displacement == Approx(0.05 * std::sin(2 * std::numbers::pi * 1.4 / 0.7 + 0.4)));
    CHECK(from_start(harmonic_motion({1, 1, 0.5 * std::numbers::pi, 0}))(0.5).displacement == Approx(-2));
}

TEST_CASE("Motions of bad samples are refused", "[motion]") {
    CHECK_THROWS_AS(sampled_motion({{0}, {0}}), InputError);
    CHECK_THROWS_AS(sampled_motion({{0, 0}, {0, 1}}), InputError);
    CHECK_THROWS_AS(sampled_motion({{0, 1}, {0, std::nan("")}}), InputError);
    CHECK_THROWS_AS(piecewise_linear_velocity({{1, 0}, {0, 0}}), InputError);
    CHECK_THROWS_AS(harmonic_motion({1, 0, 0, 0}), InputError);
    CHECK_THROWS_AS(harmonic_motion({1, 1, 0, -1}), InputError);
}

TEST_CASE("A body follows a given motion to rounding, in position, velocity and acceleration",
          "[motion][body]") {
    RigidBody body;
    body.position = {1, 2};
    body.angle = 0.3;
    body.guide.motion = {harmonic_motion({0.1, 0.5, 0, 0}),
                         sampled_motion({{0, 0.2, 0.5, 1}, {0, 0.1, -0.3, 0.2}}),
                         piecewise_linear_velocity({{0, 1}, {0, 3}})};
    double worst = 0;
    follow(body, 1e-3, 1000, [&](double t) {
        const auto& motion = body.guide.motion;
        worst = std::max({worst, std::abs(body.position.x() - 1 - motion[0](t).displacement),
                          std::abs(body.position.y() - 2 - motion[1](t).displacement),
                          std::abs(body.angle - 0.3 - motion[2](t).displacement),
                          std::abs(body.velocity.x() - motion[0](t).velocity),
                          std::abs(body.angular_velocity - motion[2](t).velocity),
                          std::abs(body.acceleration.y() - motion[1](t).acceleration)});
    });
    CHECK(worst < 1e-14);
}

TEST_CASE("A spring moves a mass with the frequency and the decay of the textbook", "[spring][body]") {
    const auto direction = GENERATE(Spring::Direction::x, Spring::Direction::y, Spring::Direction::rotation);
    const double damping = GENERATE(0.0, 2.0);
    RigidBody body;
    body.mass = body.inertia = 2;
    Spring spring;
    spring.direction = direction;
    spring.stiffness = 50;
    spring.damping = damping;
    spring.rest = 0.1;
    body.springs = {spring};
    const double decay = damping / (2 * 2), w = std::sqrt(50.0 / 2 - decay * decay);
    const double dt = 2e-4;
    double worst = 0;
    follow(body, dt, 10000, [&](double t) {
        const double expected =
            0.1 - 0.1 * std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
        const double found = direction == Spring::Direction::x   ? body.position.x()
                             : direction == Spring::Direction::y ? body.position.y()
                                                                 : body.angle;
        worst = std::max(worst, std::abs(found - expected));
    });
    CHECK(worst < 1e-7);  // second order: (w dt)^2 w t / 24 of the amplitude
}

TEST_CASE("An end stop acts beyond its play alone, a slack line pulls only when it is taut", "[spring]") {
    Spring stop;
    stop.stiffness = 100;
    stop.damping = 5;
    stop.play = {-0.1, 0.2};
    CHECK(stop.pull(0.15, 3) == 0);
    CHECK(stop.pull(0.3, 0) == Approx(10));
    CHECK(stop.pull(-0.2, 2) == Approx(-10 + 10));
    Spring table;
    table.table = {{-1, 0, 1}, {-2, 0, 6}};
    CHECK(table.pull(0.5, 0) == Approx(3));
    CHECK(table.pull(2, 0) == Approx(12));
    CHECK(table.pull(-2, 0) == Approx(-4));
    CHECK(table.largest_stiffness() == 6);

    RigidBody body;
    body.mass = body.inertia = 1;
    Spring line;
    line.direction = Spring::Direction::line;
    line.on_body = {0.5, 0};
    line.on_earth = {0.5, 2};
    line.free_length = 1;
    line.stiffness = 10;
    const BodyLoad load = line.load(body, Vec2::Zero(), 0);
    CHECK(load.force.y() == Approx(10));
    CHECK(load.torque == Approx(5));
    line.play = {-std::numeric_limits<double>::infinity(), 0};
    body.position.y() = 1.5;
    CHECK(line.load(body, Vec2::Zero(), 0).force.norm() == 0);
    body.position.y() = -0.5;
    CHECK(line.load(body, {0, 2}, 0).force.y() == Approx(15));
}

TEST_CASE("A body on a hinge swings as a physical pendulum", "[hinge][body]") {
    // small angles: T = 2 pi sqrt((I + M r^2) / (M g r))
    RigidBody body;
    body.mass = 3;
    body.inertia = 0.4;
    body.free = {false, false, true};
    body.guide.pivot = Vec2(0, 0.6);
    body.angle = 1e-3;
    body.position = Vec2(0.6 * std::sin(1e-3), -0.6 * std::cos(1e-3));  // hinge at the origin
    body.start();
    const Vec2 gravity(0, -9.81);
    const double w = std::sqrt(3 * 9.81 * 0.6 / (0.4 + 3 * 0.36)), dt = 1e-3;
    double worst = 0, off = 0;
    const auto loads = [&] {
        body.set_slow_load({}, gravity);
        body.set_fast_load({}, gravity);
    };
    loads();
    for (int n = 0; n < 3000; ++n) {
        body.kick(0.5 * dt, 1);
        body.drift(0.5 * dt);
        body.drift(0.5 * dt);
        loads();
        body.kick(0.5 * dt, 1);
        worst = std::max(worst, std::abs(body.angle - 1e-3 * std::cos(w * (n + 1) * dt)));
        off = std::max(off, body.turning_point().norm());
    }
    CHECK(worst < 1e-7);
    CHECK(off < 1e-14);
    CHECK(std::abs(body.velocity_at(body.turning_point() - body.position).norm()) < 1e-14);
}

TEST_CASE("A body that is held keeps its velocity and falls after its release", "[motion][body]") {
    RigidBody body;
    body.mass = 1;
    body.inertia = 1;
    body.velocity = {0, -2};
    body.guide.release_time = 0.5;
    body.start();
    const Vec2 gravity(0, -9.81);
    const double dt = 1e-3;
    for (int n = 0; n < 1000; ++n) {
        body.release_at(n * dt, gravity);
        body.set_slow_load({}, gravity);
        body.set_fast_load({}, gravity);
        body.kick(dt, 1);
        body.drift(dt);
        if (n == 499) CHECK(body.velocity.y() == -2);
    }
    CHECK(body.velocity.y() == Approx(-2 - 0.5 * 9.81));
}

TEST_CASE("Contradictions of guided bodies are refused", "[motion][body]") {
    RigidBody body;
    body.mass = body.inertia = 1;
    body.guide.pivot = Vec2(0, 1);
    CHECK_THROWS_AS(body.check(), InputError);
    body.free = {false, false, true};
    CHECK_NOTHROW(body.check());
    body.guide.motion[2] = harmonic_motion({1, 1, 0, 0});
    CHECK_THROWS_AS(body.check(), InputError);
    body.guide.release_time = 1;
    CHECK_NOTHROW(body.check());
}
