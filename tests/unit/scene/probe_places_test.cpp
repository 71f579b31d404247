// SPDX-License-Identifier: BSD-3-Clause
// Places where a probe could never read, and directions that do not depend on the order of its ends.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"
#include "validation/scene/faces.hpp"
#include "validation/scene/plausibility.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/// A square body above the water, 0.12 m wide, that never moves.
const std::string with_body = small_scene + R"toml(
[body]
position = [0.1, 0.24]
outline = [[0.0, 0.0], [0.12, 0.0], [0.12, 0.12], [0.0, 0.12]]
free = []
)toml";

std::string probe(const std::string& keys) {
    return with_body + "[[probes]]\nname = \"new\"\n" + keys + "\n";
}

struct Refusal {
    std::string keys, key, message;
};

std::string on_tank(const std::string& from, const std::string& to, int points = 4) {
    return fmt::format("type = \"face_pressure\"\nbody = \"tank\"\npoints = {}\nfrom = {}\nto = {}", points,
                       from, to);
}

std::string gauge(const std::string& type, const std::string& centre, const std::string& diameter) {
    return fmt::format("type = \"{}\"\ncentre = {}\ndiameter = {}", type, centre, diameter);
}

}  // namespace

TEST_CASE("a probe is refused where it could never read", "[probe]") {
    const std::vector<Refusal> rows = {
        {gauge("wall_pressure", "[0.5, 0.1]", "0.04"), "centre",
         "lies 0.1 m off the floor, the nearest face"},
        {gauge("wall_pressure", "[0.03, 0.3]", "0.04"), "centre", "lies 0.03 m off the left wall"},
        {gauge("wall_pressure", "[1.2, 0.3]", "0.04"), "centre", "lies 0.2 m off the right wall"},
        {gauge("wall_pressure", "[0.5, 0.45]", "0.04"), "centre", "lies 0.03 m off the roof"},
        {gauge("wall_pressure", "[0.5, -0.1]", "0.04"), "centre", "lies 0.1 m off the floor"},
        {gauge("wall_pressure", "[1.0, 0.02]", "0.06"), "diameter",
         "reaches 0.01 m beyond the end of the right wall: expected at most 0.04 m"},
        {gauge("wall_pressure", "[0.0, 0.47]", "0.06"), "diameter", "beyond the end of the left wall"},
        {gauge("wall_pressure", "[0.01, 0.0]", "0.06"), "diameter", "beyond the end of the floor"},
        {gauge("wall_pressure", "[0.99, 0.48]", "0.06"), "diameter", "beyond the end of the roof"},
        {gauge("wall_pressure", "[0.0, 0.0]", "0.04"), "diameter", "reaches 0.02 m beyond the end"},
        {gauge("body_pressure", "[0.06, 0.03]", "0.04"), "centre",
         "lies 0.03 m off the face, the nearest face"},
        {gauge("body_pressure", "[0.06, -0.021]", "0.04"), "centre", "lies 0.021 m off the face"},
        {gauge("body_pressure", "[0.01, 0.0]", "0.04"), "diameter",
         "reaches 0.01 m beyond the end of the face"},
        {gauge("body_pressure", "[0.12, 0.11]", "0.04"), "diameter", "reaches 0.01 m beyond the end"},
        {"type = \"water_depth\"\nx = 1.1\nwidth = 0.1", "x", "1.1 m is outside the tank, expected 0 to 1 m"},
        {"type = \"water_depth\"\nx = -0.01\nwidth = 0.1", "x", "-0.01 m is outside the tank"},
        {"type = \"free_surface\"\nlow = -0.1\nhigh = 0.5\npoints = 4", "low", "-0.1 m is outside the tank"},
        {"type = \"free_surface\"\nlow = 0.5\nhigh = 1.5\npoints = 4", "high", "1.5 m is outside the tank"},
        {"type = \"face_pressure\"\nfrom = [0.0, 0.0]\nto = [0.12, 0.12]\npoints = 4", "to",
         "leaves the outline"},
        {"type = \"face_pressure\"\nfrom = [0.0, 0.0]\nto = [0.12, 0.05]\npoints = 4", "to",
         "leaves the outline"},
        {on_tank("[1.0, 0.0]", "[0.9, 0.2]"), "from", "is not part of the right wall"},
        {on_tank("[1.0, 0.0]", "[1.0, 0.6]"), "to", "is not part of the right wall"},
        {on_tank("[1.0, -0.1]", "[1.0, 0.2]"), "from", "is not part of the right wall"},
        {on_tank("[0.9, 0.1]", "[0.9, 0.2]"), "from", "expected two points of one side of the tank"},
        {on_tank("[0.0, 0.0]", "[1.0, 0.48]"), "from", "expected two points of one side of the tank"},
        {on_tank("[0.2, 0.0]", "[0.2, 0.0]"), "to", "is the same point as 'from'"},
        {on_tank("[0.1, 0.01]", "[0.4, 0.01]"), "from", "is not part of the floor"},
        {on_tank("[0.1, 0.48]", "[1.4, 0.48]"), "to", "is not part of the roof"},
        {on_tank("[0.0, 0.3]", "[0.0, 0.5]"), "to", "is not part of the left wall"},
        {on_tank("[0.1, 0.0]", "[0.4, 0.0]", 1), "points", "expected 2 to 10000"},
        {"type = \"face_pressure\"\nbody = \"hull\"\nfrom = [0.0, 0.0]\nto = [0.12, 0.0]\npoints = 4", "body",
         "is 'hull', expected one of body, tank"},
        {"type = \"air_film\"\nfrom = [0.06, 0.0]\nto = [0.12, 0.06]", "to", "leaves the outline of body"},
        {"type = \"air_film\"\nfrom = [0.06, 0.05]\nto = [0.12, 0.06]", "from", "off the outline of body"},
        {"type = \"front\"\nx_range = [1.0, 2.0]", "x_range", "1 to 2 m lies outside the tank"},
        {"type = \"front\"\ny_range = [-1.0, 0.0]", "y_range",
         "lies outside the tank, expected a part of 0 to 0.48"},
        {"type = \"front\"\nx_range = [0.5, 0.2]", "x_range", "expected a begin below its end"},
        {"type = \"front\"\nx_range = [0.12, 0.2]\ny_range = [0.26, 0.3]", "x_range",
         "lies in body, which never"},
        {"type = \"front\"\ndirection = \"east\"", "direction", "expected one of right, left, up, down"},
    };
    for (const Refusal& row : rows) {
        CAPTURE(row.keys);
        const std::string said = refusal(probe(row.keys));
        CHECK_THAT(said, StartsWith("small.toml:"));
        CHECK_THAT(said, Contains(fmt::format("key 'probes[3].{}': ", row.key)) && Contains(row.message));
    }
}

TEST_CASE("a gauge or an end of a face within the finest spacing of it is moved onto it, with a note",
          "[probe]") {
    struct Moved {
        std::string keys, key, message;
        Vec2 place;
    };
    const auto face = [](const char* type, const char* from, const char* to) {
        return fmt::format("type = \"{}\"\nfrom = {}\nto = {}{}", type, from, to,
                           std::string(type) == "air_film" ? "" : "\npoints = 4");
    };
    const std::vector<Moved> rows = {
        {gauge("wall_pressure", "[0.01, 0.3]", "0.04"), "centre", "0.01 m off the left wall", {0, 0.28}},
        {gauge("wall_pressure", "[1.015, 0.3]", "0.04"), "centre", "taken for (1, 0.3) m", {1, 0.28}},
        {gauge("wall_pressure", "[0.5, 0.001]", "0.04"), "centre", "0.001 m off the floor", {0.48, 0}},
        {gauge("wall_pressure", "[0.5, -0.019]", "0.04"), "centre", "0.019 m off the floor", {0.48, 0}},
        {gauge("wall_pressure", "[0.5, 0.47]", "0.04"), "centre", "0.01 m off the roof", {0.48, 0.48}},
        {gauge("body_pressure", "[0.06, -0.015]", "0.04"), "centre", "taken for (0.06, 0) m", {0.16, 0.24}},
        {gauge("body_pressure", "[0.06, 0.00001]", "0.04"), "centre", "1e-05 m off the face", {0.16, 0.24}},
        {gauge("body_pressure", "[0.11, 0.06]", "0.04"), "centre", "taken for (0.12, 0.06) m", {0.22, 0.3}},
        {face("face_pressure", "[0.02, 0.004]", "[0.1, 0.0]"), "from", "taken for (0.02, 0) m", {0.12, 0.24}},
        {face("face_pressure", "[0.02, 0.0]", "[0.1, -0.004]"), "to", "taken for (0.1, 0) m", {0.12, 0.24}},
        {face("air_film", "[0.02, 0.0]", "[0.1, 0.003]"), "to", "0.003 m off the face", {0.12, 0.24}}};
    for (const Moved& row : rows) {
        CAPTURE(row.keys);
        const Scene scene = parse_scene(probe(row.keys), "small.toml");
        REQUIRE(scene.notes.size() == 1);
        CHECK_THAT(scene.notes[0], StartsWith("small.toml:"));
        CHECK_THAT(scene.notes[0],
                   Contains(fmt::format("key 'probes[3].{}': ", row.key)) && Contains(row.message));
        CHECK((scene.probes.back().place->begin - row.place).norm() < 1e-12);
    }
    CHECK(parse_scene(probe(gauge("wall_pressure", "[0.5, 0.0]", "0.04")), "small.toml").notes.empty());
}

TEST_CASE("a gauge may lie anywhere on a face that its disc fits", "[probe]") {
    for (const char* centre :
         {"[0.5, 0.0]", "[0.02, 0.0]", "[0.98, 0.48]", "[0.0, 0.02]", "[1.0, 0.46]", "[1.0, 0.2]"})
        CHECK(refusal(probe(gauge("wall_pressure", centre, "0.04"))) == "");
    for (const char* centre : {"[0.02, 0.0]", "[0.1, 0.12]", "[0.0, 0.02]", "[0.12, 0.06]"})
        CHECK(refusal(probe(gauge("body_pressure", centre, "0.04"))) == "");
}

TEST_CASE("a profile on the tank needs no body", "[probe]") {
    const std::string line = "type = \"face_pressure\"\npoints = 4\nfrom = [1.0, 0.0]\nto = [1.0, 0.48]\n";
    const Scene scene = parse_scene(small_scene + "[[probes]]\nname = \"new\"\n" + line, "small.toml");
    CHECK(scene.probes.back().series.abscissa == std::vector<double>{0.06, 0.18, 0.3, 0.42});
}

TEST_CASE("a face of a body goes on over short sides that turn little, and ends at a corner", "[probe]") {
    Outline arc;  // the lower half of a circle in pieces of 6 degrees, and a flat top
    constexpr double step = 6 * 3.14159265358979323846 / 180, radius = 0.5;
    for (int k = 0; k <= 30; ++k)
        arc.emplace_back(-radius * std::cos(k * step), -radius * std::sin(k * step));
    const double side = 2 * radius * std::sin(0.5 * step);
    const FacePlace bottom = nearest_face(arc, 0.5 * (arc[14] + arc[15]));
    CHECK(bottom.before == Approx(1.5 * side));  // one side turns by 6 degrees, the next one by 12
    CHECK(bottom.after == Approx(1.5 * side));
    const FacePlace top = nearest_face(arc, {0.2, 0});
    CHECK(top.before == Approx(0.3));
    CHECK(top.after == Approx(0.7));
}

TEST_CASE("the normal of a face points into the fluid, whatever the order of the corners", "[probe]") {
    const Box tank{{0, 0}, {3, 2}};
    CHECK(nearest_wall(tank, {1, 0}).normal == Vec2(0, 1));
    CHECK(nearest_wall(tank, {1, 2}).normal == Vec2(0, -1));
    CHECK(nearest_wall(tank, {0, 1}).normal == Vec2(1, 0));
    CHECK(nearest_wall(tank, {3, 1}).normal == Vec2(-1, 0));
    const Outline counter = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, clockwise(counter.rbegin(), counter.rend());
    for (const Outline& diamond : {counter, clockwise}) {
        for (const Vec2& middle : {Vec2(0.5, 0.5), Vec2(-0.5, 0.5), Vec2(-0.5, -0.5), Vec2(0.5, -0.5)}) {
            CAPTURE(middle.x(), middle.y());
            CHECK((nearest_face(diamond, middle).normal - middle.normalized()).norm() < 1e-12);
        }
    }
}

TEST_CASE("the gap in front of a face does not depend on the order of its ends or of the corners",
          "[probe]") {
    const char* counter = "[[0.0, 0.0], [0.12, 0.0], [0.12, 0.12], [0.0, 0.12]]";
    const char* clockwise = "[[0.0, 0.0], [0.0, 0.12], [0.12, 0.12], [0.12, 0.0]]";
    struct Face {
        const char *from, *to;
        double gap;
    };
    const double none = std::hypot(1.0, 0.48) - 0.02;
    const std::vector<Face> faces = {{"[0.0, 0.0]", "[0.12, 0.0]", 0.04},
                                     {"[0.02, 0.0]", "[0.08, 0.0]", 0.04},
                                     {"[0.0, 0.12]", "[0.12, 0.12]", none},
                                     {"[0.0, 0.0]", "[0.0, 0.12]", none},
                                     {"[0.12, 0.0]", "[0.12, 0.12]", none}};
    for (const Face& face : faces) {
        for (const char* corners : {counter, clockwise}) {
            for (const bool turned : {false, true}) {
                const std::string text =
                    replaced(probe(fmt::format("type = \"air_film\"\nfrom = {}\nto = {}",
                                               turned ? face.to : face.from, turned ? face.from : face.to)),
                             counter, corners);
                const Scene scene = parse_scene(text, "small.toml");
                std::vector<double> gap;
                scene.probes.back().sample(assemble(scene, 0.04, 1), gap);
                CAPTURE(face.from, face.to, corners, turned);
                CHECK(gap.at(0) == Approx(face.gap));
                const std::vector<std::string>& doubts = scene.probes.back().doubts;
                REQUIRE(doubts.size() == (face.gap == none ? 1 : 0));
                if (!doubts.empty())
                    CHECK_THAT(doubts[0], Contains("probes[3].from") && Contains("no water is in front"));
            }
        }
    }
}

TEST_CASE("a front that has arrived at the start is doubted, by file, line and key", "[probe]") {
    struct Row {
        std::string water, keys, doubt;
    };
    const std::string left = "[0.0, 0.0, 0.4, 0.2]", right = "[0.6, 0.0, 1.0, 0.2]";
    const std::vector<Row> rows = {
        {left, "", ""},
        {right, "", "touches the right wall (x = 1 m)"},
        {right, "direction = \"right\"", "touches the right wall (x = 1 m)"},
        {right, "direction = \"left\"", ""},
        {left, "direction = \"left\"", "touches the left wall (x = 0 m)"},
        {left + ", " + right, "", "touches the right wall"},
        {left + ", " + right, "x_range = [0.0, 0.5]", ""},
        {left + ", " + right, "x_range = [0.0, 0.7]", "touches the end of the range (x = 0.7 m)"},
        {right, "y_range = [0.24, 0.4]", ""},
        {left, "direction = \"down\"", "touches the floor (y = 0 m)"},
        {left, "direction = \"up\"", ""},
        {left, "direction = \"up\"\ny_range = [0.0, 0.16]", "touches the end of the range (y = 0.16 m)"},
        {left, "direction = \"left\"\nx_range = [0.2, 0.9]", "touches the end of the range (x = 0.2 m)"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.water, row.keys);
        const std::string text =
            replaced(replaced(with("boxes = [[0.4, 0.0, 1.0, 0.2], [0.0, 0.2, 1.0, 0.48]]", "boxes = []"),
                              "[0.0, 0.0, 0.4, 0.2]", row.water),
                     "type = \"front\"\n", "type = \"front\"\n" + row.keys + "\n");
        const std::vector<std::string> doubts = parse_scene(text, "small.toml").probes.front().doubts;
        if (row.doubt.empty()) {
            CHECK(doubts.empty());
            continue;
        }
        REQUIRE(doubts.size() == 1);
        CHECK_THAT(doubts[0], StartsWith("small.toml:") && Contains("key 'probes[0].direction': is ") &&
                                  Contains(row.doubt));
        CHECK_THAT(doubtful(parse_scene(text, "small.toml")), Catch::VectorContains(doubts[0]));
    }
}
