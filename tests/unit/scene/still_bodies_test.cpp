// SPDX-License-Identifier: BSD-3-Clause
// Fixed bodies of any shape and place in still water: what they displace, and the force of the first
// hundredths of a second.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solver/setup/cut_cells.hpp"
#include "solver/setup/lattice.hpp"
#include "tests/unit/scene/still_water.hpp"
#include "validation/run/assemble.hpp"

using namespace wetdeck;

namespace {

constexpr double g = 9.81;

Outline turned(const Outline& outline, double degrees) {
    const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
    Outline result;
    for (const Vec2& corner : outline) result.push_back(turn * corner);
    return result;
}

Outline polygon(int corners, double radius) {
    Outline result;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.3) / corners;
        result.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return result;
}

const Outline square = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};

struct Shape {
    const char* name;
    Outline outline;
    Vec2 centre;
};

/// In water of 0.8 x 0.6 m.
std::vector<Shape> shapes() {
    return {{"square that fits", square, {0.4, 0.3}},
            {"square between the rows", square, {0.4, 0.307}},
            {"square between rows and columns", square, {0.411, 0.293}},
            {"square heeled by 5 degrees", turned(square, 5), {0.4, 0.3}},
            {"square heeled by 20 degrees", turned(square, 20), {0.4, 0.3}},
            {"square on its corner", turned(square, 45), {0.4, 0.3}},
            {"triangle", {{-0.15, 0.1}, {0.0, -0.1}, {0.15, 0.1}}, {0.4, 0.3}},
            {"wedge of 20 degrees",
             {{-0.2, 0.0}, {0.0, -0.073}, {0.2, 0.0}, {0.2, 0.1}, {-0.2, 0.1}},
             {0.4, 0.3}},
            {"keel of 12 degrees within a cell", {{-0.05, 0.2}, {0.003, -0.08}, {0.05, 0.2}}, {0.407, 0.303}},
            {"circle", polygon(40, 0.12), {0.4, 0.3}},
            {"circle off the lattice", polygon(40, 0.12), {0.397, 0.311}},
            {"hexagon", polygon(6, 0.13), {0.4, 0.3}},
            {"step",
             {{-0.12, -0.1}, {0.12, -0.1}, {0.12, 0.0}, {0.0, 0.013}, {0.0, 0.1}, {-0.12, 0.1}},
             {0.4, 0.3}}};
}

Outline at(const Shape& shape) {
    Outline placed;
    for (const Vec2& corner : shape.outline) placed.push_back(shape.centre + corner);
    return placed;
}

Scene still(const Shape& shape) {
    std::vector<std::string> corners;
    for (const Vec2& corner : shape.outline)
        corners.push_back(fmt::format("[{:.12f}, {:.12f}]", corner.x(), corner.y()));
    const std::string position = fmt::format("[{}, {}]", shape.centre.x(), shape.centre.y());
    const std::string outline = fmt::format("[{}]", fmt::join(corners, ", "));
    return parse_scene(
        samples::still_water({"[0.8, 0.8]", "[0.0, 0.0, 0.8, 0.6]", "0.6", "35.0", position, outline}),
        "still.toml");
}

}  // namespace

TEST_CASE("a body displaces its own area of the lattice, at its own place", "[setup]") {
    for (const Shape& shape : shapes()) {
        for (const double spacing : {0.02, 0.0125, 0.01}) {
            CAPTURE(shape.name, spacing);
            FluidParticles fluid;
            fill_box(fluid, Phase::water, {{0, 0}, {0.8, 0.6}}, spacing, 1000);
            cut_cells(fluid, {at(shape)}, spacing);
            double area = 0;
            Vec2 moment = Vec2::Zero();
            for (std::size_t i = 0; i < fluid.size(); ++i) {
                const double volume = fluid.mass[i] / fluid.state[i].density;
                area += volume;
                moment += volume * fluid.state[i].position();
                CHECK(volume > 0.499 * spacing * spacing);
                CHECK(distance_to(at(shape), fluid.state[i].position()) > 0.199 * spacing);
            }
            const AreaMoments body = area_moments(at(shape));
            CHECK(area == Approx(0.48 - body.area).epsilon(1e-7));
            const Vec2 expected = 0.48 * Vec2(0.4, 0.3) - body.area * body.centroid;
            CHECK((moment - expected).norm() < 0.6 * spacing * spacing * spacing);
        }
    }
}

TEST_CASE("two bodies and two phases are cut out of one lattice", "[setup]") {
    FluidParticles fluid;
    fill_box(fluid, Phase::water, {{0, 0}, {0.8, 0.3}}, 0.02, 1000);
    fill_box(fluid, Phase::air, {{0, 0.3}, {0.8, 0.6}}, 0.02, 1);
    const std::vector<Outline> bodies = {at({"", turned(square, 30), {0.25, 0.3}}),
                                         at({"", turned(square, 10), {0.5, 0.31}})};
    cut_cells(fluid, bodies, 0.02);
    double area = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        area += fluid.mass[i] / fluid.state[i].density;
        CHECK((fluid.phase(i) == Phase::water) == (fluid.state[i].y < 0.3));
    }
    CHECK(area == Approx(0.48 - 0.08).epsilon(1e-7));
}

TEST_CASE("still water carries a fixed body from the start, whatever its shape", "[setup]") {
    for (const Shape& shape : shapes()) {
        for (const double spacing : {0.02, 0.01}) {
            CAPTURE(shape.name, spacing);
            Simulation simulation = assemble(still(shape), spacing, 1);
            double sum = 0, sideways = 0, lowest = 1e9, highest = 0;
            int steps = 0;
            while (simulation.time() < 0.03) {
                REQUIRE_FALSE(simulation.step(0.03 - simulation.time()));
                const Vec2 force = simulation.bodies()[0].force;
                sum += force.y();
                sideways += force.x();
                lowest = std::min(lowest, force.y());
                highest = std::max(highest, force.y());
                ++steps;
            }
            const double weight = 1000 * g * area_moments(shape.outline).area;
            // five spacings wide: its weight is a third of p l
            if (std::string(shape.name).starts_with("keel")) {
                CHECK(sum / steps == Approx(weight).epsilon(0.1));
                continue;
            }
            CHECK(sum / steps == Approx(weight).epsilon(0.04));
            CHECK(lowest > 0.9 * weight);
            CHECK(highest < 1.04 * weight);
            CHECK(std::abs(sideways / steps) < 0.04 * weight);
        }
    }
}

TEST_CASE("a slit too narrow for particles holds none, and the water beside it is at rest", "[setup]") {
    for (const double slit : {0.001, 0.003, 0.005, 0.007, 0.009}) {
        CAPTURE(slit);
        Simulation simulation = assemble(still({"", square, {0.4, 0.1 + slit}}), 0.02, 1);
        for (std::size_t i = 0; i < simulation.fluid().size(); ++i)
            CHECK(simulation.fluid().state[i].volume < 2 * 0.02 * 0.02);
        while (simulation.time() < 0.03) REQUIRE_FALSE(simulation.step(0.03 - simulation.time()));
        double fastest = 0;
        for (const FluidState& p : simulation.fluid().state) fastest = std::max(fastest, p.velocity().norm());
        CHECK(fastest < 0.2);
    }
}
