// SPDX-License-Identifier: BSD-3-Clause
// Outlines of bodies: what is refused, and the layers of particles that are made of them.
#include "solver/setup/body_outline.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/core/errors.hpp"

using namespace wetdeck;

namespace {

constexpr double dx = 0.01;

WallParticles particles_of(const Outline& outline, double spacing = dx) {
    WallParticles walls;
    add_body_particles(walls, 0, outline, Vec2::Zero(), spacing, 3 * spacing);
    return walls;
}

Vec2 place(const WallParticles& walls, std::size_t k) {
    return {walls.body_point[k].x, walls.body_point[k].y};
}

Outline box(double width, double height) {
    return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

double closest_pair(const WallParticles& walls) {
    double closest = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < walls.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b)
            closest = std::min(closest, (place(walls, a) - place(walls, b)).norm());
    }
    return closest;
}

}  // namespace

TEST_CASE("Outlines that are no simple polygon are refused with the reason", "[outline]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(check_outline({{0, 0}, {1, 0}}), Catch::Contains("three corners"));
    CHECK_THROWS_WITH(check_outline({{0, 0}, {1, 0}, {nan, 1}}), Catch::Contains("finite"));
    CHECK_THROWS_WITH(check_outline({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), Catch::Contains("no simple polygon"));
    CHECK_THROWS_AS(check_outline({{0, 0}, {1, 0}, {2, 0}}), InputError);                  // no area
    CHECK_THROWS_AS(check_outline({{0, 0}, {1, 0}, {1, 1}, {1, 0}, {0, 1}}), InputError);  // a spike
    CHECK_NOTHROW(check_outline(box(1, 2)));
    const Outline clockwise = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    CHECK_NOTHROW(check_outline(clockwise));
}

TEST_CASE("Moments of a rectangle are those of the textbook", "[outline]") {
    const AreaMoments moments = area_moments({{1, 1}, {3, 1}, {3, 2}, {1, 2}});
    CHECK(moments.area == Approx(2));
    CHECK((moments.centroid - Vec2(2, 1.5)).norm() < 1e-14);
    CHECK(moments.second_moment == Approx(2 * (4 + 1) / 12.0));
}

TEST_CASE("A box that fits the lattice gets lattice particles", "[outline]") {
    const WallParticles walls = particles_of(box(0.1, 0.04));
    CHECK(walls.size() == 40);
    for (std::size_t k = 0; k < walls.size(); ++k) {
        const Vec2 cell = place(walls, k) / dx;
        CHECK(cell.x() - std::floor(cell.x()) == Approx(0.5).margin(1e-3));
        CHECK(cell.y() - std::floor(cell.y()) == Approx(0.5).margin(1e-3));
    }
    CHECK(closest_pair(walls) > 0.99 * dx);
}

TEST_CASE("Layers follow the faces of a wedge up to its keel", "[outline]") {
    const double deadrise = GENERATE(4.0, 10.0, 30.0, 60.0) * std::numbers::pi / 180;
    const Outline wedge = {{0, 0},
                           {0.25, 0.25 * std::tan(deadrise)},
                           {0.25, 0.25 * std::tan(deadrise) + 0.1},
                           {-0.25, 0.25 * std::tan(deadrise) + 0.1},
                           {-0.25, 0.25 * std::tan(deadrise)}};
    const WallParticles walls = particles_of(wedge);
    double nearest_keel = 1;
    std::ptrdiff_t edges = 0;
    for (std::size_t k = 0; k < walls.size(); ++k) {
        const double depth = -distance_to(wedge, place(walls, k)) / dx;
        const double layer = depth - 0.5;
        CHECK(std::abs(layer - std::lround(layer)) < 1e-3);  // on one of the three layers
        CHECK(depth < 3);
        nearest_keel = std::min(nearest_keel, place(walls, k).norm());
        const BodyPoint& point = walls.body_point[k];
        if (point.nx == 0 && point.ny == 0) {
            ++edges;
        } else {
            CHECK(std::hypot(point.nx, point.ny) == Approx(1));
        }
    }
    // one a layer where two faces turn by 75 degrees and more: the upper corners always, the keel and the
    // chines by the deadrise
    const double turns[] = {2 * deadrise, std::numbers::pi / 2 - deadrise, std::numbers::pi / 2 - deadrise};
    const auto sharp =
        std::count_if(std::begin(turns), std::end(turns), [](double turn) { return turn > 1.31; });
    CHECK(edges == 3 * (2 + sharp));
    // the first layer's own keel, half a spacing behind both faces; blunter ones count as a curve
    if (deadrise > 0.3) CHECK(nearest_keel == Approx(0.5 * dx / std::cos(deadrise)).epsilon(1e-3));
    CHECK(closest_pair(walls) >= 0.6 * dx);
}

TEST_CASE("A round outline of many short sides gets even layers without corners", "[outline]") {
    Outline round;
    for (int k = 0; k < 200; ++k)
        round.push_back(0.2 *
                        Vec2(std::cos(k * std::numbers::pi / 100), std::sin(k * std::numbers::pi / 100)));
    const WallParticles walls = particles_of(round);
    const double ring = std::numbers::pi * (0.2 * 0.2 - 0.17 * 0.17);
    CHECK(static_cast<double>(walls.size()) * dx * dx == Approx(ring).epsilon(0.02));
    CHECK(closest_pair(walls) > 0.9 * dx);
    for (const BodyPoint& p : walls.body_point)
        CHECK((Vec2(p.nx, p.ny) - Vec2(p.x, p.y).normalized()).norm() < 0.05);
}

TEST_CASE("A body thinner than the support is refused at that spacing and taken at a finer one",
          "[outline]") {
    // a catamaran's side wall of 0.012 m under a thick deck
    const Outline hull = {{0, 0}, {0.012, 0}, {0.012, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0, 0.2}};
    CHECK_THROWS_WITH(particles_of(hull, 0.005),
                      Catch::Contains("thinner") && Catch::Contains("a particle spacing of at most 0.004 m"));
    CHECK_NOTHROW(particles_of(hull, 0.004));
    // a sheet of 1 mm whose area is less than a tenth of the support squared
    const Outline sheet = {{0, 0}, {1, 0}, {1, 0.001}, {0, 0.001}};
    for (const double spacing : {0.04, 0.02, 0.005})
        CHECK_THROWS_WITH(particles_of(sheet, spacing), Catch::Contains("thinner"));
}

TEST_CASE("A wide wedge is never taken for a thin one", "[outline]") {
    // With this height the difference of the wedge and itself, shrunk and grown back, is the whole wedge in
    // Boost.Geometry 1.74; a few of a thousand heights do.
    const auto wedge = [](double height) { return Outline{{0, 0}, {0.25, height}, {-0.25, height}}; };
    CHECK_NOTHROW(particles_of(wedge(0.14433756729740643), 0.005));
    for (int k = 0; k < 300; ++k) {
        const double height = 0.25 * std::tan((12 + 0.19 * k) * std::numbers::pi / 180);
        CAPTURE(height);
        CHECK_NOTHROW(particles_of(wedge(height), 0.002));
    }
}

TEST_CASE("A wall of just three spacings under a deck is not hollow", "[outline]") {
    const Vec2 shift = GENERATE(Vec2(0, 0), Vec2(0.508, 0.570566), Vec2(-0.3, 1e3));
    Outline hull = {{0, 0}, {0.012, 0}, {0.012, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0, 0.2}};
    for (Vec2& corner : hull) corner += shift;
    const double spacing = 0.004;
    const WallParticles walls = particles_of(hull, spacing);
    for (double y = 0.02; y < 0.08; y += 0.0007) {
        double nearest = 1;
        for (std::size_t k = 0; k < walls.size(); ++k)
            nearest = std::min(nearest, (place(walls, k) - shift - Vec2(0.006, y)).norm());
        CHECK(nearest < 0.6 * spacing);
    }
}

TEST_CASE("The fluid makes room for a body and keeps its phases in order", "[outline]") {
    FluidParticles fluid;
    for (int k = 0; k < 20; ++k) fluid.add(Phase::water, {(k + 0.5) * dx, 0.005}, 0.1, 1000);
    for (int k = 0; k < 20; ++k) fluid.add(Phase::air, {(k + 0.5) * dx, 0.015}, 1e-4, 1);
    clear_fluid(fluid, {{0.05, -1}, {0.1, -1}, {0.1, 1}, {0.05, 1}}, dx);
    CHECK(fluid.size() == 30);
    CHECK(fluid.water == 15);
    for (const FluidState& p : fluid.state) CHECK((p.x < 0.05 || p.x > 0.1));
}
