// SPDX-License-Identifier: BSD-3-Clause
// Given motions, springs, solids and planes of symmetry in scene files: what they do, and what is refused.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"
#include "validation/scene/body_figures.hpp"
#include "validation/scene/identity.hpp"
#include "validation/scene/number_columns.hpp"

using namespace wetdeck;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

constexpr const char* box =
    "[body]\noutline = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]\n"
    "position = [0.5, 0.34]\nfree = []\n\n";

std::string with_body(const std::string& more = "") {
    return samples::with("[initial]\n", box + more + "\n[initial]\n");
}

std::string refused(const std::vector<std::string>& overrides, const std::string& more = "") {
    return samples::refusal(with_body(more), std::nullopt, overrides);
}

Scene scene_with(const std::vector<std::string>& overrides, const std::string& more = "") {
    return parse_scene(with_body(more), "scene.toml", std::nullopt, overrides);
}

/// A folder with a scene whose body takes its motion from a file.
struct Folder {
    fs::path path = fs::temp_directory_path() / "wetdeck_motion_section_test";
    Folder() {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder() { fs::remove_all(path); }
    void write(const char* name, const std::string& text) const { std::ofstream(path / name) << text; }
    Scene read(const std::string& motion_file) const {
        write("motion.csv", motion_file);
        std::string text = with_body();
        const std::string free = "free = []\n";
        text.replace(text.find(free), free.size(), free + "motion = \"motion.csv\"\n");
        write("scene.toml", text);
        return read_scene(path / "scene.toml");
    }
    std::string refusal(const std::string& motion_file) const {
        try {
            read(motion_file);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }
};

}  // namespace

TEST_CASE("a motion is read from a file with units, and stays with the scene", "[motion][scene]") {
    const Folder folder;
    const Scene scene = folder.read("t [ms]; y [mm]; angle [deg]\n0; 1; 0\n100; -19; 9\n200; -39; 18\n");
    const auto& motion = scene.bodies.at(0).body.guide.motion;
    REQUIRE(motion[1]);
    CHECK_FALSE(motion[0]);
    CHECK(motion[1](0).displacement == 0);  // counted from the start
    CHECK(motion[1](0.1).displacement == Approx(-0.02));
    CHECK(motion[1](0.05).velocity == Approx(-0.2));
    CHECK(motion[2](0.2).displacement == Approx(std::numbers::pi / 10));
    // the text of the run needs the file no more
    const Scene again = parse_scene(scene.text, scene.path);
    CHECK(setup_identity(again) == setup_identity(scene));
    CHECK(again.bodies.at(0).body.guide.motion[1](0.1).displacement == Approx(-0.02));
    const Scene other = folder.read("t [ms]; y [mm]; angle [deg]\n0; 1; 0\n100; -18; 9\n200; -39; 18\n");
    CHECK(setup_identity(other) != setup_identity(scene));
}

TEST_CASE("bad motion files are refused with one line", "[motion][scene]") {
    const Folder folder;
    const std::pair<const char*, const char*> table[] = {
        {"t, y\n0, 0\n0.1, -0.01\n0.1, -0.02\n0.2, 0\n", "times that increase"},
        {"t, y\n0, 0\n0.1, -0.01\n", "expected samples from 0 to the end of the run at 0.2 s"},
        {"t, y\n0.1, 0\n0.2, 0\n", "expected samples from 0"},
        {"t, y\n0, 0\n0.001, 0\n0.002, 0\n0.003, 0\n0.004, 0\n0.2, 0\n", "has a gap from 0.004 to 0.2 s"},
        {"t, y\n0, 0\n0.1, 0\n0.1001, -0.03\n0.2, -0.03\n", "below that of sound in the water, 14 m/s"},
        {"t, y\n0, 0\n0.2, -0.4\n", "leads it out of the tank"},
        {"t, z\n0, 0\n0.2, 0\n", "a column is named 'z', expected t, x, y, angle"},
        {"t, y [s]\n0, 0\n0.2, 0\n", "column 'y' is in s, expected a unit such as m"},
        {"t, angle\n0, 0\n0.2, 8\n", "names no unit, expected 'angle [deg]'"},
        {"t, y, velocity_y\n0, 0, 0\n0.2, 0, 0\n", "the y is given twice"},
        {"t\n0\n0.2\n", "stands alone"},
        {"0, 0\n0.2, 0\n", "expected a line of titles"},
        {"t, y\n0, 0\n0.2\n", "motion.csv:3: holds 1 numbers, expected 2"},
        {"t, y\n0, nan\n0.2, 0\n", "motion.csv:2: 'nan' is no finite number"},
        {"", "holds no numbers"},
    };
    for (const auto& [text, expected] : table) {
        INFO(text);
        const std::string said = folder.refusal(text);
        CHECK_THAT(said, Contains(expected) && Contains("scene.toml") && !Contains("\n"));
    }
}

TEST_CASE("formulas of motion are read, and wrong ones refused", "[motion][scene]") {
    const Scene ramp = scene_with({"body.motion.y={formula=\"ramp\",velocity=-0.3,over=0.1}"});
    CHECK(ramp.bodies[0].body.guide.motion[1](0.2).velocity == Approx(-0.3));
    const Scene roll =
        scene_with({"body.motion.rotation={formula=\"harmonic\",amplitude=\"5 deg\",period=0.4}"});
    CHECK(roll.bodies[0].body.guide.motion[2](0.1).displacement == Approx(std::numbers::pi / 36));
    const Scene pieces =
        scene_with({"body.motion.x={formula=\"piecewise\",times=[0.0,0.1,0.2],velocities=[0.0,1.0,0.0]}"});
    CHECK(pieces.bodies[0].body.guide.motion[0](0.2).displacement == Approx(0.1));
    CHECK(setup_identity(ramp) != setup_identity(roll));

    const std::pair<std::vector<std::string>, const char*> table[] = {
        {{"body.motion.y={formula=\"ramp\",velocity=-0.3}"}, "key 'body.motion.y.over': missing"},
        {{"body.motion.y={formula=\"step\"}"}, "key 'body.motion.y.formula'"},
        {{"body.motion.y={formula=\"harmonic\",amplitude=0.01}"}, "needs a positive period"},
        {{"body.motion.y={formula=\"constant\",velocity=\"3 kg\"}"}, "expected m/s"},
        {{"body.motion.y={formula=\"constant\",speed=3.0}"}, "key 'body.motion.y.speed'"},
        {{"body.motion.y={formula=\"constant\",velocity=-1.0}", "body.free=[\"y\"]", "body.mass=5.0"},
         "take y out of 'free', or give a 'release'"},
        {{"body.motion.z={formula=\"constant\",velocity=-1.0}"}, "key 'body.motion.z'"},
        {{"body.pivot=[0.0,0.0]", "body.free=[\"y\"]", "body.mass=5.0"}, "holds the body along x and y"},
        {{"body.release=\"contact\""}, "lets nothing go"},
        {{"body.release=-1.0", "body.free=[\"y\"]", "body.mass=5.0"}, "or a positive time"},
        {{"body.angle=30"}, "degrees are written \"8 deg\""},
        {{"body.speed=3.0", "body.velocity_y=-1.0"}, "takes the place of velocity_x"},
        {{"body.mass=3.0", "body.density=500.0"}, "one of the two"},
        {{"tank.motion.rotation={formula=\"constant\",velocity=0.1}"}, "key 'tank.roll_centre': missing"},
    };
    for (const auto& [overrides, expected] : table) {
        INFO(overrides[0]);
        CHECK_THAT(refused(overrides), Contains(expected));
    }
}

TEST_CASE("heel, direction of entry and density set pose, velocity and mass", "[scene]") {
    const Scene scene = scene_with({"body.angle=\"30 deg\"", "body.speed=2.0", "body.direction=\"20 deg\"",
                                    "body.density=500.0", "body.free=[\"y\"]"});
    const BodySpec& spec = scene.bodies.at(0);
    CHECK(spec.body.angle == Approx(std::numbers::pi / 6));
    CHECK(spec.body.mass == Approx(500 * 0.02));
    CHECK(spec.body.velocity.x() == Approx(2 * std::sin(std::numbers::pi / 9)));
    CHECK(spec.body.velocity.y() == Approx(-2 * std::cos(std::numbers::pi / 9)));
    CHECK((spec.outline[1] - Vec2(0.5, 0.34) -
           Vec2(0.1 * std::cos(std::numbers::pi / 6) + 0.05 * 0.5,
                0.1 * 0.5 - 0.05 * std::cos(std::numbers::pi / 6)))
              .norm() < 1e-12);
    CHECK((spec.local_outline()[1] - Vec2(0.1, -0.05)).norm() < 1e-12);
    // the particles of the surface lie within the turned outline
    const Simulation simulation = assemble(scene, 0.02, 1);
    for (std::size_t n = simulation.walls().fixed; n < simulation.walls().size(); ++n) {
        const WallState& p = simulation.walls().state[n];
        CHECK(contains(spec.outline, {p.x, p.y}));
    }
}

TEST_CASE("springs are read with their frames, and wrong ones refused", "[spring][scene]") {
    const std::vector<std::string> moves = {"body.free=[\"y\",\"rotation\"]", "body.mass=10.0"};
    const Scene scene =
        scene_with(moves,
                   "[[body.springs]]\ndirection = \"y\"\nstiffness = 100.0\nplay = [-0.1, 0.0]\n"
                   "[[body.springs]]\non_body = [0.1, 0.05]\non_earth = [0.6, 0.47]\n"
                   "slack = true\nstiffness = 50.0\ndamping = 1.0\n");
    const std::vector<Spring>& springs = scene.bodies.at(0).body.springs;
    REQUIRE(springs.size() == 2);
    CHECK(springs[0].pull(0.1, 0) == Approx(10));
    CHECK(springs[0].pull(-0.05, 0) == 0);
    CHECK(springs[1].free_length == Approx(0.08));
    CHECK((springs[1].on_body - Vec2(0.1, 0.05)).norm() < 1e-12);
    const std::pair<const char*, const char*> table[] = {
        {"direction = \"y\"\n", "expected a stiffness, a damping or a table"},
        {"direction = \"z\"\nstiffness = 1.0\n", "direction'"},
        {"direction = \"y\"\nstiffness = -1.0\n", "expected zero or a positive number"},
        {"direction = \"y\"\nstiffness = 1.0\nplay = [0.1, 0.2]\n", "expected [low, high]"},
        {"direction = \"y\"\ntable = [[0.0, 0.0]]\n", "at least two rows"},
        {"direction = \"y\"\ntable = [[0.0, 0.0], [0.0, 1.0]]\n", "elongations that increase"},
        {"direction = \"y\"\nstiffness = 1.0\ntable = [[0.0, 0.0], [1.0, 1.0]]\n", "takes the place"},
        {"on_body = [0.0, 0.0]\non_earth = [0.5, 0.34]\nstiffness = 1.0\n", "is the same point"},
    };
    for (const auto& [spring, expected] : table) {
        INFO(spring);
        CHECK_THAT(refused(moves, std::string("[[body.springs]]\n") + spring), Contains(expected));
    }
    CHECK_THAT(refused({}, "[[body.springs]]\ndirection = \"y\"\nstiffness = 1.0\n"),
               Contains("pull a body that no force moves"));
    const Scene stiff = scene_with(moves, "[[body.springs]]\ndirection = \"y\"\nstiffness = 1e9\n");
    CHECK_THROWS_WITH(check_spacing(stiff, 0.02), Contains("too stiff") && Contains("body.springs"));
    CHECK_NOTHROW(check_spacing(scene, 0.02));
}

TEST_CASE("solids stand in the tank and may touch it, those that overlap are refused", "[solids][scene]") {
    const std::string step =
        "[[solids]]\nname = \"step\"\noutline = [[0.6, 0.0], [1.0, 0.0], [1.0, 0.1], [0.6, 0.1]]\n";
    const Scene scene = scene_with({"probes.gauge.centre=[1.0,0.3]"}, step);
    REQUIRE(scene.bodies.size() == 2);
    CHECK(scene.bodies[1].name == "step");
    const Simulation simulation = assemble(scene, 0.02, 1);
    std::size_t in_step = 0;
    for (std::size_t n = simulation.walls().fixed; n < simulation.walls().size(); ++n) {
        const WallState& p = simulation.walls().state[n];
        if (simulation.walls().body_point[n].body != 1) continue;
        ++in_step;
        CHECK((p.x > 0.6 && p.y < 0.1 && p.y > 0 && p.x < 1.0));
    }
    CHECK(in_step > 50);
    for (const FluidState& p : simulation.fluid().state) CHECK_FALSE((p.x > 0.6 && p.y < 0.1));
    CHECK_THAT(refused({}, step + "[[solids]]\noutline = [[0.9, 0.05], [1.0, 0.05], [1.0, 0.2]]\n"),
               Contains("overlaps that of step"));
    CHECK_THAT(
        refused({}, step + "[[solids]]\nname = \"step\"\noutline = [[0.1, 0.3], [0.2, 0.3], [0.2, 0.4]]\n"),
        Contains("'step' is taken"));
    CHECK_THAT(refused({}, "[[solids]]\noutline = [[0.9, -0.05], [1.0, 0.05], [1.0, 0.2]]\n"),
               Contains("reaches outside the tank"));
    CHECK_THAT(refused({"body.motion.y={formula=\"constant\",velocity=-1.0}", "run.end_time=0.1"},
                       "[[solids]]\noutline = [[0.3, 0.0], [0.7, 0.0], [0.7, 0.25], [0.3, 0.25]]\n"),
               Contains("leads it into solid"));
}

TEST_CASE("a tank may be a polygon, whose corners are solids", "[solids][scene]") {
    std::string text = samples::small_scene;
    const std::string size = "size = [1.0, 0.48]";
    text.replace(text.find(size), size.size(),
                 "outline = [[0.2, 0.0], [0.8, 0.0], [1.0, 0.2], [1.0, 0.48], [0.0, 0.48], [0.0, 0.2]]");
    const Scene scene = parse_scene(text, "scene.toml", std::nullopt, {"probes.gauge.centre=[1.0,0.3]"});
    CHECK(scene.tank.high == Vec2(1.0, 0.48));
    REQUIRE(scene.bodies.size() == 2);
    double area = 0;
    for (const BodySpec& wall : scene.bodies) area += area_moments(wall.outline).area;
    CHECK(area == Approx(2 * 0.5 * 0.2 * 0.2));
    CHECK(scene.bodies[0].name == "tank_wall");
}

TEST_CASE("a plane of symmetry halves the particles and keeps the body, asymmetry is refused",
          "[symmetry][scene]") {
    const std::vector<std::string> symmetric = {"water.boxes=[[0.0,0.0,1.0,0.2]]",
                                                "air.boxes=[[0.0,0.2,1.0,0.48]]", "symmetry.x=0.5"};
    const auto said = [&](std::vector<std::string> more) {
        more.insert(more.begin(), symmetric.begin(), symmetric.end());
        return refused(more);
    };
    CHECK(said({}) == "");
    CHECK_THAT(said({"symmetry.x=0.4"}), Contains("expected the middle of the tank, 0.5 m"));
    CHECK_THAT(said({"water.boxes=[[0.0,0.0,0.4,0.2]]"}), Contains("the boxes of water are not symmetric"));
    CHECK_THAT(said({"body.position=[0.52,0.34]"}), Contains("body: its outline is not symmetric"));
    CHECK_THAT(said({"body.velocity_x=0.1"}), Contains("its velocity is not symmetric"));
    CHECK_THAT(said({"body.free=[\"x\"]", "body.mass=5.0"}), Contains("its freedom"));
    CHECK_THAT(said({"gravity=[1.0,-9.81]"}), Contains("gravity is not symmetric"));
    CHECK_THAT(said({"gravity=[1.0,-9.81]"}), Contains("symmetry.x = \"none\" computes the whole tank"));
    CHECK(said({"gravity=[1.0,-9.81]", "symmetry.x=\"none\""}) == "");
    CHECK_THAT(said({"symmetry.x=\"left\""}), Contains("expected the middle of the tank or \"none\""));
    CHECK_FALSE(scene_with({"symmetry.x=\"none\""}).symmetry);
}

TEST_CASE("figures of a body at rest and of its entry", "[scene]") {
    const Scene scene = scene_with({"body.free=[\"y\"]", "body.mass=10.0", "body.velocity_y=-1.0"});
    const BodyFigures figures = body_figures(scene, scene.bodies.at(0));
    CHECK(figures.area == Approx(0.02));
    CHECK(figures.draught.value() == Approx(0.05));
    const double added = 1000 * std::numbers::pi * 0.04 / 8;
    CHECK(figures.heave_period.value() ==
          Approx(2 * std::numbers::pi * std::sqrt((10 + added) / (1000 * 9.81 * 0.2))));
    // from y = 0.29 at 1 m/s down to the floor, which is dry below
    CHECK_FALSE(figures.first_contact);
    const Scene wet = scene_with({"body.position=[0.2,0.34]", "body.free=[\"y\"]", "body.mass=10.0",
                                  "body.velocity_y=-1.0", "gravity=[0.0,-9.81]"});
    const BodyFigures entry = body_figures(wet, wet.bodies.at(0));
    CHECK(entry.speed.value() == Approx(std::sqrt(1 + 2 * 9.81 * 0.09)));
    CHECK(entry.first_contact.value() == Approx((std::sqrt(1 + 2 * 9.81 * 0.09) - 1) / 9.81));
    CHECK(entry.froude.value() == Approx(entry.speed.value() / std::sqrt(9.81 * 0.2)));
}

TEST_CASE("two hulls that are joined have one mass centre and one mass", "[motion][scene]") {
    const std::string second =
        "[body_2]\njoined_to = \"body\"\noutline = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]\n"
        "position = [0.2, 0.34]\n";
    const Scene scene =
        scene_with({"body.free=[\"y\",\"rotation\"]", "body.density=500.0", "body.angle=0.1"}, second);
    REQUIRE(scene.bodies.size() == 2);
    const RigidBody& body = scene.bodies[0].body;
    CHECK(body.mass == Approx(2 * 0.02 * 500));
    CHECK((body.position - Vec2(0.35, 0.34)).norm() < 1e-12);
    CHECK(body.inertia == Approx(2 * (10 * (0.04 + 0.01) / 12 + 10 * 0.15 * 0.15)));
    const Scene upright = scene_with({"body.free=[\"y\"]", "body.density=500.0"}, second);
    const BodyFigures figures = body_figures(upright, upright.bodies[0]);
    CHECK(figures.area == Approx(0.04));
    CHECK(figures.beam == Approx(0.5));
    CHECK(figures.draught.value() == Approx(0.05));  // half as heavy as water: half of 0.1 m
    const BodySpec& joined = scene.bodies[1];
    CHECK(joined.body.joined_to == 0U);
    CHECK((joined.body.position - Vec2(0.35 - 0.15 * std::cos(0.1), 0.34 - 0.15 * std::sin(0.1))).norm() <
          1e-12);
    CHECK((joined.at_start({0.1, 0.05}) - joined.outline[2]).norm() < 1e-12);
    CHECK_THAT(refused({"body_2.joined_to=\"hull\""}, second), Contains("'hull' is no body before this one"));
    CHECK_THAT(refused({"body_2.mass=3.0"}, second), Contains("key 'body_2.mass'"));
    CHECK_THAT(refused({"contact.restitution=0.5"}, second), Contains("have no contacts"));
}
