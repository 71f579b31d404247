// SPDX-License-Identifier: BSD-3-Clause
// Boxes of fluid and tank walls.
#include "solver/setup/lattice.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "solver/core/errors.hpp"

using namespace wetdeck;

namespace {

FluidParticles box_of_water(Vec2 size, double spacing) {
    FluidParticles fluid;
    fill_box(fluid, Phase::water, {{0.1, -0.2}, Vec2(0.1, -0.2) + size}, spacing, 1000);
    return fluid;
}

const Box tank{{0, 0}, {1.0, 0.5}};

}  // namespace

TEST_CASE("A box holds the particles that its sides give, half a spacing from its edges", "[lattice]") {
    const FluidParticles fluid = box_of_water({0.6, 0.3}, 0.05);
    REQUIRE(fluid.size() == 12 * 6);
    CHECK(fluid.water == fluid.size());
    Box extent{fluid.state[0].position(), fluid.state[0].position()};
    for (const FluidState& p : fluid.state) {
        extent.low = extent.low.cwiseMin(p.position());
        extent.high = extent.high.cwiseMax(p.position());
        CHECK(p.velocity() == Vec2::Zero());
    }
    CHECK((extent.low - Vec2(0.125, -0.175)).norm() < 1e-14);
    CHECK((extent.high - Vec2(0.675, 0.075)).norm() < 1e-14);
}

TEST_CASE("The masses of a box add up to density times area, also where the spacing is stretched",
          "[lattice]") {
    const double side = GENERATE(0.6, 0.605, 0.595);
    const FluidParticles fluid = box_of_water({side, 0.3}, 0.05);
    CHECK(fluid.size() == 12 * 6);
    const double mass = std::accumulate(fluid.mass.begin(), fluid.mass.end(), 0.0);
    CHECK(mass == Approx(1000 * side * 0.3).epsilon(1e-13));
    CHECK(fluid.state[5].volume == Approx(fluid.mass[5] / 1000).epsilon(1e-15));
}

TEST_CASE("A spacing that does not fit is refused with the side that it does not fit", "[lattice]") {
    // 0.63 / 0.05 = 12.6: 13 particles would be 3 % too close
    CHECK_THROWS_AS(box_of_water({0.63, 0.3}, 0.05), InputError);
    CHECK_THROWS_WITH(
        box_of_water({0.63, 0.3}, 0.05),
        Catch::Contains("0.05 m does not fit the side of 0.63 m") && Catch::Contains("12.60 particles"));
    CHECK(spacing_fits(0.3, 0.05));
    CHECK_FALSE(spacing_fits(0.63, 0.05));
    CHECK(spacing_fits(0.63, 0.048));  // 13 of 0.04846, 1 % wider
    CHECK_THROWS_WITH(box_of_water({0.3, 0.63}, 0.05), Catch::Contains("side of 0.63 m"));
}

TEST_CASE("Water cannot be added after air", "[lattice]") {
    FluidParticles fluid;
    fill_box(fluid, Phase::air, {{0, 0}, {0.1, 0.1}}, 0.05, 1);
    CHECK(fluid.water == 0);
    CHECK_THROWS_AS(fill_box(fluid, Phase::water, {{0, 0}, {0.1, 0.1}}, 0.05, 1000), InputError);
}

TEST_CASE("A tank has as many layers of wall particles as the support needs", "[lattice][wall]") {
    const double support = GENERATE(0.075, 0.125, 0.15, 0.16);
    const int layers = support < 0.1 ? 2 : support < 0.151 ? 3 : 4;
    const WallParticles walls = tank_walls(tank, 0.05, support);
    CHECK(walls.size() == static_cast<std::size_t>((20 + 2 * layers) * (10 + 2 * layers) - 20 * 10));
    double deepest = 0, shallowest = 1;
    for (const WallState& w : walls.state) {
        const double depth = std::max({-w.x, w.x - 1.0, -w.y, w.y - 0.5});
        deepest = std::max(deepest, depth);
        shallowest = std::min(shallowest, depth);
    }
    CHECK(shallowest == Approx(0.025));
    CHECK(deepest == Approx((layers - 0.5) * 0.05));
}

TEST_CASE("Wall normals point into the tank, those of corners to the corner", "[lattice][wall]") {
    std::size_t wrong = 0, corners = 0;
    for (const WallState& w : tank_walls(tank, 0.05, 0.125).state) {
        const double inward_x = w.x < 0 ? 1 : w.x > 1.0 ? -1 : 0, inward_y = w.y < 0 ? 1 : w.y > 0.5 ? -1 : 0;
        Vec2 expected(inward_x, inward_y);
        if (inward_x != 0 && inward_y != 0) {
            ++corners;
            expected = Vec2(w.x < 0 ? 0 : 1.0, w.y < 0 ? 0 : 0.5) - Vec2(w.x, w.y);
        }
        wrong += (Vec2(w.nx, w.ny) - expected.normalized()).norm() > 1e-12;
        wrong += w.vx != 0 || w.vy != 0 || w.ax != 0 || w.ay != 0;
    }
    CHECK(wrong == 0);
    CHECK(corners == 4 * 3 * 3);
}

TEST_CASE("Wall particles stand opposite the fluid particles of a stretched lattice", "[lattice][wall]") {
    // 1.01 m with 20 particles of 0.0505 m
    const Box wide{{0, 0}, {1.01, 0.5}};
    FluidParticles fluid;
    fill_box(fluid, Phase::water, wide, 0.05, 1000);
    const WallParticles walls = tank_walls(wide, 0.05, 0.125);
    for (const FluidState& p : fluid.state) {
        std::size_t below = 0;
        for (const WallState& w : walls.state) below += w.y < 0 && std::abs(w.x - p.x) < 1e-12;
        if (below != 3) FAIL_CHECK("no column of wall below x = " << p.x);
    }
    CHECK(fluid.size() == 200);
}
