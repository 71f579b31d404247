// SPDX-License-Identifier: BSD-3-Clause
// Cells that grow away from a box: what they fill, how they differ from their neighbours, and the walls they
// make.
#include "solver/setup/graded_lattice.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solver/core/errors.hpp"

using namespace wetdeck;

namespace {

constexpr double finest = 0.01;
const Box water{{0, 0}, {2.4, 1.2}}, air{{0, 1.2}, {2.4, 1.7}}, tank{{0, 0}, {2.4, 1.7}};

Grading around(Box box, double growth = 0.05, double coarsest = 4) {
    return {box, finest, growth, coarsest};
}

double area_of(const std::vector<Box>& cells) {
    double sum = 0;
    for (const Box& cell : cells) sum += (cell.high - cell.low).prod();
    return sum;
}

bool holds(const Box& box, Vec2 place) {
    return (place - box.low).minCoeff() >= 0 && (box.high - place).minCoeff() > 0;
}

std::size_t cells_at(const std::vector<Box>& cells, Vec2 place) {
    std::size_t count = 0;
    for (const Box& cell : cells) count += holds(cell, place);
    return count;
}

}  // namespace

TEST_CASE("Graded cells fill a region once, wherever their box lies", "[setup]") {
    const Box box = GENERATE(Box{{1.0, 1.0}, {1.4, 1.2}}, Box{{0.1, 0.5}, {0.3, 0.9}},
                             Box{{1.2, 1.2}, {1.2, 1.2}}, Box{{0, 0}, {0.4, 0.2}}, Box{{0, 1.2}, {2.4, 1.2}},
                             Box{{2.0, 0}, {2.4, 1.2}}, Box{{1.003, 0.507}, {1.111, 0.777}});
    const double growth = GENERATE(0.05, 0.1);
    const std::vector<Box> cells = graded_cells(water, around(box, growth));
    CHECK(area_of(cells) == Approx(2.4 * 1.2).epsilon(1e-12));
    for (int k = 0; k < 400; ++k) {
        const Vec2 place(2.4 * std::fmod(0.6180339887 * k, 1), 1.2 * std::fmod(0.7548776662 * k, 1));
        if (cells_at(cells, place) != 1) FAIL_CHECK("cells at " << place.transpose());
    }
}

TEST_CASE("Cells are the finest in the box and grow from there by their share up to the coarsest",
          "[setup]") {
    const Box box{{1.0, 1.0}, {1.4, 1.2}};
    const Grading grading = around(box);
    const std::vector<Box> cells = graded_cells(water, grading);
    CHECK(cells.size() < 2.4 * 1.2 / (finest * finest) / 6);
    double largest = 0;
    for (const Box& cell : cells) {
        const Vec2 size = cell.high - cell.low, middle = 0.5 * (cell.low + cell.high);
        const double expected = grading.spacing_at(middle);
        largest = std::max(largest, size.maxCoeff());
        if (holds(box, middle)) CHECK((size - Vec2(finest, finest)).norm() < 1e-12);
        // rings are stretched to fit between the box and the sides
        if (std::abs(std::sqrt(size.prod()) / expected - 1) > 0.1)
            FAIL_CHECK("cell at " << middle.transpose());
        if (size.maxCoeff() > 1.25 * size.minCoeff()) FAIL_CHECK("long cell at " << middle.transpose());
    }
    CHECK(largest > 3.9 * finest);
}

TEST_CASE("Both sides of the level have the same columns", "[setup]") {
    const Grading grading = around({{1.0, 1.0}, {1.4, 1.4}}, 0.1);
    std::vector<double> below, above;
    for (const Box& cell : graded_cells(water, grading))
        if (cell.high.y() > 1.2 - 1e-9) below.push_back(cell.low.x());
    for (const Box& cell : graded_cells(air, grading))
        if (cell.low.y() < 1.2 + 1e-9) above.push_back(cell.low.x());
    std::sort(below.begin(), below.end());
    std::sort(above.begin(), above.end());
    REQUIRE(below.size() == above.size());
    for (std::size_t k = 0; k < below.size(); ++k) CHECK(below[k] == Approx(above[k]).margin(1e-9));
}

TEST_CASE("Graded walls mirror the cells at the faces of the tank", "[setup]") {
    const Grading grading = around({{1.0, 1.0}, {1.4, 1.4}}, 0.1);
    std::vector<Box> cells = graded_cells(water, grading);
    const std::vector<Box> more = graded_cells(air, grading);
    cells.insert(cells.end(), more.begin(), more.end());
    constexpr int layers = 3;
    const WallParticles walls = graded_tank_walls(tank, cells, finest, layers);
    double area = 0;
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const Vec2 place(walls.state[n].x, walls.state[n].y), normal(walls.state[n].nx, walls.state[n].ny);
        CHECK_FALSE(holds(tank, place));
        CHECK(normal.norm() == Approx(1));
        const double spacing = finest / walls.fineness[n];
        CHECK(holds({tank.low - Vec2::Constant(1e-9), tank.high + Vec2::Constant(1e-9)},
                    place + (layers + 0.5) * 1.2 * spacing * normal));
        area += spacing * spacing;
    }
    double expected = 0;  // of the layers, corners included
    for (const Box& cell : cells) {
        const Vec2 size = cell.high - cell.low;
        const int x = (cell.low.x() < 1e-9) + (cell.high.x() > tank.high.x() - 1e-9);
        const int y = (cell.low.y() < 1e-9) + (cell.high.y() > tank.high.y() - 1e-9);
        expected += ((1 + layers * x) * (1 + layers * y) - 1) * size.prod();
    }
    CHECK(area == Approx(expected).epsilon(1e-3));
    // at a plane of symmetry there is no wall, and bed and lid run on beyond it
    const Box half{{1.2, 0}, {2.4, 1.2}};
    const WallParticles open = graded_tank_walls(half, graded_cells(half, around({{1.2, 1.0}, {1.4, 1.2}})),
                                                 finest, layers, DomainEnds::mirror_left);
    std::size_t beyond = 0;
    for (const WallState& wall : open.state) {
        const bool between = wall.y > 0 && wall.y < 1.2;
        if (wall.x < 1.2) ++beyond;
        CHECK_FALSE((wall.x < 1.2 && between));
        CHECK_FALSE((wall.x < 1.2 && wall.nx != 0));
    }
    CHECK(beyond == 2 * layers * layers);
}

TEST_CASE("A box that fills a side which its spacing does not fit is refused", "[setup]") {
    CHECK_THROWS_AS(graded_cells({{0, 0}, {0.235, 1}}, {{{0, 1}, {0.235, 1}}, 0.1, 0.05, 4}), InputError);
    CHECK_THROWS_WITH(graded_cells({{0, 0}, {0.235, 1}}, {{{0, 1}, {0.235, 1}}, 0.1, 0.05, 4}),
                      Catch::Contains("does not fit"));
}
