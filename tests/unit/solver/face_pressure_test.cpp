// SPDX-License-Identifier: BSD-3-Clause
// The reading of the pressure on faces: linear fields, corners and edges, partial cover, disorder, two
// phases.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solver/probes/pressure.hpp"
#include "solver/setup/cut_cells.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::Setup;

namespace {

constexpr double weight = 9810;  ///< of water [N/m^3]
const Box tank{{0, 0}, {1, 1}};

Vec2 direction(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

Model still_model() {
    Model model = samples::two_phase_model();
    model.gravity = {0, -9.81};
    return model;
}

/// A tank full of water.
Setup full_tank(double spacing) {
    Setup setup(still_model(), tank, spacing, true);
    setup.fill(Phase::water, tank);
    return setup;
}

/// The same with a body about its centre.
Setup around_body(const Outline& outline, double spacing) {
    Setup setup = full_tank(spacing);
    RigidBody body;
    body.mass = body.inertia = 1;
    body.position = {0.5, 0.5};
    Outline placed = outline;
    for (Vec2& corner : placed) corner += body.position;
    cut_cells(setup.fluid, {placed}, spacing);
    add_body_particles(setup.walls, 0, outline, Vec2::Zero(), spacing,
                       2 * setup.model.smoothing_ratio * spacing);
    setup.bodies.push_back(body);
    return setup;
}

/// A square of 0.44 m about the tank's centre, turned; its half side is a whole number of spacings.
Outline turned_square(double degrees) {
    Outline outline;
    for (const double corner : {225, 315, 45, 135})
        outline.push_back(0.22 * std::numbers::sqrt2 * direction(corner + degrees));
    return outline;
}

/// Gauge pressure of 4000 Pa at the centre of the tank, rising by the weight of water in a direction.
struct LinearField {
    double towards;  ///< [degrees]
    double operator()(Vec2 at) const { return 4000 + weight * direction(towards).dot(at - Vec2(0.5, 0.5)); }
};

/// Largest error of readings in a linear field over the pressure difference across a metre.
double worst_error(Setup setup, double shaken, double towards, std::span<const FacePoint> points) {
    verification::shake(setup, shaken, 7);
    const LinearField field{towards};
    set_initial_pressure(setup.fluid, setup.model, [&](Phase, Vec2 at) { return field(at); });
    const std::vector<double> pressure = face_pressures(setup.simulate(), points);
    double worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
        worst = std::max(worst, std::abs(pressure[k] - field(points[k].place)) / weight);
    return worst;
}

const std::vector<double> directions = {0, 45, 90, 135, 180, 225, 270, 315};

}  // namespace

TEST_CASE("A linear pressure field of any direction is read exactly on a face of any slope", "[probe]") {
    for (const double degrees : {0, 15, 30, 45, 60, 90}) {
        for (const double spacing : {0.04, 0.02}) {
            const Setup setup = around_body(turned_square(degrees), spacing);
            const Vec2 normal = direction(degrees - 90), along = direction(degrees);
            std::vector<FacePoint> points;  // on the lower face
            for (double s = -0.22; s < 0.221; s += 0.02)
                points.push_back({Vec2(0.5, 0.5) + 0.22 * normal + s * along, normal});
            for (const double towards : directions) {
                for (const double shaken : {0.0, 0.15}) {
                    CAPTURE(degrees, spacing, towards, shaken);
                    CHECK(worst_error(setup, shaken, towards, points) < 1e-6);
                }
            }
        }
    }
}

TEST_CASE("A linear pressure field is read exactly on floor, walls and roof, up to the corners", "[probe]") {
    for (const double spacing : {0.04, 0.02, 0.01}) {
        std::vector<FacePoint> points;
        for (const double s : {0.0, 0.1, 0.5, 0.8, 1.3, 2.6, 5.0}) {
            const double near = s * spacing;
            points.insert(points.end(), {{{near, 0}, Vec2::UnitY()},
                                         {{1 - near, 0}, Vec2::UnitY()},
                                         {{0, near}, Vec2::UnitX()},
                                         {{1, near}, -Vec2::UnitX()},
                                         {{near, 1}, -Vec2::UnitY()},
                                         {{1, 1 - near}, -Vec2::UnitX()}});
        }
        for (const double towards : directions) {
            for (const double shaken : {0.0, 0.1}) {
                CAPTURE(spacing, towards, shaken);
                CHECK(worst_error(full_tank(spacing), shaken, towards, points) < 1e-6);
            }
        }
    }
}

TEST_CASE("Only the fluid in front of a face counts, up to its edges", "[probe]") {
    constexpr double spacing = 0.02;
    Setup setup = around_body(corners_of({{-0.2, -0.04}, {0.2, 0.04}}), spacing);
    // 3000 Pa below the plate, nothing beside and above it
    set_initial_pressure(setup.fluid, setup.model,
                         [&](Phase, Vec2 at) { return at.y() < 0.46 ? 3000 + weight * (0.46 - at.y()) : 0; });
    const Simulation simulation = setup.simulate();
    for (const double s : {-0.2, -0.19, -0.1, 0.0, 0.17, 0.2}) {
        const std::vector<FacePoint> below = {{{0.5 + s, 0.46}, -Vec2::UnitY()}};
        CAPTURE(s);
        CHECK(face_pressures(simulation, below)[0] == Approx(3000).epsilon(1e-6));
    }
}

TEST_CASE("The surface of water under air is read to a ninth of a spacing of water", "[probe]") {
    for (const double spacing : {0.04, 0.02, 0.01}) {
        Setup setup(still_model(), tank, spacing, true);
        setup.fill(Phase::water, {{0, 0}, {1, 0.6}});
        setup.fill(Phase::air, {{0, 0.6}, {1, 1}});
        const auto still = [](double y) { return (y < 0.6 ? weight : 9.81) * (0.6 - y); };
        set_initial_pressure(setup.fluid, setup.model, [&](Phase, Vec2 at) { return still(at.y()); });
        const Simulation simulation = setup.simulate();
        for (double rows = -3; rows <= 3; rows += 0.5) {
            const Vec2 place(1, 0.6 + rows * spacing);
            const std::vector<FacePoint> points = {{place, -Vec2::UnitX()}};
            const double error = face_pressures(simulation, points)[0] - still(place.y());
            CAPTURE(spacing, rows, error);
            // each particle is carried along the slope of its own fluid, also beyond the surface
            CHECK(std::abs(error) < 0.11 * weight * spacing);
        }
    }
}

TEST_CASE("The surface of water alone is read to a hundredth of the head, and a dry face as zero",
          "[probe]") {
    for (const double spacing : {0.04, 0.02, 0.01}) {
        Setup setup(still_model(), tank, spacing, true);
        setup.model.negative_pressure = false;
        setup.model.water.eos.background_pressure = 0;
        setup.fill(Phase::water, {{0, 0}, {1, 0.6}});
        set_initial_pressure(setup.fluid, setup.model,
                             [](Phase, Vec2 at) { return weight * (0.6 - at.y()); });
        const Simulation simulation = setup.simulate();
        for (double rows = -3; rows <= 4; rows += 0.5) {
            const std::vector<FacePoint> points = {{{1, 0.6 + rows * spacing}, -Vec2::UnitX()}};
            const double pressure = face_pressures(simulation, points)[0];
            CAPTURE(spacing, rows, pressure);
            CHECK(pressure >= 0);
            if (rows > 3) CHECK(pressure == 0);
            CHECK(std::abs(pressure - std::max(0.0, -weight * rows * spacing)) < 0.01 * weight * 0.6);
        }
    }
}

TEST_CASE("A particle is carried along the slope of fluid at rest on its face", "[probe]") {
    constexpr double spacing = 0.02;
    Setup setup(still_model(), tank, spacing);
    const Vec2 normal = direction(60), along = direction(-30), place(0.5, 0.5);
    setup.fluid.add(Phase::water, place + 0.02 * normal + 0.004 * along, 0.4, 1002);
    const Simulation simulation = setup.simulate();
    const FluidState particle = simulation.fluid().state[0];
    const Vec2 to_point = place - particle.position(), acceleration(30, -70);
    const std::vector<FacePoint> points = {{place, normal, acceleration}};
    const double wet = 4 * particle.volume * simulation.kernel().value(to_point.norm());
    REQUIRE(wet < 1);
    const double rise = 1000 * (Vec2(0, -9.81).dot(to_point) + 0.02 * acceleration.dot(normal));
    CHECK(face_pressures(simulation, points)[0] ==
          Approx(wet * (particle.pressure - 1000 + wet * wet * rise)).epsilon(1e-9));
}

TEST_CASE("Water that bears no negative pressure reads none", "[probe]") {
    const bool bears = GENERATE(true, false);
    Setup setup(still_model(), tank, 0.02);
    setup.model.negative_pressure = bears;
    setup.model.water.eos.background_pressure = 0;
    setup.fluid.add(Phase::water, {0.985, 0.48}, 0.4, 1000);  // below the point
    const std::vector<FacePoint> points = {{{1, 0.5}, -Vec2::UnitX()}};
    const double pressure = face_pressures(setup.simulate(), points)[0];
    if (bears)
        CHECK(pressure < 0);
    else
        CHECK(pressure == 0);
}

TEST_CASE("A few particles of any pressure never make a peak", "[probe]") {
    constexpr double spacing = 0.02;
    Dice dice(3);
    for (int trial = 0; trial < 400; ++trial) {
        Setup setup(still_model(), tank, spacing, true);
        setup.model.gravity = Vec2::Zero();
        const int count = 1 + trial % 8;  // some of them in a thin jet along the face
        const double thickness = trial % 3 == 0 ? 0.001 : 0.02;
        for (int k = 0; k < count; ++k)
            setup.fluid.add(Phase::water, {0.5 + dice.symmetric(0.04), 0.021 + dice.symmetric(thickness)},
                            0.4, 1001 + dice.symmetric(1));
        const Simulation simulation = setup.simulate();
        double largest = 0;
        for (const FluidState& p : simulation.fluid().state) largest = std::max(largest, p.pressure - 1000);
        const std::vector<FacePoint> points = {{{0.5, 0}, Vec2::UnitY()}};
        CAPTURE(trial, count, thickness);
        // three in a triangle have an exact fit, which may lead beyond them
        CHECK(face_pressures(simulation, points)[0] <= 1.35 * largest);
        CHECK(face_pressures(simulation, points)[0] >= -0.35 * largest);
    }
}

TEST_CASE("Disordered pressures scatter a reading no more than a plain kernel mean", "[probe]") {
    constexpr double spacing = 0.02, size = 1000;
    Setup setup = full_tank(spacing);
    setup.model.gravity = Vec2::Zero();
    verification::shake(setup, 0.2, 5);
    Dice dice(11);
    set_initial_pressure(setup.fluid, setup.model, [&](Phase, Vec2) { return dice.symmetric(size); });
    const Simulation simulation = setup.simulate();
    double squares = 0, squares_of_mean = 0;
    for (double x = 0.1; x < 0.9; x += 0.01) {
        const std::vector<FacePoint> points = {{{x, 0}, Vec2::UnitY()}};
        squares += std::pow(face_pressures(simulation, points)[0], 2);
        squares_of_mean +=
            std::pow(verification::kernel_mean(
                         simulation, {x, 0},
                         [&](std::size_t i) { return simulation.fluid().state[i].pressure - 1000; }),
                     2);
    }
    // the same without the test of the fit: 2.2 times the squares of the mean
    CHECK(squares < 1.02 * squares_of_mean);
}

TEST_CASE("The largest mean over a patch is found wherever the patch lies", "[probe]") {
    const std::vector<double> values = {1, 5, 3, 0};
    CHECK(largest_mean(values, 1) == 5);
    CHECK(largest_mean(values, 2) == 4);
    CHECK(largest_mean(values, 4) == Approx(2.25));
    // half a value more on the side of the larger neighbour
    CHECK(largest_mean(values, 1.5) == Approx((5 + 0.5 * 3) / 1.5));
    CHECK(largest_mean(values, 2.5) == Approx((0.5 * 1 + 5 + 3) / 2.5));
    CHECK(largest_mean(std::vector<double>{-2, -1, -4}, 2) == -1.5);
}
