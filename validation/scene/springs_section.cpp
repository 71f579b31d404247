// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/springs_section.hpp"

#include <fmt/format.h>

#include <limits>

#include "validation/scene/motion_section.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A number that must not be negative.
double not_negative(const TomlTable& table, const char* key) {
    const double value = table.number_or(key, 0);
    if (value < 0) table.fail(key, "expected zero or a positive number");
    return value;
}

Curve read_table(const TomlTable& table) {
    Curve curve;
    for (const std::vector<double>& row : table.number_rows("table", 2)) {
        if (!curve.x.empty() && !(row[0] > curve.x.back()))
            table.fail("table", fmt::format("elongation {:.6g} follows {:.6g}, expected elongations that "
                                            "increase",
                                            row[0], curve.x.back()));
        curve.x.push_back(row[0]);
        curve.y.push_back(row[1]);
    }
    if (curve.x.size() < 2) table.fail("table", "expected at least two rows of elongation and pull");
    return curve;
}

void read_line(const TomlTable& table, const BodySpec& spec, Spring& spring) {
    spring.direction = Spring::Direction::line;
    spring.on_body = spec.in_body_frame(point(table, "on_body"));
    spring.on_earth = point(table, "on_earth");
    const double at_start = (spring.on_earth - spec.body.placed(spring.on_body)).norm();
    if (!(at_start > 0)) table.fail("on_earth", "is the same point as 'on_body' at the start");
    spring.free_length = table.number_or("free_length", at_start);
    if (spring.free_length < 0) table.fail("free_length", "expected zero or a positive length [m]");
    if (table.boolean_or("slack", false)) spring.play = {-infinity, 0};
}

Spring read_spring(const TomlTable& table, const BodySpec& spec) {
    Spring spring;
    if (table.has("on_body")) {
        read_line(table, spec, spring);
    } else {
        const std::string direction = table.choice("direction", {"x", "y", "rotation"});
        spring.direction = direction == "x"   ? Spring::Direction::x
                           : direction == "y" ? Spring::Direction::y
                                              : Spring::Direction::rotation;
        const bool turns = spring.direction == Spring::Direction::rotation;
        spring.rest = turns ? read_angle(table, "rest", 0) : table.number_or("rest", 0);
        if (table.has("play")) {
            const std::vector<double> play = table.numbers("play", 2);
            if (!(play[0] <= 0 && play[1] >= 0 && play[0] < play[1]))
                table.fail("play", "expected [low, high] about the rest, low at most 0, high at least 0");
            spring.play = {play[0], play[1]};
        }
    }
    spring.damping = not_negative(table, "damping");
    if (table.has("table")) {
        if (table.has("stiffness") || table.has("play"))
            table.fail("table", "takes the place of 'stiffness' and 'play', which are given too");
        spring.table = read_table(table);
    } else {
        spring.stiffness = not_negative(table, "stiffness");
        if (spring.stiffness == 0 && spring.damping == 0)
            table.fail_missing("stiffness", "expected a stiffness, a damping or a table");
    }
    table.finish();
    return spring;
}

}  // namespace

void read_springs(const TomlTable& table, BodySpec& spec) {
    for (const TomlTable& each : table.tables("springs"))
        spec.body.springs.push_back(read_spring(each, spec));
    if (!spec.body.springs.empty() && !spec.body.yields())
        table.fail("springs", "pull a body that no force moves: expected a motion in 'free'");
}

}  // namespace wetdeck
