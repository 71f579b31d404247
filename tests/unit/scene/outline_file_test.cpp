// SPDX-License-Identifier: BSD-3-Clause
// Outlines of bodies from files of corners, mirrored halves, and curves that lie beside a scene.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/scene/outline_file.hpp"

using namespace wetdeck;
using Catch::Contains;
using Catch::EndsWith;
using samples::ScratchFolder;

namespace {

/// The small scene with a body that is given so; an accent in front of it, as texts have them.
std::string with_body(const std::string& outline) {
    return samples::with("[model]",
                         "[body]\nname_of_nothing = 0 # d\xC3\xA9riv\xC3\xA9"
                         "e\n" +
                             outline + "\nposition = [0.6, 0.3]\nfree = [\"y\"]\nmass = 5.0\n\n[model]");
}

std::string body_of(const std::string& outline) {
    return samples::replaced(with_body(outline), "name_of_nothing = 0 ", "");
}

/// What is said against a file of corners.
std::string refusal_of(const ScratchFolder& folder, const std::string& corners) {
    samples::put_bytes(folder / "hull.csv", corners);
    try {
        read_outline(folder / "hull.csv");
    } catch (const InputError& error) {
        return std::string(error.what()).substr((folder / "hull.csv").string().size());
    }
    return {};
}

}  // namespace

TEST_CASE("corners are read with commas, semicolons or spaces, names and remarks passed over") {
    const ScratchFolder folder;
    const Outline expected = {{0, -0.5}, {1.5, 0}, {1e-3, 2}};
    for (const char* text :
         {"0,-0.5\n1.5,0\n1e-3,2\n", "x [m], y [m]\n0, -0.5\n1.5 , 0\n0.001,2.0\n",
          "# section 7\r\n\r\n0;-0.5\r\n1.5;0\r\n1e-3;2\r\n", "  0 -.5\n\t1.5\t0\n+1e-3 2  \n0 -0.5\n"}) {
        INFO(text);
        CHECK(refusal_of(folder, text).empty());
        CHECK(read_outline(folder / "hull.csv") == expected);
    }
}

TEST_CASE("a file of corners that is none is refused with its line") {
    const ScratchFolder folder;
    const std::string two_numbers = "expected two numbers, x and y [m]";
    CHECK(refusal_of(folder, "0,0\n1\n0,1\n") == ":2: " + two_numbers);
    CHECK(refusal_of(folder, "0,0\n1,0,0\n0,1\n") == ":2: " + two_numbers);
    CHECK(refusal_of(folder, "0,0\n1,nan\n0,1\n") == ":2: " + two_numbers);
    CHECK(refusal_of(folder, "0,0\n1,0m\n0,1\n") == ":2: " + two_numbers);
    CHECK(refusal_of(folder, "0,0\n1,0\nend\n") == ":3: " + two_numbers);
    CHECK(refusal_of(folder, "x,y\nin metres\n0,0\n") == ":2: " + two_numbers);
    CHECK(refusal_of(folder, "0,0\n1,0\n1,0\n0,1\n") == ":3: is the same corner as the one before");
    CHECK(refusal_of(folder, "0,0\n1,0\n0,0\n") ==
          ": holds 2 corners, expected at least 3 lines of x, y [m]");
    CHECK(refusal_of(folder, "") == ": holds 0 corners, expected at least 3 lines of x, y [m]");
    std::string many;
    for (int k = 0; k <= 10'000; ++k) many += std::to_string(k) + ",0\n";
    CHECK(refusal_of(folder, many) == ":10001: more than 10000 corners");
    CHECK_THROWS_WITH(read_outline(folder / "none.csv"), EndsWith("none.csv: no such file of corners"));
}

TEST_CASE("a scene takes the outline of a body from a file, and needs the file no more") {
    const ScratchFolder folder;
    const std::string named = body_of("outline = 'hulls/a.csv' # as built"),
                      written = body_of("outline = [[0.0, 0.0], [0.1, 0.05], [-0.1, 0.05]]");
    std::filesystem::create_directory(folder / "hulls");
    samples::put_bytes(folder / "hulls/a.csv", "x,y\n0,0\n0.1,0.05\n-0.1,0.05\n");
    samples::put_bytes(folder / "named.toml", named);
    const Scene scene = read_scene(folder / "named.toml");
    const Scene expected = parse_scene(written, "written.toml");
    REQUIRE(scene.bodies.size() == 1);
    CHECK(scene.bodies[0].outline == expected.bodies.at(0).outline);
    CHECK(std::count(scene.text.begin(), scene.text.end(), '\n') ==
          std::count(named.begin(), named.end(), '\n'));
    CHECK_THAT(scene.text, Contains(" # as built"));
    std::filesystem::remove_all(folder / "hulls");
    const auto before = named.begin() + static_cast<std::ptrdiff_t>(named.find("outline = "));
    const std::string line = std::to_string(1 + std::count(named.begin(), before, '\n'));
    CHECK(parse_scene(scene.text, scene.path).bodies[0].outline == expected.bodies[0].outline);
    CHECK_THROWS_WITH(read_scene(folder / "named.toml"),
                      Contains("named.toml:" + line + ": key 'body.outline': ") &&
                          EndsWith("a.csv: no such file of corners"));
}

TEST_CASE("an outline is found behind letters of several bytes, and in a variant") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "a.csv", "0 0\n0.1 0.05\n-0.1 0.05\n");
    samples::put_bytes(folder / "b.csv", "0 0\n0.2 0.05\n-0.2 0.05\n");
    const std::string text = with_body("\"caf\xC3\xA9\".outline = \"b.csv\"\noutline = \"a.csv\"");
    const std::string all = with_outlines(text, folder / "scene.toml");
    CHECK_THAT(all,
               Contains("\"caf\xC3\xA9\".outline = [[0, 0], [0.2, 0.05], [-0.2, 0.05]]\noutline = [[0, 0], "
                        "[0.1, 0.05], [-0.1, 0.05]]\n"));
    const std::string variant = samples::replaced(body_of("outline = \"a.csv\""), "model.air = false",
                                                  "model.air = false\nbody.outline = \"b.csv\"");
    samples::put_bytes(folder / "variant.toml", variant);
    CHECK(read_scene(folder / "variant.toml", "single-phase").bodies.at(0).outline[1] == Vec2(0.8, 0.35));
    CHECK(read_scene(folder / "variant.toml", "two-phase").bodies.at(0).outline[1] == Vec2(0.7, 0.35));
}

TEST_CASE("half of a mirrored body is enough") {
    const Scene scene =
        parse_scene(body_of("mirrored = true\noutline = [[0, 0], [0.1, 0.05], [0.12, 0.1]]"), "a");
    const Outline expected = {{0.6, 0.3}, {0.7, 0.35}, {0.72, 0.4}, {0.48, 0.4}, {0.5, 0.35}};
    REQUIRE(scene.bodies.at(0).outline.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK((scene.bodies[0].outline[k] - expected[k]).norm() < 1e-15);
    CHECK(scene.bodies[0].body.position.x() == Approx(0.6));
    CHECK_THAT(samples::refusal(body_of("mirrored = true\noutline = [[0, 0], [0.1, 0.05], [-0.1, 0.05]]")),
               EndsWith("key 'body.outline': of a mirrored body has a corner at x < 0"));
}

TEST_CASE("a curve beside the scene file comes before that of the program") {
    const ScratchFolder own, program;
    samples::put_bytes(program / "a.csv", "");
    CHECK(reference_file("a", own, program) == program / "a.csv");
    samples::put_bytes(own / "a.csv", "");
    CHECK(reference_file("a", own, program) == own / "a.csv");
    CHECK(reference_file("a", {}, program) == program / "a.csv");
    CHECK(reference_file("b", own, program) == program / "b.csv");
    samples::put_bytes(own / "tank.toml", samples::small_scene);
    CHECK(read_scene(own / "tank.toml").analysis.folder == std::filesystem::path(own));
}
