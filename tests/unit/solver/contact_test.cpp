// SPDX-License-Identifier: BSD-3-Clause
// Contact of bodies: restitution, energy, momentum, rest.
#include "solver/bodies/contact.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

namespace {

const Box tank{{0, 0}, {4, 2}};

/// A rectangle of 0.4 x 0.2 m and 80 kg/m.
RigidBody block(Vec2 position, double angle = 0) {
    RigidBody body;
    body.mass = 80;
    body.inertia = body.mass * (0.16 + 0.04) / 12;
    body.position = position;
    body.angle = angle;
    body.corners = {{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}};
    body.radius = std::hypot(0.2, 0.1);
    return body;
}

/// Velocity Verlet without fluid.
void march(std::vector<RigidBody>& bodies, const ContactLaw& law, Vec2 gravity, double duration, double dt) {
    for (double t = 0; t < duration; t += dt) {
        for (RigidBody& body : bodies) {
            body.kick(0.5 * dt, 1);
            body.drift(dt);
        }
        set_contact_loads(bodies, tank, law);
        for (RigidBody& body : bodies) {
            body.set_fast_load({}, gravity);
            body.kick(0.5 * dt, 1);
        }
    }
}

double energy(const std::vector<RigidBody>& bodies) {
    double sum = 0;
    for (const RigidBody& body : bodies) sum += body.kinetic_energy();
    return sum;
}

}  // namespace

TEST_CASE("the damping ratio gives the restitution of the closed form", "[contact]") {
    CHECK(damping_ratio(1) == Approx(0).margin(1e-12));
    // e = exp(-tan(phi) (pi - 2 phi)) at phi = pi/6 and pi/4
    CHECK(damping_ratio(std::exp(-std::tan(std::numbers::pi / 6) * 2 * std::numbers::pi / 3)) == Approx(0.5));
    CHECK(damping_ratio(std::exp(-std::numbers::pi / 2)) == Approx(std::sqrt(0.5)));
}

TEST_CASE("a contact pushes, and never pulls", "[contact]") {
    const ContactLaw law{1e6, 0.3};
    const double zeta = damping_ratio(0.3);
    CHECK(law.force(zeta, -0.001, 5, 80) == 0);
    CHECK(law.force(zeta, 0.001, -50, 80) == 0);
    CHECK(law.force(zeta, 0.001, 0, 80) == Approx(1000));
    CHECK(law.force(zeta, 0.001, 1, 80) > 1000);
}

TEST_CASE("a block leaves a face with the restitution times its speed, flat or on a corner", "[contact]") {
    const double e = GENERATE(0.2, 0.5, 0.8, 1.0);
    const double angle = GENERATE(0.0, 0.4);
    CAPTURE(e, angle);
    const ContactLaw law{1e9, e};
    RigidBody body = block({2, 0}, angle);
    const Vec2 arm = body.axes() * body.corners[0];  // to the lowest corner
    body.position.y() = 1e-6 - arm.y();
    body.velocity = {0, -0.1};
    std::vector<RigidBody> bodies = {body};
    const double before = energy(bodies);
    march(bodies, law, {0, 0}, 0.003, 1e-7);  // short enough that the block hardly turns
    const RigidBody& after = bodies[0];
    const double speed =
        angle == 0 ? after.velocity.y() : after.velocity_at(after.axes() * body.corners[0]).y();
    CHECK(speed == Approx(0.1 * e).epsilon(0.02));
    // 1/m = 1/M + arm^2/I at the corner that hits
    const double mass = angle == 0 ? 80 : 1 / (1 / 80.0 + arm.x() * arm.x() / body.inertia);
    CHECK(before - energy(bodies) == Approx(0.5 * (1 - e * e) * mass * 0.01).epsilon(0.02).margin(1e-4));
}

TEST_CASE("two bodies push each other with opposite forces and lose no momentum", "[contact]") {
    const ContactLaw law{1e7, 0.5};
    std::vector<RigidBody> bodies = {block({1.5, 1}), block({2.0, 1.03}, 0.3)};
    bodies[0].velocity = {1, 0};
    const double before = energy(bodies);
    march(bodies, law, {0, 0}, 0.3, 1e-5);
    const Vec2 momentum = 80 * (bodies[0].velocity + bodies[1].velocity);
    CHECK(momentum.x() == Approx(80));
    CHECK(momentum.y() == Approx(0).margin(1e-9));
    double angular = 0;
    for (const RigidBody& b : bodies)
        angular += b.inertia * b.angular_velocity +
                   b.mass * (b.position.x() * b.velocity.y() - b.position.y() * b.velocity.x());
    CHECK(angular == Approx(-80).epsilon(1e-4));
    CHECK(bodies[1].velocity.x() > 0.3);
    CHECK(energy(bodies) < before);
}

TEST_CASE("two bodies leave each other with the restitution, wherever their faces and corners meet",
          "[contact]") {
    struct Meeting {
        const char* what;
        double shift;   ///< of the second along y [m]
        double angle;   ///< of the second
        double height;  ///< of the second over that of the first
    };
    const Meeting meeting = GENERATE(values<Meeting>({{"faces in line", 0, 0, 1},
                                                      {"faces nearly in line", 1e-12, 0, 1},
                                                      {"a hair aside", 1e-6, 0, 1},
                                                      {"aside by a depth", 1e-3, 0, 1},
                                                      {"aside", 0.07, 0, 1},
                                                      {"a face wider by half", 0, 0, 1.5},
                                                      {"corners in line below", 0.1, 0, 2},
                                                      {"narrower", 0.01, 0, 0.3},
                                                      {"turned upside down", 0, std::numbers::pi, 1},
                                                      {"turned on its corner", 0.03, 0.7, 1},
                                                      {"a corner on a slanted face", 0.16, 0.4, 1}}));
    const double e = GENERATE(0.3, 0.5, 1.0);
    const bool fixed = GENERATE(false, true);
    CAPTURE(meeting.what, e, fixed);
    std::vector<RigidBody> bodies = {block({1, 1}), block({2, 1 + meeting.shift}, meeting.angle)};
    for (Vec2& corner : bodies[1].corners) corner.y() *= meeting.height;
    for (RigidBody& body : bodies) body.free = {true, false, false};
    if (fixed) bodies[1].free = {false, false, false};
    const double before = 0.1;
    bodies[0].velocity = {before, 0};
    // the second is brought nearer until the next step of 1e-5 m would touch
    while (contact_frequency(bodies, tank, {1e9, e}, 2e-5) == 0) bodies[1].position.x() -= 1e-5;
    march(bodies, {1e9, e}, {0, 0}, 0.006, 1e-7);
    CHECK(bodies[1].velocity.x() - bodies[0].velocity.x() == Approx(e * before).epsilon(0.02));
    CHECK(bodies[0].velocity.y() == 0);
    if (!fixed) CHECK(80 * (bodies[0].velocity.x() + bodies[1].velocity.x()) == Approx(80 * before));
}

TEST_CASE("a block comes to rest on the floor with its weight on its corners", "[contact]") {
    const ContactLaw law{1e6, 0.4};
    std::vector<RigidBody> bodies = {block({2, 0.15}, 0.1)};
    march(bodies, law, {0, -9.81}, 3, 1e-4);
    CHECK(bodies[0].velocity.norm() < 1e-3);
    CHECK(bodies[0].angle == Approx(0).margin(1e-4));
    CHECK(bodies[0].position.y() == Approx(0.1 - 80 * 9.81 / 2e6).epsilon(1e-4));
    CHECK(bodies[0].contact.force.y() == Approx(80 * 9.81).epsilon(1e-3));
}

TEST_CASE("the frequency of contacts is that of a mass on its springs, and 0 far from any", "[contact]") {
    const ContactLaw law{1e6, 0.5};
    CHECK(contact_frequency({block({2, 1})}, tank, law, 0.02) == 0);
    const double found = contact_frequency({block({2, 0.11})}, tank, law, 0.02);
    CHECK(found >= std::sqrt(2e6 / 80));
    CHECK(found < 3 * std::sqrt(2e6 / 80));
}

TEST_CASE("bodies that meet corner to corner do not turn, and stacked ones do not slide", "[contact]") {
    std::vector<RigidBody> round = {block({1, 1}), block({2, 1})};
    for (RigidBody& body : round) {
        body.corners.clear();
        for (int k = 0; k < 48; ++k)
            body.corners.emplace_back(0.2 * std::cos(k * std::numbers::pi / 24),
                                      0.2 * std::sin(k * std::numbers::pi / 24));
    }
    round[1].position.x() = 1.4001;
    round[0].velocity = {0.1, 0};
    march(round, {1e9, 0.5}, {0, 0}, 0.006, 1e-7);
    CHECK(round[0].angular_velocity == Approx(0).margin(1e-6));
    CHECK(round[1].velocity.x() - round[0].velocity.x() == Approx(0.05).epsilon(0.02));

    const double turning = GENERATE(-0.3, 0.05, 0.3);
    std::vector<RigidBody> stack = {block({2, 0.1}), block({2, 0.301})};
    stack[1].angular_velocity = turning;
    march(stack, {1e7, 0.2}, {0, -9.81}, 1, 2e-5);
    CHECK(stack[1].position.x() == Approx(2).margin(1e-4));
    CHECK(stack[1].position.y() == Approx(0.3).margin(2e-4));
    CHECK(stack[1].angle == Approx(0).margin(1e-3));
}
