// SPDX-License-Identifier: BSD-3-Clause
// Small files of sections, made up, and what is said against them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "solver/core/errors.hpp"
#include "validation/sections/section_figures.hpp"
#include "validation/sections/section_file.hpp"

namespace wetdeck::samples {

constexpr double foot = 0.3048;  // [m], by definition since 1959

inline double area_of(const Station& station) {
    double area = 0;
    for (const SectionOutline& outline : station.outlines) area += figures_of(outline).area;
    return area;
}

/// One section of a GHS shape: its location and the lines of its points.
struct GhsSection {
    double location;
    std::vector<std::string> points;
};

inline std::string ghs_shape(const std::string& name, const std::vector<GhsSection>& sections) {
    std::string text = fmt::format("*\n{}\n{}\n", name, sections.size());
    for (const GhsSection& section : sections) {
        text += fmt::format("{},{}\n", section.location, section.points.size());
        for (const std::string& point : section.points) text += point + "\n";
    }
    return text + "0.,0.,0.\n";
}

inline std::string ghs_component(const std::string& name, int side, const std::string& shape,
                                 const std::string& effectiveness = "1.",
                                 const std::string& shift = "0.,0.,0.") {
    return fmt::format("**\n{}\n{}\n{}\n{}\n{}\n", name, side, effectiveness, shift, shape);
}

inline std::string ghs_part(const std::string& name, int type, const std::vector<std::string>& components) {
    std::string text =
        fmt::format("***\n{}\nSEA WATER\n{}\n1.025\n0.,0.,0.\n{}\n", name, type, components.size());
    for (const std::string& component : components) text += component + "\n";
    return text;
}

inline std::string ghs_file(const std::string& records, const std::string& header = "P:F\nN:1\n") {
    return "Made up for a test\n" + header + records + "****\n";
}

/// A file of one hull of one component.
inline std::string ghs_hull(const std::vector<GhsSection>& sections, int side = 0) {
    return ghs_file(ghs_shape("HULL", sections) + ghs_component("HULL.C", side, "HULL") +
                    ghs_part("HULL", 1, {"HULL.C"}));
}

/// Groups of a drawing: "0 LINE|8 HULL|10 1.5", one code and value between two bars.
inline std::string groups(const std::string& text) {
    std::string out;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('|', begin), text.size());
        const std::string group = text.substr(begin, end - begin);
        const std::size_t space = std::min(group.find(' '), group.size());
        out += "  " + group.substr(0, space) + "\r\n" +
               (space < group.size() ? group.substr(space + 1) : std::string()) + "\r\n";
        begin = end + 1;
    }
    return out;
}

inline std::string dxf_section(const std::string& name, const std::string& content) {
    return groups("0 SECTION|2 " + name) + content + groups("0 ENDSEC");
}

/// A drawing in metres of these entities.
inline std::string drawing(const std::string& entities, const std::string& before = "", int unit = 6) {
    return groups("999 made up for a test") +
           dxf_section("HEADER", groups("9 $ACADVER|1 AC1015|9 $INSUNITS|70 " + std::to_string(unit))) +
           before + dxf_section("ENTITIES", groups(entities)) + groups("0 EOF");
}

/// A polyline of corners "x y" or "x y bulge".
inline std::string light_polyline(const std::string& layer, int bits,
                                  const std::vector<std::vector<double>>& corners,
                                  const std::string& more = "") {
    std::string text = fmt::format("0 LWPOLYLINE|8 {}|90 {}|70 {}{}", layer, corners.size(), bits, more);
    for (const auto& corner : corners) {
        text += fmt::format("|10 {}|20 {}", corner[0], corner[1]);
        if (corner.size() > 2) text += fmt::format("|42 {}", corner[2]);
    }
    return text;
}

template <class Read>
std::string refusal_of_reading(const Read& read) {
    try {
        read();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was said";
}

}  // namespace wetdeck::samples
