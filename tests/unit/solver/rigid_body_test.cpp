// SPDX-License-Identifier: BSD-3-Clause
// A rigid body by itself: velocity Verlet is exact for constant loads, and the pose never drifts.
#include "solver/bodies/rigid_body.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

namespace {

constexpr double step = 1e-3;
const Vec2 gravity(0.5, -9.81);

RigidBody hull() {
    RigidBody body;
    body.mass = 3;
    body.inertia = 0.7;
    body.position = {1, 2};
    body.velocity = {0.25, -1};
    body.angular_velocity = 2;
    return body;
}

/// As the time loop does it, with constant loads by the fluid and this many short steps in a long one.
void advance(RigidBody& body, int steps, const BodyLoad& slow = {}, const BodyLoad& fast = {}, int all = 1) {
    body.set_slow_load(slow, gravity);
    body.set_fast_load(fast, gravity);
    for (int n = 0; n < steps; ++n) {
        const bool first = n % all == 0, last = n % all == all - 1;
        body.kick(0.5 * step, first ? all : 0);
        body.drift(0.5 * step);
        body.drift(0.5 * step);
        if (last) body.set_slow_load(slow, gravity);
        body.set_fast_load(fast, gravity);
        body.kick(0.5 * step, last ? all : 0);
    }
}

}  // namespace

TEST_CASE("Free fall and torque-free rotation are exact to rounding", "[body]") {
    RigidBody body = hull();
    advance(body, 2000);
    const Vec2 expected = Vec2(1, 2) + 2 * Vec2(0.25, -1) + 2 * gravity;
    CHECK((body.position - expected).norm() < 1e-11);
    CHECK(body.angle == Approx(4).epsilon(1e-12));
    CHECK(body.angular_velocity == 2);
    CHECK(body.impulse == Vec2::Zero());
}

TEST_CASE("Constant loads give the motion and the impulse of the textbook", "[body]") {
    RigidBody body = hull();
    body.applied_force = {0, 6};
    body.applied_torque = 0.3;
    const int all = GENERATE(1, 5);  // after 1000 steps a whole number of long ones
    advance(body, 1000, {{2, 1}, 0.3}, {{1, -1}, 0.1}, all);
    CHECK(body.velocity.x() == Approx(0.25 + 1 + 0.5));
    CHECK(body.velocity.y() == Approx(-1 + 2 - 9.81));
    CHECK(body.angular_velocity == Approx(2 + 1));
    CHECK(body.angle == Approx(2 + 0.5));
    CHECK(body.impulse.x() == Approx(3));
    CHECK(body.angular_impulse == Approx(0.4));
    // work of the fluid alone: F dx + T dtheta
    CHECK(body.work == Approx(3 * (0.25 + 0.75) + 0.4 * 2.5));
}

TEST_CASE("A body lighter than its added mass settles on the motion of both", "[body]") {
    // the wall pressure holds the last acceleration: F = F0 - m a_last
    const double following = 0.2, lift = 3;
    const int substeps = GENERATE(1, 7);  // between which the wall pressure stays as it is
    const auto accelerations = [&](double attached) {
        RigidBody body;
        body.mass = 0.01;
        body.inertia = 1;
        body.free = {false, true, false};
        body.added_mass = attached;
        std::vector<double> all = {0};
        for (int step = 0; step < 420; ++step) {
            if (step % substeps == 0)
                body.set_slow_load({{0, lift - following * body.acceleration.y()}, 0}, Vec2::Zero());
            body.set_fast_load({}, Vec2::Zero());
            all.push_back(body.acceleration.y());
        }
        return all;
    };
    const double common = lift / (0.01 + following);
    CHECK(std::abs(accelerations(0)[20 * static_cast<std::size_t>(substeps)]) > 1e6 * common);  // swings up
    const std::vector<double> settled = accelerations(0.25);
    CHECK(settled.back() == Approx(common).epsilon(1e-9));
    double lacking = 0;  // of the body's momentum, over the step
    for (std::size_t n = 1; n < settled.size(); ++n) {
        const std::size_t before =
            (n - 1) / static_cast<std::size_t>(substeps) * static_cast<std::size_t>(substeps);
        lacking += 0.01 * settled[n] - (lift - following * settled[before]);
    }
    // the difference of two accelerations over one long step, however many there are
    CHECK(lacking == Approx(-substeps * (0.25 - 0.01) * common));
}

TEST_CASE("A light body falls freely, exact to rounding, without settling first", "[body]") {
    RigidBody body = hull();
    body.added_mass = 100 * body.mass;
    body.added_inertia = 100 * body.inertia;
    body.acceleration = gravity;
    advance(body, 2000);
    CHECK(body.velocity.y() == Approx(-1 + 2 * gravity.y()).epsilon(1e-12));
    CHECK(body.angular_velocity == 2);
}

TEST_CASE("A locked degree of freedom keeps its velocity, whatever the load", "[body]") {
    RigidBody body = hull();
    body.free = {false, true, false};
    advance(body, 1000, {{1e6, 0}, 1e6}, {{1e6, 0}, 1e6}, 5);
    CHECK(body.velocity.x() == 0.25);
    CHECK(body.angular_velocity == 2);
    CHECK(body.velocity.y() == Approx(-1 - 9.81));
    CHECK(body.acceleration.x() == 0);
}

TEST_CASE("Points of a body keep their distance over a million steps", "[body]") {
    RigidBody body = hull();
    const Vec2 a(0.3, -0.2), b(-0.5, 0.1);
    for (int n = 0; n < 1'000'000; ++n) body.drift(step);
    CHECK((body.placed(a) - body.placed(b)).norm() == Approx((a - b).norm()).epsilon(1e-12));
    CHECK((body.local(body.placed(a)) - a).norm() < 1e-12);
}

TEST_CASE("Velocity and acceleration of a point are those of a turning frame", "[body]") {
    RigidBody body = hull();
    body.acceleration = {1, 1};
    body.angular_acceleration = 5;
    const Vec2 arm(0, 0.5);
    CHECK((body.velocity_at(arm) - Vec2(0.25 - 2 * 0.5, -1)).norm() < 1e-15);
    CHECK((body.acceleration_at(arm) - Vec2(1 - 5 * 0.5, 1 - 4 * 0.5)).norm() < 1e-15);
}
