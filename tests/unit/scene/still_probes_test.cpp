// SPDX-License-Identifier: BSD-3-Clause
// Each type of probe in still water, at three spacings, against the exact value.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <functional>

#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/scene/still_water.hpp"
#include "validation/run/assemble.hpp"

using namespace wetdeck;

namespace {

constexpr double weight = 1000 * 9.81, depth = 0.2;

/// A basin of 0.4 x 0.3 m, 0.2 m deep, water alone; a body that never moves, of 0.12 x 0.08 m.
std::string still(const std::string& body_position, const std::string& water, const std::string& probe) {
    return samples::still_water({"[0.4, 0.3]", water, "0.2", "20.0", body_position,
                                 "[[0.0, 0.0], [0.12, 0.0], [0.12, 0.08], [0.0, 0.08]]"},
                                "[[probes]]\nname = \"probe\"\n" + probe);
}

const std::string submerged = "[0.12, 0.06]", above = "[0.12, 0.21]";
const std::string full = "[0.0, 0.0, 0.4, 0.2]";

std::vector<double> reading(const std::string& text, double particle_spacing, double until = 0) {
    const Scene scene = parse_scene(text, "still.toml");
    Simulation simulation = assemble(scene, particle_spacing, 1);
    while (simulation.time() < until) REQUIRE_FALSE(simulation.step(until - simulation.time()));
    std::vector<double> values;
    scene.probes.back().sample(simulation, values);
    return values;
}

struct Gauge {
    std::string name, probe;
    std::function<double(std::size_t)> exact;  ///< of a column of the probe
};

/// Pressure at a height, whatever the column.
auto pressure_at(double height) {
    return [height](std::size_t) { return std::max(0.0, weight * (depth - height)); };
}

std::string wall(const std::string& centre, const std::string& diameter) {
    return "type = \"wall_pressure\"\ncentre = " + centre + "\ndiameter = " + diameter;
}

std::string on_body(const std::string& centre, const std::string& diameter) {
    return "type = \"body_pressure\"\ncentre = " + centre + "\ndiameter = " + diameter;
}

std::string along_face(const std::string& from, const std::string& to) {
    return "type = \"face_pressure\"\npoints = 4\nfrom = " + from + "\nto = " + to;
}

std::string along_wall(const std::string& from, const std::string& to) {
    return along_face(from, to) + "\nbody = \"tank\"";
}

const std::vector<Gauge> pressures = {
    {"floor", wall("[0.3, 0.0]", "0.06"), pressure_at(0)},
    {"floor, one spacing wide", wall("[0.3, 0.0]", "0.02"), pressure_at(0)},
    {"floor, up to the corner", wall("[0.01, 0.0]", "0.02"), pressure_at(0)},
    {"left wall", wall("[0.0, 0.1]", "0.04"), pressure_at(0.1)},
    {"right wall, down to the floor", wall("[0.4, 0.02]", "0.04"), pressure_at(0.02)},
    {"right wall, small, down to the floor", wall("[0.4, 0.01]", "0.02"), pressure_at(0.01)},
    {"roof, dry", wall("[0.2, 0.3]", "0.04"), pressure_at(0.3)},
    {"left wall, dry", wall("[0.0, 0.27]", "0.02"), pressure_at(0.27)},
    {"bottom of a body", on_body("[0.06, 0.0]", "0.04"), pressure_at(0.06)},
    {"bottom of a body, up to its edge", on_body("[0.01, 0.0]", "0.02"), pressure_at(0.06)},
    {"top of a body", on_body("[0.06, 0.08]", "0.04"), pressure_at(0.14)},
    {"side of a body", on_body("[0.12, 0.04]", "0.04"), pressure_at(0.1)},
    {"along the bottom", along_face("[0.0, 0.0]", "[0.12, 0.0]"), pressure_at(0.06)},
    {"along the top, from right to left", along_face("[0.12, 0.08]", "[0.0, 0.08]"), pressure_at(0.14)},
    {"along a side, downwards", along_face("[0.0, 0.08]", "[0.0, 0.0]"),
     [](std::size_t k) { return weight * (depth - (0.14 - 0.01 - 0.02 * static_cast<double>(k))); }},
    {"along the floor", along_wall("[0.0, 0.0]", "[0.4, 0.0]"), pressure_at(0)},
    {"along the floor, leftwards", along_wall("[0.4, 0.0]", "[0.04, 0.0]"), pressure_at(0)},
    {"up the right wall from the corner", along_wall("[0.4, 0.0]", "[0.4, 0.16]"),
     [](std::size_t k) { return weight * (depth - (0.02 + 0.04 * static_cast<double>(k))); }},
    {"down the left wall", along_wall("[0.0, 0.16]", "[0.0, 0.0]"),
     [](std::size_t k) { return weight * (depth - (0.14 - 0.04 * static_cast<double>(k))); }},
    {"along the roof, dry", along_wall("[0.1, 0.3]", "[0.3, 0.3]"), pressure_at(0.3)},
};

}  // namespace

TEST_CASE("pressures in still water are right to a thousandth of the head at any spacing", "[probe]") {
    for (const double spacing : {0.02, 0.01, 0.005}) {
        for (const Gauge& gauge : pressures) {
            const std::vector<double> values = reading(still(submerged, full, gauge.probe), spacing);
            for (std::size_t k = 0; k < values.size(); ++k) {
                CAPTURE(spacing, gauge.name, k, values[k], gauge.exact(k));
                CHECK(std::abs(values[k] - gauge.exact(k)) < 0.001 * weight * depth);
            }
        }
    }
}

TEST_CASE("pressures on slanted faces in still water are right to a thousandth of the head", "[probe]") {
    const std::string counter = "[[0.0, -0.04], [0.05, 0.01], [0.0, 0.03], [-0.04, 0.01]]",
                      clockwise = "[[0.0, -0.04], [-0.04, 0.01], [0.0, 0.03], [0.05, 0.01]]";
    const Vec2 corners[] = {{0, -0.04}, {0.05, 0.01}, {0, 0.03}, {-0.04, 0.01}};
    for (const double spacing : {0.01, 0.005}) {
        for (const std::string& outline : {counter, clockwise}) {
            for (std::size_t k = 0; k < 4; ++k) {
                const Vec2 from = corners[k], to = corners[(k + 1) % 4];
                const std::string probe = along_face(fmt::format("[{}, {}]", from.x(), from.y()),
                                                     fmt::format("[{}, {}]", to.x(), to.y()));
                const std::string scene =
                    samples::still_water({"[0.4, 0.3]", full, "0.2", "20.0", "[0.2, 0.1]", outline},
                                         "[[probes]]\nname = \"probe\"\n" + probe);
                const std::vector<double> values = reading(scene, spacing);
                for (std::size_t n = 0; n < values.size(); ++n) {
                    const double height =
                        0.1 + from.y() + (static_cast<double>(n) + 0.5) / 4 * (to.y() - from.y());
                    CAPTURE(spacing, outline, k, n, values[n]);
                    CHECK(std::abs(values[n] - weight * (depth - height)) < 0.001 * weight * depth);
                }
            }
        }
    }
}

TEST_CASE("gauges on floor and body keep their pressure while the water settles", "[probe]") {
    for (const double spacing : {0.02, 0.01}) {
        for (const std::size_t number : {std::size_t{0}, std::size_t{2}, std::size_t{4}, std::size_t{8}}) {
            const Gauge& gauge = pressures[number];
            const double value = reading(still(submerged, full, gauge.probe), spacing, 0.05).at(0);
            CAPTURE(spacing, gauge.name, value, gauge.exact(0));
            // the water rings: 1 % of the head and the pressure of a tenth of a spacing
            CHECK(std::abs(value - gauge.exact(0)) < 0.01 * weight * depth + 0.1 * weight * spacing);
        }
    }
}

TEST_CASE("depths, surfaces, fronts and gaps in still water are exact at any spacing", "[probe]") {
    struct Row {
        std::string position, water, probe;
        double exact;
    };
    const std::string left_column = "[0.0, 0.0, 0.1, 0.2]", right_column = "[0.3, 0.0, 0.4, 0.2]";
    const std::string both = left_column + ", " + right_column, front = "type = \"front\"\n";
    const std::vector<Row> rows = {
        {above, full, "type = \"water_depth\"\nx = 0.1\nwidth = 0.04", depth},
        {above, full, "type = \"water_depth\"\nx = 0.4\nwidth = 0.1", depth},
        {above, full, "type = \"water_depth\"\nx = 0.0\nwidth = 0.033", depth},
        {above, full, "type = \"water_depth\"\nx = 0.39\nwidth = 0.1", depth},
        {above, left_column, "type = \"water_depth\"\nx = 0.1\nwidth = 0.04", 0.5 * depth},
        {above, full, "type = \"free_surface\"\nlow = 0.0\nhigh = 0.4\npoints = 20", depth},
        {above, left_column, front, 0.1},
        {above, left_column, front + "direction = \"up\"", 0.2},
        {above, right_column, front + "direction = \"left\"", 0.3},
        {above, full, front + "direction = \"down\"", 0.0},
        {above, both, front + "x_range = [0.0, 0.25]", 0.1},
        {above, both, front + "direction = \"left\"\nx_range = [0.15, 0.4]", 0.3},
        {above, both, front + "x_range = [0.12, 0.28]", 0.12},
        {above, left_column, front + "x_range = [0.04, 0.08]", 0.08},
        {above, left_column, front + "y_range = [0.21, 0.25]", 0.0},
        {above, full, "type = \"air_film\"\nfrom = [0.0, 0.0]\nto = [0.12, 0.0]", 0.01},
        {above, full, "type = \"air_film\"\nfrom = [0.12, 0.0]\nto = [0.0, 0.0]", 0.01},
    };
    for (const double spacing : {0.02, 0.01, 0.005}) {
        for (const Row& row : rows) {
            for (const double value : reading(still(row.position, row.water, row.probe), spacing)) {
                CAPTURE(spacing, row.probe, value, row.exact);
                CHECK(value == Approx(row.exact).margin(1e-9));
            }
        }
    }
}
