// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/front_probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "solver/probes/front.hpp"
#include "validation/scene/faces.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::array<const char*, 2> range_keys = {"x_range", "y_range"};

struct Direction {
    const char* name;
    int axis;
    bool forward;
    const char* wall;    ///< that the front meets in the end
    const char* extent;  ///< what the series is
};

constexpr std::array<Direction, 4> directions = {{{"right", 0, true, "the right wall", "largest x"},
                                                  {"left", 0, false, "the left wall", "smallest x"},
                                                  {"up", 1, true, "the roof", "largest y"},
                                                  {"down", 1, false, "the floor", "smallest y"}}};

const Direction& read_direction(const TomlTable& table) {
    std::vector<std::string> names;
    for (const Direction& direction : directions) names.emplace_back(direction.name);
    const std::string name = table.choice("direction", names, names.front());
    return directions[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
}

/// All of the axis where the file does not say: water that has left the tank by a rounding error counts.
void read_range(const TomlTable& table, int axis, const Box& tank, Box& range) {
    const char* key = range_keys[static_cast<std::size_t>(axis)];
    if (!table.has(key)) return;
    const std::vector<double> ends = table.numbers(key, 2);
    if (!(ends[0] < ends[1]))
        table.fail(key,
                   fmt::format("is {:.6g} to {:.6g} m, expected a begin below its end", ends[0], ends[1]));
    if (ends[0] >= tank.high[axis] || ends[1] <= tank.low[axis])
        table.fail(key, fmt::format("{:.6g} to {:.6g} m lies outside the tank, expected a part of {:.6g} to "
                                    "{:.6g} m",
                                    ends[0], ends[1], tank.low[axis], tank.high[axis]));
    range.low[axis] = ends[0];
    range.high[axis] = ends[1];
}

/// The part of the tank in which the probe looks.
Box in_tank(const Box& range, const Box& tank) {
    return {range.low.cwiseMax(tank.low), range.high.cwiseMin(tank.high)};
}

void refuse_covered_range(const TomlTable& table, const Scene& scene, const Box& looked_at) {
    const auto [low, high] = looked_at;
    const std::array<Vec2, 5> points = {
        low, high, {low.x(), high.y()}, {high.x(), low.y()}, 0.5 * (low + high)};
    const auto covered = [&scene](const Vec2& point) { return covered_for_good(scene, point).has_value(); };
    if (std::all_of(points.begin(), points.end(), covered))
        table.fail(table.has("x_range") ? "x_range" : "y_range",
                   fmt::format("lies in {}, which never moves", *covered_for_good(scene, low)));
}

/// Whether some of the water that counts reaches the far side of the range at the start.
bool has_arrived(const Scene& scene, const Direction& direction, const Box& looked_at) {
    constexpr double least = 1e-9;
    return std::any_of(scene.water_boxes.begin(), scene.water_boxes.end(), [&](const Box& water) {
        const Box common = in_tank(water, looked_at);
        if ((common.high - common.low).minCoeff() < least) return false;
        const double left = direction.forward ? looked_at.high[direction.axis] - common.high[direction.axis]
                                              : common.low[direction.axis] - looked_at.low[direction.axis];
        return left < least;
    });
}

std::string doubt_of(const TomlTable& table, const Direction& direction, const Box& range,
                     const Box& looked_at) {
    const double end = (direction.forward ? looked_at.high : looked_at.low)[direction.axis];
    const bool at_wall =
        direction.forward ? range.high[direction.axis] > end : range.low[direction.axis] < end;
    return fmt::format(
        "{}: is {}, and water touches {} ({} = {:.6g} m) at the start: the front would read {:.6g} m "
        "as long as it does; expected the direction in which the water runs, or x_range and "
        "y_range without that water",
        table.place_of("direction"), direction.name, at_wall ? direction.wall : "the end of the range",
        direction.axis == 0 ? "x" : "y", end, end);
}

std::string description_of(const Direction& direction, const Box& range) {
    std::string text = fmt::format("{} that water reaches", direction.extent);
    for (const int axis : {0, 1}) {
        if (range.low[axis] == -unbounded) continue;
        text += fmt::format(", of water at {} = {:.6g} to {:.6g} m", axis == 0 ? "x" : "y", range.low[axis],
                            range.high[axis]);
    }
    return text;
}

}  // namespace

Probe read_front(const TomlTable& table, const Scene& scene) {
    const Direction& direction = read_direction(table);
    FrontProbe front{
        direction.axis, direction.forward, {Vec2::Constant(-unbounded), Vec2::Constant(unbounded)}};
    for (const int axis : {0, 1}) read_range(table, axis, scene.tank, front.range);
    const Box looked_at = in_tank(front.range, scene.tank);
    refuse_covered_range(table, scene, looked_at);
    Probe probe;
    probe.series.description = description_of(direction, front.range);
    if (has_arrived(scene, direction, looked_at))
        probe.doubts.push_back(doubt_of(table, direction, front.range, looked_at));
    probe.sample = scalar_reading([front](const Simulation& s) { return front_position(s, front); });
    return probe;
}

}  // namespace wetdeck
