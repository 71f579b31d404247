// SPDX-License-Identifier: BSD-3-Clause
// DXF drawings: units, bulges, mirrored entities, blocks, layers, joined lines, damaged files.
#include <catch2/catch.hpp>
#include <locale>

#include "tests/unit/sections/section_samples.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;

namespace {

SectionFile read(const std::string& text, const SectionOptions& options = {}) {
    return parse_dxf("hull.dxf", text, options);
}

std::string refused(const std::string& text, const SectionOptions& options = {}) {
    return refusal_of_reading([&] { read(text, options); });
}

Box box_of(const SectionOutline& outline) {
    Box box{outline.corners.front(), outline.corners.front()};
    for (const Vec2& corner : outline.corners) {
        box.low = box.low.cwiseMin(corner);
        box.high = box.high.cwiseMax(corner);
    }
    return box;
}

const std::vector<std::vector<double>> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const double pi = std::numbers::pi;

}  // namespace

TEST_CASE("a bulge is an arc, and a straight side follows it") {
    // half a disc of radius 1 beside a square: bulge 1 is a half circle, which turns left
    const std::string right = light_polyline("HULL", 1, {{0, 0}, {2, 0, 1}, {2, 2}, {0, 2}});
    const SectionFile file = read(drawing(right));
    REQUIRE(file.stations.size() == 1);
    CHECK(file.stations[0].name == "HULL");
    CHECK(area_of(file.stations[0]) == Approx(4 + pi / 2).epsilon(1e-3));
    CHECK(box_of(file.stations[0].outlines.at(0)).high.x() == Approx(3).epsilon(1e-3));
    const SectionFile fine = read(drawing(right), {.tolerance = 1e-6});
    CHECK(area_of(fine.stations[0]) == Approx(4 + pi / 2).epsilon(1e-6));
    const std::string hollow =
        light_polyline("HULL", 1, {{0, 0}, {2, 0, -0.4142135623730951}, {2, 2}, {0, 2}});
    CHECK(area_of(read(drawing(hollow), {.tolerance = 1e-6}).stations[0]) ==
          Approx(4 - (pi / 4 - 0.5) * 2).epsilon(1e-6));  // a quarter of a circle of radius sqrt(2)
    for (const double tolerance : {1e-2, 1e-4}) {
        const Outline corners =
            read(drawing(right), {.tolerance = tolerance}).stations[0].outlines[0].corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 a = corners[k], b = corners[(k + 1) % corners.size()];
            if (a.x() >= 2 && b.x() >= 2 && (a - b).norm() < 1.9)
                CHECK(1 - (0.5 * (a + b) - Vec2(2, 1)).norm() <= tolerance * (1 + 1e-9));
        }
    }
}

TEST_CASE("the unit is that of the drawing or of the user, and is asked for where neither says it") {
    const std::string one = light_polyline("HULL", 1, square);
    for (const auto& [code, metres] : {std::pair(1, 0.0254), std::pair(2, 0.3048), std::pair(4, 0.001),
                                       std::pair(5, 0.01), std::pair(6, 1.0), std::pair(14, 0.1)})
        CHECK(area_of(read(drawing(one, "", code)).stations[0]) ==
              Approx(4 * metres * metres).epsilon(1e-12));
    CHECK_THAT(refused(drawing(one, "", 0)),
               Contains("hull.dxf: the drawing does not state its unit ($INSUNITS)") &&
                   Contains("--unit mm") && Contains("#unit=mm"));
    CHECK_THAT(refused(drawing(one, "", 20)), Contains("has $INSUNITS 20"));
    const std::string no_header = dxf_section("ENTITIES", groups(one)) + groups("0 EOF");
    CHECK_THAT(refused(no_header), Contains("does not state its unit"));
    CHECK(area_of(read(no_header, {.unit = "mm"}).stations[0]) == Approx(4e-6).epsilon(1e-12));
    const SectionFile other = read(drawing(one, "", 4), {.unit = "m"});
    CHECK(area_of(other.stations[0]) == Approx(4));
    CHECK_THAT(other.unit, Contains("$INSUNITS of the drawing says mm"));
    CHECK_THAT(refused(drawing(one), {.unit = "kg"}), Contains("the unit 'kg' is none of length"));
}

TEST_CASE("an extrusion of 0, 0, -1 mirrors flat polylines, arcs, circles and inserts, for itself alone") {
    const std::string down = "|210 0.0|220 0.0|230 -1.0";
    const std::vector<std::vector<double>> bulged = {{1, 0}, {3, 0, 1}, {3, 2}, {1, 2}};
    const SectionFile file =
        read(drawing(light_polyline("A", 1, bulged, down) + "|" + light_polyline("B", 1, bulged)));
    const Box mirrored = box_of(file.stations.at(0).outlines.at(0)),
              plain = box_of(file.stations.at(1).outlines.at(0));
    CHECK(mirrored.low.x() == Approx(-4).epsilon(1e-3));
    CHECK(mirrored.high.x() == Approx(-1));
    CHECK(plain.high.x() == Approx(4).epsilon(1e-3));
    CHECK(area_of(file.stations[0]) == Approx(4 + pi / 2).epsilon(1e-3));  // its bulge is turned, too
    const SectionFile circle = read(drawing("0 CIRCLE|8 C|10 3|20 1|40 0.5" + down));
    CHECK(box_of(circle.stations.at(0).outlines.at(0)).low.x() == Approx(-3.5).epsilon(1e-3));
    CHECK(area_of(circle.stations[0]) == Approx(pi / 4).epsilon(1e-3));
    // a quarter from 0 to 90 degrees lies left of its mirrored centre; lines stay where they are
    const SectionFile arc =
        read(drawing("0 ARC|8 D|10 1|20 0|40 2|50 0|51 90" + down + "|0 LINE|8 D|10 -3|20 0" + down +
                     "|11 -1|21 2" + "|0 LINE|8 E|10 -1|20 0|11 0|21 0|0 LINE|8 E|10 0|20 0|11 0|21 1"));
    REQUIRE(arc.stations.at(0).name == "D");
    REQUIRE(arc.stations[0].outlines.size() == 1);
    CHECK(arc.stations[0].outlines[0].closed);
    CHECK(area_of(arc.stations[0]) == Approx(pi - 2).epsilon(1e-3));
    const std::string block = dxf_section(
        "BLOCKS", groups("0 BLOCK|2 HALF|10 0|20 0|" + light_polyline("0", 1, square) + "|0 ENDBLK"));
    const SectionFile inserted = read(drawing("0 INSERT|8 F|2 half|10 5|20 1" + down, block));
    CHECK(inserted.stations.at(0).name == "F");  // entities of layer 0 take that of the insert
    CHECK(box_of(inserted.stations[0].outlines.at(0)).low.x() == Approx(-7));
    CHECK(box_of(inserted.stations[0].outlines.at(0)).high.x() == Approx(-5));
    CHECK_THAT(refused(drawing(light_polyline("A", 1, square, "|210 1.0|220 0.0|230 0.0"))),
               Contains("LWPOLYLINE is drawn in another plane"));
}

TEST_CASE("a block is drawn where it is inserted, scaled and turned, and else not") {
    const std::string blocks = dxf_section(
        "BLOCKS", groups("0 BLOCK|2 PART|10 1|20 0|" + light_polyline("IN", 1, square) +
                         "|0 ENDBLK|0 BLOCK|2 UNUSED|10 0|20 0|" + light_polyline("GHOST", 1, square) +
                         "|0 ENDBLK|0 BLOCK|2 OUTER|10 0|20 0|0 INSERT|8 0|2 PART|10 10|20 0|0 ENDBLK"));
    const SectionFile file = read(drawing("0 INSERT|8 X|2 PART|10 5|20 7|41 2|42 3|50 90", blocks));
    REQUIRE(file.stations.size() == 1);
    CHECK(file.stations[0].name == "IN");
    // (x, y) -> (5 - 3 y, 7 + 2 (x - 1))
    const Box box = box_of(file.stations[0].outlines.at(0));
    CHECK(box.low.x() == Approx(-1));
    CHECK(box.high.x() == Approx(5));
    CHECK(box.low.y() == Approx(5));
    CHECK(box.high.y() == Approx(9));
    CHECK(area_of(file.stations[0]) == Approx(24));
    const SectionFile nested = read(drawing("0 INSERT|8 X|2 OUTER|10 100|20 0", blocks));
    CHECK(box_of(nested.stations.at(0).outlines.at(0)).low.x() == Approx(109));
    CHECK_THAT(refused(drawing("0 TEXT|8 X|1 words", blocks)),
               Contains("no outline found") && Contains("1 TEXT"));
    CHECK_THAT(refused(drawing("0 INSERT|8 X|2 NONE|10 0|20 0", blocks)), Contains("names the block 'NONE'"));
    const std::string circle =
        dxf_section("BLOCKS", groups("0 BLOCK|2 A|10 0|20 0|0 INSERT|8 0|2 A|10 0|20 0|0 ENDBLK"));
    CHECK_THAT(refused(drawing("0 INSERT|8 X|2 A|10 0|20 0", circle)), Contains("is inserted in itself"));
    const std::string unequal =
        dxf_section("BLOCKS", groups("0 BLOCK|2 A|10 0|20 0|0 CIRCLE|8 0|10 0|20 0|40 1|0 ENDBLK"));
    CHECK(area_of(read(drawing("0 INSERT|8 X|2 A|10 0|20 0|41 2|42 3", unequal)).stations[0]) ==
          Approx(6 * pi).epsilon(1e-3));
}

TEST_CASE("group 70 of a polyline is a set of bits, and the frame of a smoothed one is no part of it") {
    CHECK(read(drawing(light_polyline("A", 129, square))).stations[0].outlines.at(0).closed);
    CHECK_FALSE(read(drawing(light_polyline("A", 128, square))).stations[0].outlines.at(0).closed);
    const auto vertices = [](int bits, const std::vector<std::vector<double>>& corners) {
        std::string text;
        for (const auto& c : corners)
            text += fmt::format("|0 VERTEX|8 A|10 {}|20 {}|30 0|70 {}", c[0], c[1], bits);
        return text;
    };
    const std::vector<std::vector<double>> frame = {{-9, -9}, {9, -9}, {9, 9}};
    const SectionFile smooth = read(
        drawing("0 POLYLINE|8 A|66 1|70 5" + vertices(16, frame) + vertices(8, square) + "|0 SEQEND|8 A"));
    CHECK(area_of(smooth.stations.at(0)) == Approx(4));
    const SectionFile plain = read(drawing("0 POLYLINE|8 A|66 1|70 1" + vertices(0, square) + "|0 SEQEND"));
    CHECK(area_of(plain.stations.at(0)) == Approx(4));
    CHECK_THAT(refused(drawing("0 POLYLINE|8 A|66 1|70 16" + vertices(64, square) + "|0 SEQEND")),
               Contains("POLYLINE is a mesh"));
    CHECK_THAT(refused(drawing("0 POLYLINE|8 A|66 1|70 64" + vertices(192, square) + "|0 SEQEND")),
               Contains("POLYLINE is a mesh"));
    CHECK_THAT(
        refused(drawing(
            "0 POLYLINE|8 A|66 1|70 8|0 VERTEX|10 0|20 0|30 0|70 32|0 VERTEX|10 1|20 0|30 4|70 32|0 SEQEND")),
        Contains("leaves the x, y plane (z from 0 to 4)"));
}

TEST_CASE("what is hidden is not drawn, and what is left out is named") {
    const std::string tables = dxf_section(
        "TABLES",
        groups("0 TABLE|2 LAYER|70 2|0 LAYER|2 Off|70 0|62 -7|0 LAYER|2 FROZEN|70 1|62 7|0 ENDTAB"));
    const std::string all = light_polyline("SHOWN", 1, square) + "|" + light_polyline("OFF", 1, square) +
                            "|" + light_polyline("frozen", 1, square) + "|" +
                            light_polyline("PAPER", 1, square, "|67 1") + "|" +
                            light_polyline("GONE", 1, square, "|60 1") +
                            "|0 MLINE|8 SHOWN|0 REGION|8 SHOWN|0 HELIX|8 SHOWN|0 HELIX|8 SHOWN";
    const SectionFile file = read(drawing(all, tables));
    REQUIRE(file.stations.size() == 1);
    CHECK(file.stations[0].name == "SHOWN");
    CHECK(file.notes.at(0) ==
          "Left out: 2 HELIX, 1 LWPOLYLINE invisible, 1 LWPOLYLINE of paper space, 1 LWPOLYLINE on a frozen "
          "layer, "
          "1 LWPOLYLINE on a layer that is off, 1 MLINE, 1 REGION.");
}

TEST_CASE("a spline is evaluated by its knots and weights") {
    // three quarters of nothing: the quarter circle as a rational curve of degree 2 is exact
    const std::string w = fmt::format("{}", std::sqrt(0.5));
    const std::string quarter =
        "0 SPLINE|8 A|210 0|220 0|230 -1|70 12|71 2|72 6|73 3|74 0|40 0|40 0|40 0|40 1|40 1|40 1|41 1|41 " +
        w + "|41 1|10 2|20 0|30 0|10 2|20 2|30 0|10 0|20 2|30 0";
    const std::string sides = "|0 LINE|8 A|10 0|20 2|11 0|21 0|0 LINE|8 A|10 0|20 0|11 2|21 0";
    const SectionFile file = read(drawing(quarter + sides));
    REQUIRE(file.stations.at(0).outlines.size() == 1);
    CHECK(area_of(file.stations[0]) == Approx(pi).epsilon(1e-3));
    for (const Vec2& corner : file.stations[0].outlines[0].corners)
        CHECK((std::abs(corner.norm() - 2) < 1e-9 || corner.norm() < 1e-9));
    // a cubic of two spans through its ends, uniform inner knot, area by Green's theorem below in 10,000
    // steps
    const std::string cubic =
        "0 SPLINE|8 B|70 8|71 3|72 9|73 5|40 0|40 0|40 0|40 0|40 1|40 2|40 2|40 2|40 2|10 0|20 0|10 1|20 "
        "0|10 2|20 1|10 2|20 2|10 2|20 4";
    const SectionFile half = read(drawing(cubic), {.tolerance = 1e-6});
    CHECK(is_half_section(half.stations.at(0).outlines.at(0)));
    const auto blend = [](double u, const double* c) {  // truncated powers of both spans, by hand
        const double b0 = u < 1 ? std::pow(1 - u, 3) : 0, b4 = u > 1 ? std::pow(u - 1, 3) : 0;
        const double b1 = u < 1 ? u * (1.75 * u * u - 4.5 * u + 3) : std::pow(2 - u, 3) / 4;
        const double b3 = u > 1 ? (2 - u) * (1.75 * (2 - u) * (2 - u) - 4.5 * (2 - u) + 3) : u * u * u / 4;
        const double b2 = 1 - b0 - b1 - b3 - b4;
        return b0 * c[0] + b1 * c[1] + b2 * c[2] + b3 * c[3] + b4 * c[4];
    };
    const double x[] = {0, 1, 2, 2, 2}, y[] = {0, 0, 1, 2, 4};
    double area = 0;
    for (int k = 0; k < 10'000; ++k) {
        const double a = k / 5000.0, b = (k + 1) / 5000.0;
        area += (blend(a, x) + blend(b, x)) / 2 * (blend(b, y) - blend(a, y));
    }
    CHECK(area_of(half.stations[0]) == Approx(2 * area).epsilon(1e-5));
    CHECK_THAT(refused(drawing("0 SPLINE|8 A|71 3|73 0|74 2|11 0|21 0|11 1|21 1")),
               Contains("fit points alone"));
    CHECK_THAT(refused(drawing(
                   "0 SPLINE|8 A|71 2|72 5|73 3|40 0|40 0|40 0|40 1|40 1|10 0|20 0|10 1|20 0|10 1|20 1")),
               Contains("SPLINE has 5 knots, expected 6"));
}

TEST_CASE("separate lines and arcs are joined where two ends meet, and nowhere else") {
    const std::string lines =
        "0 LINE|8 A|10 0|20 0|11 2|21 0|0 LINE|8 A|10 0|20 2|11 2|21 2|0 LINE|8 A|10 {1}|20 0|11 2|21 2|0 "
        "LINE|8 A|10 0|20 2|11 0|21 0";
    const auto with = [&lines](const std::string& x) {
        return std::string(lines).replace(lines.find("{1}"), 3, x);
    };
    const SectionFile file = read(drawing(with("2.00001")));
    REQUIRE(file.stations.at(0).outlines.size() == 1);
    CHECK(file.stations[0].outlines[0].closed);
    CHECK(area_of(file.stations[0]) == Approx(4).epsilon(1e-4));
    CHECK_THAT(
        file.stations[0].notes.at(0),
        Contains("4 lines and arcs are joined to 1 curve; the widest gap between two ends is 1e-05 m"));
    CHECK_FALSE(read(drawing(with("2.001"))).stations.at(0).outlines.at(0).closed);
    // half sections that meet at the keel stay apart: three of them, and two of different stations
    const std::string a = "0 LWPOLYLINE|8 B|90 3|70 0|10 0|20 0|10 2|20 1|10 2|20 3",
                      b = "0 LWPOLYLINE|8 B|90 3|70 0|10 0|20 0|10 -3|20 1|10 -3|20 3",
                      c = "0 LWPOLYLINE|8 B|90 3|70 0|10 0|20 0|10 -2|20 1|10 -2|20 3";
    CHECK(read(drawing(a + "|" + b + "|" + c)).stations.at(0).outlines.size() == 3);
    CHECK(read(drawing(a + "|" + b)).stations.at(0).outlines.size() == 2);
    const SectionFile both = read(drawing(a + "|" + c));
    REQUIRE(both.stations.at(0).outlines.size() == 1);  // the two halves of one section
    CHECK(both.stations[0].outlines[0].corners.size() == 5);
}

TEST_CASE("a damaged drawing is refused with its line") {
    const std::string sound = drawing(light_polyline("HULL", 1, square));
    CHECK_NOTHROW(read(sound));
    const auto damaged = [&sound](const std::string& what, const std::string& with) {
        std::string text = sound;
        REQUIRE(text.find(what) != std::string::npos);
        return refused(text.replace(text.find(what), what.size(), with));
    };
    CHECK_THAT(damaged("  0\r\nEOF\r\n", ""),
               Contains("hull.dxf:") && Contains("without its end mark, 0 EOF"));
    CHECK_THAT(damaged("  20\r\n2", "  20\r\n1.5D+02"),
               Contains("hull.dxf:21: LWPOLYLINE has '1.5D+02' in group 20 (line 40)"));
    CHECK_THAT(damaged("  20\r\n2", "  20\r\n1,5"), Contains("has '1,5' in group 20"));
    CHECK_THAT(damaged("  90\r\n4", "  90\r\n5"),
               Contains("hull.dxf:21: LWPOLYLINE states 5 vertices and holds 4"));
    CHECK_THAT(damaged("  20\r\n2\r\n", ""), Contains("LWPOLYLINE has an x without its y"));
    CHECK_THAT(damaged("AC1015", std::string(2050, 'x')),
               Contains("hull.dxf:10: the line has 2050 characters, 2049 at most"));
    CHECK(damaged("AC1015", std::string(2049, 'x')) == "nothing was said");
    CHECK_THAT(damaged("  90", "  ab"), Contains("'ab' is no group code"));
    CHECK_THAT(damaged("HULL", std::string("HU\0L", 4)), Contains("NUL"));
    CHECK(refused(std::string("AutoCAD Binary DXF\r\n\x1a\0", 22)) ==
          "hull.dxf: is a binary DXF drawing, expected a text one (ASCII DXF)");
    CHECK_THAT(refused("AC1027\1\2"), Contains("is a DWG drawing"));
    CHECK_THAT(refused(drawing("0 POLYLINE|8 A|70 1|0 VERTEX|10 0|20 0")), Contains("without 0 SEQEND"));
    CHECK_THAT(refused(drawing("0 ARC|8 A|10 0|20 0|40 -1|50 0|51 90")), Contains("ARC has the radius -1"));
    CHECK_THAT(refused(""), Contains("hull.dxf:0: the file ends"));
    for (std::size_t end = 0; end + 6 < sound.size(); end += 3)
        CHECK_THROWS_AS(read(sound.substr(0, end)), InputError);
}

TEST_CASE("numbers of a drawing have a decimal point whatever the locale") {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
    const SectionFile file = read(drawing(light_polyline("A", 1, {{0, 0}, {1.5, 0}, {1.5, 1.5}, {0, 1.5}})));
    std::locale::global(before);
    CHECK(area_of(file.stations.at(0)) == Approx(2.25));
}
