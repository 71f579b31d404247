// SPDX-License-Identifier: BSD-3-Clause
// GHS geometry files: feet, halves, arcs, components and parts, pinched sections, damaged files.
#include <catch2/catch.hpp>

#include "tests/unit/sections/section_samples.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;

namespace {

const std::vector<std::string> half_box = {"0.,0.", "4.,0.", "4.,5."};

std::string refused(const std::string& text, const SectionOptions& options = {}) {
    return refusal_of_reading([&] { parse_ghs("hull.gf", text, options); });
}

/// Corners of a whole section, of all outlines, without order.
double largest_y(const Station& station) {
    double largest = -1e9;
    for (const SectionOutline& outline : station.outlines)
        for (const Vec2& corner : outline.corners) largest = std::max(largest, corner.y());
    return largest;
}

}  // namespace

TEST_CASE("a GHS file holds feet whatever its header prefers, and its stations grow aft") {
    const std::string records = ghs_shape("HULL", {{-10, half_box}, {20, half_box}}) +
                                ghs_component("HULL.C", 0, "HULL", "1.", "3.,0.,2.") +
                                ghs_part("HULL", 1, {"HULL.C"});
    for (const char* header :
         {"P:F\n", "123\\45\n\\a remark\nP:M\nOL:fore perpendicular\n", "L:30.\nW:8.\n"}) {
        const SectionFile file = parse_ghs("hull.gf", ghs_file(records, header));
        INFO(header);
        REQUIRE(file.stations.size() == 2);
        CHECK(file.stations[0].location.value() == Approx(-7 * foot).epsilon(1e-12));
        CHECK(file.stations[1].location.value() == Approx(23 * foot).epsilon(1e-12));
        CHECK(area_of(file.stations[0]) == Approx(40 * foot * foot).epsilon(1e-12));
        CHECK(largest_y(file.stations[0]) == Approx(7 * foot).epsilon(1e-12));
        CHECK(file.bow_first);
        CHECK_THAT(file.unit, Contains("ft"));
    }
    CHECK_THAT(parse_ghs("a", ghs_file(records, "P:M\n")).unit, Contains("P:M"));
    CHECK_THAT(refused(ghs_file(records), {.unit = "m"}), Contains("expected no unit"));
}

TEST_CASE("half of a section, or both sides in one curve, are the same section") {
    const std::vector<std::string> half = {"0.,-1.", "3.,0.5", "4.,5."},
                                   open_at_axis = {"0.,-1.", "3.,0.5", "4.,5.", "0.,5."},
                                   both = {"0.,-1.", "3.,0.5", "4.,5.", "-4.,5.", "-3.,0.5"},
                                   closed = {"0.,-1.", "3.,0.5", "4.,5.", "-4.,5.", "-3.,0.5", "0.,-1."};
    // shoelace of the half from the centre line: 2 (1.5 * 3 / 2 + 4.5 (3 + 4) / 2)
    const double exact = 2 * (1.5 * 3 / 2 + 4.5 * 3.5) * foot * foot;
    for (const auto& [points, side] : {std::pair(half, 0), std::pair(open_at_axis, 0), std::pair(both, 0),
                                       std::pair(both, 1), std::pair(closed, 1), std::pair(closed, 0)}) {
        const SectionFile file = parse_ghs("hull.gf", ghs_hull({{0, points}, {1, points}}, side));
        REQUIRE(file.stations[0].outlines.size() == 1);
        CHECK(area_of(file.stations[0]) == Approx(exact).epsilon(1e-9));
        CHECK(file.stations[0].problem.empty());
        CHECK(figures_of(file.stations[0].outlines[0]).beam == Approx(8 * foot));
    }
}

TEST_CASE("one half with a side factor of 1 is refused, and one with its mirror image beside it is whole") {
    CHECK_THAT(refused(ghs_hull({{0, half_box}, {1, half_box}}, 1)),
               Contains("hull.gf:") && Contains("component HULL.C has side factor 1") &&
                   Contains("expected side factor 0"));
    const std::string pair =
        ghs_file(ghs_shape("HULL", {{0, half_box}, {1, half_box}}) + ghs_component("HULL.S", 1, "HULL") +
                 ghs_component("HULL.P", -1, "HULL") + ghs_part("HULL", 1, {"HULL.S", "HULL.P"}));
    const SectionFile file = parse_ghs("hull.gf", pair);
    REQUIRE(file.stations[0].outlines.size() == 1);
    CHECK(area_of(file.stations[0]) == Approx(40 * foot * foot).epsilon(1e-9));
}

TEST_CASE("points of one radius are joined by an arc whose chords leave it by no more than the tolerance") {
    // a bilge of 2 ft radius on a box of 4 ft half breadth and 5 ft depth, and the same turned inwards
    const std::vector<std::string> round = {"0.,0.", "2.,0.,0,2.", "4.,2.,0,2.,DK", "4.,5."},
                                   hollow = {"0.,0.", "2.,0.,0,-2.", "4.,2.,,-2.", "4.,5."},
                                   in_two = {"0.,0.", "2.,0.,0,2.", "3.414213562,0.585786438,0,2.",
                                             "4.,2.,0,2.", "4.,5."};
    const double pi = std::numbers::pi, corner = 4 - pi;
    for (const auto& [points, area] : {std::pair(round, 40 - 2 * corner), std::pair(in_two, 40 - 2 * corner),
                                       std::pair(hollow, 40 - 2 * pi)}) {
        for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
            const SectionFile file =
                parse_ghs("hull.gf", ghs_hull({{0, points}, {1, points}}), {.tolerance = tolerance});
            const Outline& outline = file.stations[0].outlines.at(0).corners;
            const Vec2 centre = foot * (area < 35 ? Vec2(4, 0) : Vec2(2, 2));
            int on_arc = 0;
            for (std::size_t k = 1; k < outline.size(); ++k) {
                const Vec2 a = outline[k - 1] - centre, b = outline[k] - centre;
                if (std::abs(a.norm() - 2 * foot) > 1e-6 || std::abs(b.norm() - 2 * foot) > 1e-6) continue;
                ++on_arc;
                CHECK(2 * foot - (0.5 * (a + b)).norm() <= tolerance * (1 + 1e-6));
            }
            CHECK(on_arc > 2);
        }
        const SectionFile file = parse_ghs("hull.gf", ghs_hull({{0, points}, {1, points}}));
        CHECK(area_of(file.stations[0]) == Approx(area * foot * foot).epsilon(1e-3));
    }
    CHECK_THAT(refused(ghs_hull({{0, {"0.,0.", "2.,0.,0,1.", "4.,2.,0,1.", "4.,5."}}, {1, half_box}})),
               Contains("hull.gf:10: two points") && Contains("cannot lie on an arc of radius"));
}

TEST_CASE("a hull with half sections, a skeg, a notch, a tank and windage is the sum of its hull parts") {
    const std::vector<std::string> skeg = {"2.,-2.", "2.5,-2.", "2.5,0.5", "2.,0.5"},
                                   notch = {"-1.,4.", "1.,4.", "1.,6.", "-1.,6."},
                                   house = {"0.,5.", "3.,5.", "3.,9.", "0.,9."};
    const std::string records =
        ghs_shape("HULL", {{0, half_box}, {10, half_box}, {20, half_box}}) +
        ghs_shape("SKEG", {{0, skeg}, {10, skeg}}) + ghs_shape("NOTCH", {{0, notch}, {10, notch}}) +
        ghs_shape("HOUSE", {{0, house}, {10, house}}) + ghs_component("HULL.C", 0, "HULL") +
        ghs_component("SKEG.C", 0, "SKEG", "1.", "10.,0.,0.") +
        ghs_component("NOTCH.C", 1, "NOTCH", "-1.", "10.,0.,0.") + ghs_component("HOUSE.C", 0, "HOUSE") +
        ghs_part("HULL", 1, {"HULL.C", "SKEG.C", "NOTCH.C"}) + "*CRT\n1, vent\n1.,2.,3.\n" +
        ghs_component("TANK.C", 1, "NOTCH", ".97") + ghs_part("TANK.C", 4, {"TANK.C"}) +
        ghs_part("SAIL", 10, {"HOUSE.C"});
    const SectionFile file = parse_ghs("hull.gf", ghs_file(records, "P:M\nN:3\n"));
    REQUIRE(file.stations.size() == 3);
    const double square = foot * foot;
    CHECK(area_of(file.stations[0]) == Approx(40 * square).epsilon(1e-9));
    // the skegs reach 0.5 ft into the hull, the notch 1 ft
    CHECK(area_of(file.stations[1]) == Approx((40 + 2 * 0.5 * 2.0 - 2 * 1) * square).epsilon(1e-6));
    CHECK(file.stations[1].outlines.size() == 1);
    CHECK(file.stations[1].problem.empty());
    CHECK_THAT(file.notes.at(0), Contains("HOUSE.C") && Contains("TANK.C"));
    const SectionFile alone = parse_ghs("hull.gf", ghs_file(records), {.component = "SKEG.C"});
    CHECK(alone.stations.size() == 2);
    CHECK(alone.stations[0].outlines.size() == 2);
    CHECK(area_of(alone.stations[0]) == Approx(2 * 0.5 * 2.5 * square).epsilon(1e-9));
    CHECK_THAT(refused(ghs_file(records), {.component = "KEEL"}),
               Contains("no component 'KEEL', expected one of HOUSE.C, HULL.C, NOTCH.C, SKEG.C, TANK.C"));
}

TEST_CASE("a shape is mirrored before it is shifted, and side factor -1 puts it to port") {
    const std::vector<std::string> fin = {"0.,0.", "1.,0.", "1.,2."};
    for (const auto& [side, low, high] : {std::tuple(1, 9.0, 10.0), std::tuple(-1, 8.0, 9.0)}) {
        const std::vector<std::string> drawn = {"0.2,0.", "1.,0.", "1.,2.", "0.,2."};
        const std::string text = ghs_file(ghs_shape("FIN", {{0, drawn}, {1, {"0.,2."}}}) +
                                          ghs_component("FIN", side, "FIN", "1.", "0.,9.,0.") +
                                          ghs_component("OTHER", -side, "FIN", "1.", "0.,-9.,0.") +
                                          ghs_part("HULL", 1, {"FIN", "OTHER"}));
        CHECK_THAT(refused(text), Contains("expected side factor 0"));  // it ends on its centre line
        const std::string inside =
            ghs_file(ghs_shape("FIN", {{0, {"0.2,0.", "1.,0.", "1.,2.", "0.2,2."}}, {1, {"0.5,2."}}}) +
                     ghs_component("FIN", side, "FIN", "1.", "0.,9.,0.") + ghs_part("HULL", 1, {"FIN"}));
        const SectionFile file = parse_ghs("hull.gf", inside);
        for (const Vec2& corner : file.stations[0].outlines.at(0).corners) {
            CHECK(corner.x() > (low - 1e-9) * foot);
            CHECK(corner.x() < (high + 1e-9) * foot);
        }
    }
    const std::string text =
        ghs_file(ghs_shape("FIN", {{0, fin}, {1, fin}}) + ghs_component("FIN", 0, "FIN", "1.", "0.,9.,0.") +
                 ghs_part("HULL", 1, {"FIN"}));
    const SectionFile file = parse_ghs("hull.gf", text);
    REQUIRE(file.stations[0].outlines.size() == 1);  // mirrored about its own origin
    CHECK(area_of(file.stations[0]) == Approx(4 * foot * foot).epsilon(1e-9));
}

TEST_CASE("a pinched section becomes two outlines, the lower first, and a stem has none") {
    const std::vector<std::string> pinched = {"0.,0.",   "2.,2.", "0.,4.", "0.,7.", "5.,12.",
                                              "-5.,12.", "0.,7.", "0.,4.", "-2.,2."},
                                   half = {"0.,0.", "2.,2.", "0.,4.", "0.,7.", "5.,12."},
                                   touching = {"0.,0.",  "2.,2.", "0.,4.", "5.,9.",
                                               "-5.,9.", "0.,4.", "-2.,2."};
    for (const auto& points : {pinched, half, touching}) {
        CAPTURE(points);
        const SectionFile file = parse_ghs("hull.gf", ghs_hull({{0, {"0.,1."}}, {1, points}, {2, half_box}}));
        REQUIRE(file.stations.size() == 3);
        CHECK(file.stations[0].outlines.empty());
        CHECK_THAT(file.stations[0].problem, Contains("a point or a line"));
        REQUIRE(file.stations[1].outlines.size() == 2);
        CHECK(file.stations[1].problem.empty());
        const SectionFigures bulb = figures_of(file.stations[1].outlines[0]),
                             flare = figures_of(file.stations[1].outlines[1]);
        CHECK(bulb.area == Approx(8 * foot * foot).epsilon(1e-9));
        CHECK(flare.area == Approx(25 * foot * foot).epsilon(1e-9));
        CHECK(bulb.high == Approx(4 * foot));
        for (const SectionOutline& outline : file.stations[1].outlines)
            CHECK_NOTHROW(check_outline(outline.corners));
    }
}

TEST_CASE("a section that another component passes, and a curve that crosses itself, give no outline") {
    const std::string passed = ghs_file(
        ghs_shape("HULL", {{0, half_box}, {10, half_box}, {20, half_box}}) +
        ghs_shape("SKEG", {{5, {"0.,-1.", "1.,-1.", "1.,0."}}, {15, {"0.,-1.", "1.,-1.", "1.,0."}}}) +
        ghs_component("HULL", 0, "HULL") + ghs_component("SKEG", 0, "SKEG") +
        ghs_part("HULL", 1, {"HULL", "SKEG"}));
    const SectionFile file = parse_ghs("hull.gf", passed);
    REQUIRE(file.stations.size() == 5);
    CHECK(file.stations[0].problem.empty());
    CHECK_THAT(file.stations[1].problem, Contains("component HULL passes it"));
    CHECK_THAT(file.stations[2].problem, Contains("component SKEG passes it"));
    CHECK(file.stations[4].problem.empty());
    const SectionFile crossed =
        parse_ghs("hull.gf", ghs_hull({{0, {"-3.,0.", "3.,0.", "-3.,4.", "3.,4."}}, {1, half_box}}));
    CHECK_THAT(crossed.stations[0].problem, Contains("crosses itself near (0, 0.6096) m"));
    const SectionFile clockwise =
        parse_ghs("hull.gf", ghs_hull({{0, {"3.,0.", "-3.,0.", "0.,4."}}, {1, half_box}}));
    CHECK(area_of(clockwise.stations[0]) == Approx(12 * foot * foot));
    CHECK_THAT(clockwise.stations[0].notes.at(0), Contains("clockwise"));
}

TEST_CASE("a damaged GHS file is refused with its line") {
    const std::string sound = ghs_hull({{0, half_box}, {1, half_box}});
    const auto damaged = [&sound](const std::string& what, const std::string& with) {
        std::string text = sound;
        REQUIRE(text.find(what) != std::string::npos);
        return refused(text.replace(text.find(what), what.size(), with));
    };
    CHECK_NOTHROW(parse_ghs("hull.gf", sound));
    CHECK_THAT(damaged("****\n", ""),
               Contains("hull.gf:29: the file ends behind this line") && Contains("'****'"));
    CHECK(refused("") == "hull.gf:0: is empty, expected a GHS geometry file");
    CHECK_THAT(damaged("\n2\n", "\n3\n"),
               Contains("hull.gf:15: '0.,0.,0.': expected section 3 of 3 of shape HULL"));
    CHECK_THAT(damaged("\n2\n", "\n1\n"),
               Contains("hull.gf:11:") && Contains("expected the shell's three thicknesses"));
    CHECK_THAT(damaged("0,3\n", "0,4\n"), Contains("hull.gf:12: location 0 follows 0"));
    CHECK_THAT(damaged("0,3\n", "0,2\n"),
               Contains("hull.gf:10: '4.,5.': expected section 2 of 2 of shape HULL"));
    CHECK_THAT(damaged("4.,5.", "4.,5,5"), Contains("hull.gf:10: the surface code is 5, expected 0 to 3"));
    CHECK_THAT(damaged("4.,5.", "4.,1.5D+02"), Contains("hull.gf:10: '4.,1.5D+02': expected point 3 of 3"));
    CHECK_THAT(damaged("4.,5.", "4.,nan"), Contains("hull.gf:10:"));
    CHECK_THAT(damaged("4.,5.", "4."), Contains("hull.gf:10: '4.': expected point 3 of 3"));
    CHECK_THAT(damaged("1,3\n", "0,3\n"), Contains("hull.gf:11: location 0 follows 0"));
    CHECK_THAT(damaged("0,3\n", "0,300\n"),
               Contains("hull.gf:7: the number of points is 300, expected 1 to 255"));
    CHECK_THAT(damaged("HULL.C\n0\n", "HULL.C\n2\n"), Contains("the side factor is 2, expected -1, 0 or 1"));
    CHECK_THAT(damaged("0\n1.\n", "0\n1.5\n"), Contains("the effectiveness is 1.5"));
    CHECK_THAT(damaged("0.,0.,0.\nHULL\n", "0.,0.,0.\nHULK\n"),
               Contains("no shape 'HULK' stands before component HULL.C"));
    CHECK_THAT(damaged("1\nHULL.C\n****", "1\nKEEL\n****"),
               Contains("no component 'KEEL' stands before part HULL"));
    CHECK_THAT(damaged("SEA WATER\n1\n", "SEA WATER\n2\n"), Contains("the type of part HULL is 2"));
    CHECK_THAT(damaged("SEA WATER\n1\n", "SEA WATER\n4\n"), Contains("holds no part of type 1, a hull"));
    CHECK_THAT(refused(std::string("a\0b", 3)), Contains("NUL"));
    CHECK_THAT(refused("*\nHULL\n"), Contains("hull.gf:1: expected a title"));
    for (std::size_t end = 0; end + 5 < sound.size(); ++end)  // cut anywhere: an error, never a station
        CHECK_THROWS_AS(parse_ghs("hull.gf", sound.substr(0, end)), InputError);
}
