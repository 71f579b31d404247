// SPDX-License-Identifier: BSD-3-Clause
// What a GHS geometry file holds, as it is written: Creative Systems, GHS User's Manual, appendix A,
// "Geometry File Format".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck::ghs {

constexpr double foot = 0.3048;  ///< [m]; a GHS file holds feet, whatever unit its header prefers

struct Point {
    Vec2 place = Vec2::Zero();  ///< to starboard and up [ft]
    int surface_code = 0;
    double radius = 0;  ///< of the arc to a neighbour of the same radius [ft]
    std::string line_code;
    std::size_t line = 0;  ///< of the file
};

struct Section {
    double location = 0;  ///< grows aft [ft]
    std::vector<Point> points;
    std::string source;
};

struct Shape {
    std::string name;
    std::vector<Section> sections;
    bool has_shell = false;
};

struct Component {
    std::string name;
    int side = 0;  ///< 1: as drawn, -1: mirrored, 0: one half, to be mirrored
    double effectiveness = 1;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< aft, to starboard, up [ft]
    Shape shape;
    std::string source;
    std::size_t line = 0;
};

/// A part with its components as they were defined before it.
struct Part {
    std::string name;
    int type = 1;  ///< 1 hull, 4 tank, 10 windage
    std::vector<Component> components;
};

struct Model {
    std::string title;
    std::optional<char> preferred_unit;  ///< 'M' or 'F', of the header
    std::vector<Shape> shapes;
    std::vector<Part> parts;
};

/// Throws DataError "NAME:LINE: what was expected" where the text is no such file or is damaged.
Model parse(const std::string& name, std::string_view text);

}  // namespace wetdeck::ghs
