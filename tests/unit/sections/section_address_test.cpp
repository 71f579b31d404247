// SPDX-License-Identifier: BSD-3-Clause
// Which section of a file is meant, in a scene file and on the command line.
#include "validation/sections/section_address.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/sections/section_samples.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/generate/section.hpp"
#include "validation/program/command_line.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/scene.hpp"
#include "validation/sections/closed_outlines.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;
using Catch::EndsWith;

namespace {

const std::vector<std::string> vee = {"0.,0.", "1.,0.3", "1.,0.9"},
                               pinched = {"0.,0.", "0.5,0.5", "0.,1.", "0.,1.5", "1.,2.5"};

std::string small_hull() {
    return ghs_hull({{-1, {"0.,0."}}, {0, pinched}, {10, vee}, {20, vee}});
}

const std::string half_drawing = drawing(light_polyline("port half", 0, {{-0.5, 0.4}, {-0.5, 0.2}, {0, 0}}) +
                                         "|" + light_polyline("open", 0, {{-0.5, 0}, {0.5, 0}, {0.5, 0.2}}) +
                                         "|" + light_polyline("whole", 0, {{-0.5, 0.3}, {0, 0}, {0.5, 0.3}}) +
                                         "|" + light_polyline("a/b&c", 1, {{4, 0}, {5, 0}, {5, 1}, {4, 1}}));

struct Folder {
    ScratchFolder folder;
    Folder() {
        put_bytes(folder / "hull.gf", small_hull());
        put_bytes(folder / "plan.DXF", half_drawing);
        put_bytes(folder / "offsets.csv",
                  "waterline [m], FP, 1\n0, 0, 0\n0.1,, 0.2\n0.2, 0.1, 0.3\n0.4, 0.1, 0.3\n");
        put_bytes(folder / "corners.csv", "0,0\n1,1\n-1,1\n");
    }
    std::string operator/(const std::string& name) const { return (folder / name).string(); }
    ChosenSection chosen(const std::string& address) const {
        const auto found = section_address(*this / address);
        REQUIRE(found);
        return read_section_at(*found);
    }
    std::string refused(const std::string& address) const {
        return refusal_of_reading([&] { read_section_at(section_address(*this / address).value()); });
    }
};

}  // namespace

TEST_CASE("a station is asked for by its place, its name or its row") {
    const Folder in;
    const ChosenSection by_place = in.chosen("hull.gf#station=3.048");
    CHECK(by_place.title == "station 3.048 m");
    CHECK_FALSE(by_place.half);
    CHECK(signed_area(by_place.corners) == Approx(2 * (0.15 + 0.6) * foot * foot));
    CHECK(in.chosen("hull.gf#row=4").corners == by_place.corners);
    CHECK(in.chosen("offsets.csv#station=fp").half);
    CHECK(in.chosen("offsets.csv#row=2").corners.size() == 4);
    CHECK_THAT(in.refused("hull.gf#station=3.06"),
               Contains("station=3.06: no such station (the nearest is 3.048), expected one of -0.3048, 0, "
                        "3.048, 6.096"));
    CHECK_THAT(in.refused("hull.gf"), Contains("holds 4 stations, expected station=... with one of"));
    CHECK_THAT(in.refused("hull.gf#layer=A"),
               Contains("a GHS geometry file has no layers, expected station=... or row=..."));
    CHECK_THAT(in.refused("hull.gf#row=9"), Contains("row=9: expected a number from 1 to 5"));
    CHECK_THAT(in.refused("hull.gf#station=-0.3048"), Contains("no outline can be taken: it is a point"));
    CHECK_THAT(in.refused("none.gf#row=1"), EndsWith("none.gf: no such file of sections"));
    CHECK_THROWS_WITH(section_address("hull.gf#place=3"),
                      Contains("'place=3', expected KEY=VALUE with a key of axis, component"));
    CHECK_FALSE(section_address(in / "corners.csv"));
    CHECK_FALSE(section_address("section#7.csv"));
}

TEST_CASE("of a pinched station one outline is asked for by its number or as the lowest") {
    const Folder in;
    CHECK_THAT(
        in.refused("hull.gf#station=0"),
        Contains("station 0 m has 2 outlines, expected one of part=1 (0.3048 m wide, y from 0 to 0.3048 m), "
                 "part=2 (0.6096 m wide, y from 0.4572 to 0.762 m), or part=lowest"));
    const ChosenSection bulb = in.chosen("hull.gf#station=0&part=1"), flare = in.chosen("hull.gf#row=3");
    CHECK(bulb.title == "station 0 m, part 1 of 2 (from the lowest up)");
    CHECK(signed_area(bulb.corners) == Approx(0.5 * foot * foot));
    CHECK(signed_area(flare.corners) == Approx(1.0 * foot * foot));
    CHECK(in.chosen("hull.gf#station=0&part=lowest").corners == bulb.corners);
    CHECK_THAT(in.refused("hull.gf#station=0&part=3"), Contains("part=3: expected a number from 1 to 2"));
    CHECK_THAT(in.refused("hull.gf#row=3&part=1"), Contains("row: names a station and its part already"));
}

TEST_CASE("a curve with two ends is half a section, or a whole with a level deck, or refused") {
    const Folder in;
    const ChosenSection half = in.chosen("plan.DXF#layer=Port Half");
    CHECK(half.half);
    CHECK(half.corners == Outline{{0, 0}, {0.5, 0.2}, {0.5, 0.4}});
    CHECK_THAT(half.notes.at(0), Contains("the half at port was drawn"));
    CHECK(in.chosen("plan.DXF#layer=whole").corners.size() == 3);
    CHECK_THAT(in.refused("plan.DXF#layer=open"),
               Contains("the curve is open, its ends (-0.5, 0) and (0.5, 0.2) m are 1.02 m apart"));
    const ChosenSection moved = in.chosen("plan.DXF#layer=a%2Fb%26c&axis=4.5");
    CHECK(moved.corners.front() == Vec2(-0.5, 0));
    CHECK_THAT(in.refused("plan.DXF#station=open"),
               Contains("station: a DXF drawing has no stations, expected layer=... or row=..."));
}

TEST_CASE("a scene takes a section, keeps its line numbers, and holds the lines that it comes from") {
    const Folder in;
    const std::vector<std::string> bulb = {"0.,0.", "0.2,0.2", "0.,0.4", "0.,0.5", "0.3,0.7"};
    put_bytes(in / "small.gf", ghs_hull({{0, bulb}, {10, vee}}));
    const std::string text =
        with("[model]",
             "[body]\noutline = \"small.gf#station=0&part=1\" # bulb\nposition = [0.6, 0.3]\n"
             "free = [\"y\"]\nmass = 5.0\n\n[model]");
    put_bytes(in / "scene.toml", text);
    const Scene scene = read_scene(in / "scene.toml");
    CHECK(scene.bodies.at(0).outline.size() == 4);
    CHECK(area_moments(scene.bodies[0].outline).area == Approx(0.08 * foot * foot));
    CHECK(std::count(scene.text.begin(), scene.text.end(), '\n') ==
          std::count(text.begin(), text.end(), '\n'));
    CHECK_THAT(scene.text,
               Contains("]] # bulb  # small.gf: GHS geometry file, station 0 m, part 1 of 2 (from "
                        "the lowest up), lengths in ft") &&
                   Contains("0,5 | 0.,0. | 0.2,0.2 | 0.,0.4 | 0.,0.5 | 0.3,0.7\n"));
    std::filesystem::remove(in / "small.gf");  // the text needs the file no more
    CHECK(parse_scene(scene.text, scene.path).bodies.at(0).outline == scene.bodies[0].outline);
    CHECK_THROWS_WITH(read_scene(in / "scene.toml"),
                      Contains("key 'body.outline': ") && EndsWith("small.gf: no such file of sections"));
}

TEST_CASE("new writes a scene of a section and check tells the files apart", "[generate]") {
    const Folder in;
    const auto run = [&](std::vector<std::string> words) { return run_command_line(std::move(words)); };
    const std::vector<std::string> more = {"--speed", "3",     "--mass",        "60",
                                           "--force", "--out", in / "mine.toml"};
    const auto fresh = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "new");
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    REQUIRE(fresh({in / "hull.gf", "--station", "3.048"}) == exit_done);
    CHECK_THAT(bytes_of(in / "mine.toml"), Contains("outline = \"hull.gf#station=3.048\""));
    CHECK(run({"check", in / "mine.toml", "--strict"}) == exit_done);
    REQUIRE(fresh({in / "plan.DXF", "--layer", "port half"}) == exit_done);
    CHECK_THAT(bytes_of(in / "mine.toml"), Contains("mirrored = true"));
    CHECK(read_scene(in / "mine.toml").bodies.at(0).outline.size() == 5);
    REQUIRE(fresh({in / "offsets.csv", "--row", "2"}) == exit_done);
    REQUIRE(fresh({in / "hull.gf", "--station", "0", "--part", "2"}) == exit_done);
    CHECK(read_section(in / "hull.gf#row=2", std::nullopt).beam() == Approx(foot));
    CHECK_THROWS_WITH(fresh({in / "hull.gf", "--station", "0"}), Contains("has 2 outlines"));
    CHECK_THROWS_WITH(fresh({in / "corners.csv", "--station", "0"}), Contains("expected no --station"));
    CHECK_THROWS_WITH(fresh({in / "hull.gf#station=0", "--station", "0"}),
                      Contains("--station: stands behind the name"));
    for (const char* file : {"hull.gf", "plan.DXF", "offsets.csv", "corners.csv", "hull.gf#station=3.048"})
        CHECK(run({"check", in / file}) == exit_done);
    put_bytes(in / "bad.gf", "no hull\n");
    CHECK_THROWS_WITH(run({"check", in / "bad.gf"}), Contains("bad.gf:1: the file ends behind this line"));
}

TEST_CASE("sections lists a file and draws its body plan") {
    const Folder in;
    const auto run = [](const std::vector<std::string>& words) { return run_command_line(words); };
    for (const char* file : {"hull.gf", "plan.DXF", "offsets.csv"}) {
        CHECK(run({"sections", in / file, "--picture", in / "plan.svg", "--force"}) == exit_done);
        CHECK(run({"sections", in / file, "--picture", in / "plan.png", "--force"}) == exit_done);
        CHECK_THAT(bytes_of(in / "plan.svg"), Contains("<svg ") && EndsWith("</svg>\n"));
        CHECK(bytes_of(in / "plan.png").substr(1, 3) == "PNG");
    }
    CHECK_THROWS_WITH(run({"sections", in / "hull.gf", "--picture", in / "plan.png"}),
                      Contains("exists: expected another name, or --force"));
    CHECK_THROWS_WITH(run({"sections", in / "hull.gf", "--picture", in / "plan.pdf"}),
                      Contains("expected FILE.svg or FILE.png"));
    CHECK_THROWS_WITH(run({"sections", in / "hull.gf", "--unit", "m"}),
                      Contains("expected no unit beside it"));
    CHECK_THROWS_WITH(run({"sections", in / "corners.csv"}), Contains("corners.csv:1:"));
}
