// SPDX-License-Identifier: BSD-3-Clause
// Files of corners as spreadsheets and scripts write them, and half sections that do not meet the axis.
#include <algorithm>
#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "validation/scene/outline_file.hpp"

using namespace wetdeck;
using Catch::Contains;
using Catch::StartsWith;

namespace {

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(parse_outline("hull.csv", text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("Corners are the same whatever wrote them", "[outline][lab]") {
    const std::string text = GENERATE(values<std::string>({
        "0,0\n0.06,0.015\n0.27,-0.26\n",
        "\xEF\xBB\xBF"
        "0,0\n0.06,0.015\n0.27,-0.26\n",
        "\xEF\xBB\xBFx [m],y [m]\r\n0,0\r\n0.06,0.015\r\n0.27,-0.26\r\n",
        "0;0\n0.06;0.015\n0.27;-0.26\n",
        "0\t0\n0.06\t0.015\n0.27\t-0.26\n",
        "0 0\n 0.06   0.015\n0.27\t -0.26",
        "0,0,\n0.06,0.015,,\n0.27,-0.26,\n,,\n",
        "0;0;\n0.06;0.015;\n;;\n0.27;-0.26;\n",
        "+0.000,+0.000\n+0.06,+1.5e-2\n+.27,-.26\n",
        "# section 7\n0,0 # keel\n\n# bilge\n0.06,0.015\n0.27,-0.26#deck\n",
        "half breadth,height\n[m],[m]\n0,0\n0.06,0.015\n0.27,-0.26\n",
        "x,y\n(m),(m)\n0,0\n0.06,0.015\n0.27,-0.26\n",
        "x [mm],y [mm]\n0,0\n60,15\n270,-260\n",
        "x [cm];y [m]\n0;0\n6;0.015\n27;-0.26\n",
        "half breadth, height [mm]\n0,0\n60,15\n270,-260\n",
        "x (mm) y (mm)\n0 0\n60 15\n270 -260\n",
        "# x [mm], y [mm]\n0,0\n60,15\n270,-260\n",
        "\"x\",\"y\"\n\"0\",\"0\"\n\"0.06\",\"0.015\"\n\"0.27\",\"-0.26\"\n",
        "0,0\n0.06,0.015\n0.27,-0.26\n0,0\n",
    }));
    INFO(text);
    const Outline corners = parse_outline("hull.csv", text);
    const Outline expected = {{0, 0}, {0.06, 0.015}, {0.27, -0.26}};
    REQUIRE(corners.size() == expected.size());
    for (std::size_t k = 0; k < corners.size(); ++k) CHECK((corners[k] - expected[k]).norm() < 1e-15);
}

TEST_CASE("A file of corners that could be read in two ways, or in none, is refused", "[outline][lab]") {
    const std::string two = "expected two numbers, x and y [m]",
                      comma = two + "; decimal commas are not read";
    const auto [text, message] = GENERATE_COPY(table<std::string, std::string>({
        {"0,000;0,000\n0,060;0,015\n0,270;0,260\n", "hull.csv:1: " + comma},
        {"0,000 0,000\n0,060 0,015\n0,270 0,260\n", "hull.csv:1: " + comma},
        {"0,000\t0,000\n0,060\t0,015\n", "hull.csv:1: " + comma},
        {"0,000,0,000\n0,060,0,015\n", "hull.csv:1: " + comma},
        {"0;0\n0,5;1\n1;1\n", "hull.csv:2: " + comma},
        {"\"0,5\",\"1,5\"\n", "hull.csv:1: " + comma},
        {"0;0\n0,5\n1;1\n", "hull.csv:2: numbers between ',', between ';' in the lines before"},
        {"0.o,0\n1,0\n0,1\n", "hull.csv:1: " + two},
        {"keel,0\n1,0\n0,1\n0,2\n", "hull.csv:1: " + two},
        {"Section 7\n1,0\n0,1\n0,2\n",
         "hull.csv:1: " + two + ", or names without a number; a title begins with '#'"},
        {"1,0,0\n2,1,0\n3,0,1\n", "hull.csv:1: " + two},
        {"x,y\nhalf section\n0,0\n", "hull.csv:2: " + two},
        {"x,y\n[m],[m]\n[m],[m]\n0,0\n", "hull.csv:3: " + two},
        {std::string("\xFF\xFE"
                     "0\0,\0"
                     "0\0\n\0",
                     10),
         "hull.csv:1: UTF-16 text, expected UTF-8"},
        {std::string("0\0,\0", 4), "hull.csv:1: holds NUL bytes"},
        {"0,0\r1,0\r0,1\r", "hull.csv:1: the line ends with a lone carriage return"},
        {"0,0\n1,0\r0,1\n", "hull.csv:2: the line ends with a lone carriage return"},
        {"x [s],y [m]\n0,0\n1,0\n0,1\n", "hull.csv:1: the unit 's' is none of length"},
        {"x [furlongs?],y\n0,0\n1,0\n0,1\n", "hull.csv:1: the unit 'furlongs?' is none of length"},
        {"y [m],x [m]\n0,0\n1,0\n0,1\n",
         "hull.csv:1: names 'y [m]' before 'x [m]', expected the columns x, y"},
        {"height [m],half breadth [m]\n0,0\n1,0\n0,1\n",
         "hull.csv:1: names 'height [m]' before 'half breadth [m]'"},
        {"Draught [m];Beam [m]\n0;0\n1;0\n0;1\n", "hull.csv:1: names 'Draught [m]' before 'Beam [m]'"},
        {"x_mm,y_mm\n0,0\n1,0\n0,1\n", "hull.csv:1: 'x_mm' names a unit, expected it in brackets"},
        {"x,y\nmm,mm\n0,0\n1,0\n0,1\n", "hull.csv:2: " + two},
        {"0,0\n1,inf\n0,1\n", "hull.csv:2: " + two},
        {"0,0\n1,0x1p3\n0,1\n", "hull.csv:2: " + two},
        {"\xE2\x88\x92"
         "1,0\n1,0\n0,1\n",
         "hull.csv:1: " + two + "; its minus sign is that of typesetting"},
    }));
    INFO(text);
    const std::string said = refusal(text);
    CHECK_THAT(said, StartsWith(message));
    CHECK(said.find('\n') == std::string::npos);
}

TEST_CASE("Half a section that meets the axis is completed, from keel to deck or back", "[outline]") {
    const Outline half = GENERATE(values<Outline>({
        {{0, 0}, {0.2, 0.1}, {0.3, 0.3}},                        // a keel
        {{0.3, 0.3}, {0.2, 0.1}, {0, 0}},                        // from the deck
        {{0, 0}, {0.2, 0}, {0.3, 0.3}},                          // a flat bottom
        {{0, 0.1}, {0.2, 0.1}, {0.2, 0}, {0.3, 0}, {0.3, 0.3}},  // a tunnel with its roof
        {{0, 0}, {0.2, 0.1}, {0, 0.4}},                          // both ends on the axis
        {{1e-12, 0}, {0.2, 0.1}, {0.3, 0.3}},                    // rounding of a drawing
        {{0, -0.2}, {0.1, -0.2}, {0.1, 0}},                      // a box
        {{0, 0}, {0.4, 0.1}, {0.1, 0.3}},                        // tumblehome
        {{0, 0.02}, {0.1, 0}, {0.3, 0.3}},                       // a hollow keel
        {{0, 0}, {1, 0.001}, {1, 0.002}},                        // nearly flat
    }));
    const Outline whole = mirrored_section(half);
    const std::size_t on_axis = static_cast<std::size_t>(
        std::count_if(half.begin(), half.end(), [](const Vec2& c) { return c.x() < 1e-9; }));
    CHECK(whole.size() == 2 * half.size() - on_axis);
    CHECK_NOTHROW(check_outline(whole));
    CHECK(area_moments(whole).centroid.x() == Approx(0).margin(1e-12));
}

TEST_CASE("Half a section off the axis would be closed by a flat bottom and is refused", "[outline]") {
    const auto [half, closed] = GENERATE(table<Outline, std::string>({
        {{{0.3, 0}, {0.4, 0.1}, {0.4, 0.3}, {0.2, 0.3}, {0.2, 0.1}}, "from -0.3 to 0.3 m"},  // a demihull
        {{{0.2, 0.1}, {0.2, 0.3}, {0.4, 0.3}, {0.4, 0.1}, {0.3, 0}}, "from -0.3 to 0.3 m"},  // turned round
        {{{0.2, 0.3}, {0.3, 0}, {0.4, 0.3}}, "from -0.2 to 0.2 m"},                          // from its deck
        {{{0.001, 0}, {0.2, 0.1}, {0.3, 0.3}}, "from -0.001 to 0.001 m"},
        {{{0.5, 0}, {0.5, 0.3}}, "from -0.5 to 0.5 m"},
        {{{0.3, 0.3}, {0.2, 0.1}, {0.05, 0}}, "from -0.05 to 0.05 m"},
        {{{0, 0.3}, {0.2, 0.1}, {0.1, 0}}, "from -0.1 to 0.1 m"},
        {{{0.1, -1}, {0, 0}, {0.2, 0.1}}, "from -0.1 to 0.1 m"},
        {{{1, 0}, {2, 1}, {1, 2}}, "from -1 to 1 m"},
        {{{0.3, 0.1}, {0.3, 0}, {0.4, 0.1}}, "from -0.3 to 0.3 m"},
    }));
    CHECK_THROWS_WITH(mirrored_section(half), Contains("flat bottom " + closed) && Contains("two bodies"));
}
