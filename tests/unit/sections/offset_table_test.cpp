// SPDX-License-Identifier: BSD-3-Clause
// Tables of offsets, by rows and as a matrix.
#include <catch2/catch.hpp>

#include "tests/unit/sections/section_samples.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;

namespace {

std::string refused(const std::string& text) {
    return refusal_of_reading([&] { parse_offsets("offsets.csv", text); });
}

}  // namespace

TEST_CASE("rows of station, waterline and half breadth are half sections") {
    const std::string text =
        "# lines plan\nstation [m], waterline [mm], half breadth [mm]\n0.5, 0, 0\n0.5, 100, 300\n0.5, 400, "
        "300\n"
        "1.5, 100, 0\n1.5, 200, 250\n1.5, 400, 500\n";
    const SectionFile file = parse_offsets("offsets.csv", text);
    REQUIRE(file.stations.size() == 2);
    CHECK(file.stations[0].name == "0.5");
    CHECK(file.stations[0].location.value() == Approx(0.5));
    CHECK(is_half_section(file.stations[0].outlines.at(0)));
    CHECK(area_of(file.stations[0]) == Approx(2 * (0.1 * 0.3 / 2 + 0.3 * 0.3)).epsilon(1e-12));
    CHECK(area_of(file.stations[1]) == Approx(2 * (0.1 * 0.25 / 2 + 0.2 * 0.375)).epsilon(1e-12));
    CHECK(figures_of(file.stations[1].outlines[0]).beam == Approx(1));
    CHECK(half_breadth_at(file.stations[1].outlines[0], 0.3).value() == Approx(0.375));
    CHECK_FALSE(half_breadth_at(file.stations[1].outlines[0], 0.05));
    CHECK_FALSE(parse_offsets("a", "station; waterline [m]; half breadth [m]\nFP; 0; 0\nFP; 1; 1\nFP; 2; 1\n")
                    .stations[0]
                    .location);
}

TEST_CASE(
    "a matrix has stations across and waterlines down, with nothing above the deck and below the keel") {
    const std::string text = "waterline [ft];FP;1/2;10\n0;;0;0\n0;;;3\n2;0;2;4\n4;1;3;4\n6;2;;\n";
    const SectionFile file = parse_offsets("offsets.csv", text);
    REQUIRE(file.stations.size() == 3);
    CHECK(file.stations[1].name == "1/2");
    CHECK(area_of(file.stations[0]) == Approx(2 * (1 + 3) * foot * foot).epsilon(1e-12));
    CHECK(area_of(file.stations[1]) == Approx(2 * (2 + 5) * foot * foot).epsilon(1e-12));
    CHECK(area_of(file.stations[2]) == Approx(2 * (7 + 8) * foot * foot).epsilon(1e-12));
    CHECK(looks_like_offsets(text));
    CHECK_FALSE(looks_like_offsets("x [m], y [m]\n0,0\n"));
    CHECK_FALSE(looks_like_offsets("# kind: experiment\n# columns: time [s], station 1 [Pa], b\n0,0,0\n"));
}

TEST_CASE("a table of offsets that may be read in two ways is refused") {
    const std::string head = "station, waterline [m], half breadth [m]\n";
    CHECK_THAT(refused("station, waterline, half breadth [m]\n1,0,0\n"),
               Contains("offsets.csv:1: 'waterline' states no unit"));
    CHECK_THAT(refused("station, waterline [m], half breadth [kg]\n"),
               Contains("the unit 'kg' is none of length"));
    CHECK_THAT(refused("station, half breadth [m], waterline [m]\n"),
               Contains("in the order station, waterline, half breadth"));
    CHECK_THAT(refused(head + "1,0,0\n1,1,1\n1,0.5,2\n"),
               Contains("offsets.csv:4: station 1: a waterline below the one before"));
    CHECK_THAT(refused(head + "1,0,0\n1,1,-1\n"), Contains("offsets.csv:3: a half breadth is negative"));
    CHECK_THAT(refused(head + "1,0,0\n1,1,3-4-5\n"),
               Contains("offsets.csv:3: '3-4-5': expected a half breadth"));
    CHECK_THAT(refused(head + "1,0,0\n1,1\n"),
               Contains("offsets.csv:3: has 2 cells, expected 3") || Contains("offsets.csv:3: has 3"));
    CHECK_THAT(refused(head + "1,0,2\n1,1,3\n1,2,3\n"),
               Contains("station 1 begins with half breadth 2 m at 0 m, off the centre line"));
    CHECK_THAT(refused(head + "1,0,0\n1,1,3\n"), Contains("station 1 has 2 points, expected 3 or more"));
    CHECK_THAT(refused(head + "1,0,0\n1,0,0\n"), Contains("offsets.csv:3: station 1: the same point twice"));
    CHECK_THAT(refused("waterline [m], 1, 1, 2\n"), Contains("station '1' stands twice"));
    CHECK_THAT(refused("waterline [m], 1, 2\n0,0,0,0\n"),
               Contains("offsets.csv:2: has 4 cells, expected 3 or fewer"));
    CHECK_THAT(refused("waterline, 1, 2\n"), Contains("states no unit"));
    CHECK_THAT(refused("1,2,3\n"), Contains("offsets.csv:1:"));
    CHECK_THAT(refused(""), Contains("holds no line of titles"));
}
