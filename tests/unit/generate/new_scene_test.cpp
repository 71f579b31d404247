// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck new`: scenes of sections of all kinds pass `check --strict` and fit their spacings, the numbers
// follow the stated rules, and what cannot be a section is refused with one line.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/program/command_line.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/scene/bottom.hpp"
#include "validation/scene/expected_motion.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/scene/slamming.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;
using Words = std::vector<std::string>;

namespace {

/// A wedge of this deadrise [degrees] and 0.5 m beam.
std::string wedge(double deadrise) {
    const double rise = 0.25 * std::tan(deadrise * std::numbers::pi / 180);
    return fmt::format("0, 0\n0.25, {0}\n0.25, {1}\n-0.25, {1}\n-0.25, {0}\n", rise, rise + 0.1);
}

const std::string half_section =
    "# half section\nhalf breadth [m], height [m]\n0, 0\n0.06, 0.015\n0.12, 0.036\n0.17, 0.062\n"
    "0.205, 0.095\n0.225, 0.135\n0.24, 0.19\n0.27, 0.26\n";

/// Half a circle below a straight deck, in short sides.
std::string round_section() {
    std::string text;
    for (int k = 0; k <= 60; ++k) {
        const double angle = std::numbers::pi * (1 + k / 60.0);
        text += fmt::format("{}, {}\n", 0.4 * std::cos(angle), 0.4 + 0.4 * std::sin(angle));
    }
    return text + "0.4, 0.6\n-0.4, 0.6\n";
}

struct Kind {
    std::string name, corners;
    Words flags;
    double speed, sound_speed;  ///< [m/s]
};

const std::string catamaran =
    "-0.5,0.1\n-0.4,0\n-0.3,0.1\n-0.3,0.25\n0.3,0.25\n0.3,0.1\n0.4,0\n0.5,0.1\n0.5,0.45\n-0.5,0.45\n";
const std::string with_keel =
    "-0.05,0\n0.05,0\n0.05,0.05\n0.4,0.15\n0.4,0.4\n-0.4,0.4\n-0.4,0.15\n-0.05,0.05\n";

const std::vector<Kind> kinds = {
    {"wedge of 8 degrees", wedge(8), {"--mass", "60"}, 4.2, 570},
    {"wedge of 20 degrees", wedge(20), {"--mass", "60"}, 3, 160},
    {"wedge of 30 degrees with air", wedge(30), {"--mass", "241", "--air"}, 6.15, 210},
    {"wedge of 45 degrees", wedge(45), {"--mass", "60"}, 3, 57},
    {"wedge of 60 degrees", wedge(60), {"--constant-speed"}, 3, 33},
    {"flat plate", "-0.5, 0\n0.5, 0\n0.5, 0.1\n-0.5, 0.1\n", {"--mass", "200"}, 2, 200},
    {"flat plate with air", "-0.5, 0\n0.5, 0\n0.5, 0.1\n-0.5, 0.1\n", {"--mass", "200", "--air"}, 2, 200},
    {"two hulls", catamaran, {"--mass", "150", "--air"}, 1, 100},
    {"half section", half_section, {"--mass", "60"}, 3, 230},
    {"half section that ends on the axis",
     "0,0\n0.25,0.1\n0.25,0.3\n0,0.3\n",
     {"--half", "--mass", "60"},
     3,
     150},
    {"keel five spacings wide", with_keel, {"--mass", "200"}, 1, 100},
    {"millimetres",
     "x [mm], y [mm]\n0, 0\n250, 91\n250, 200\n-250, 200\n-250, 91\n",
     {"--mass", "60"},
     3,
     160},
    {"clockwise", "-0.25,0.091\n-0.25,0.2\n0.25,0.2\n0.25,0.091\n0,0\n", {"--mass", "60"}, 3, 160},
    {"far from the origin", "7,5\n7.25,5.091\n7.25,5.2\n6.75,5.2\n6.75,5.091\n", {"--mass", "60"}, 3, 160},
    {"not symmetric", "0,0\n0.3,0.08\n0.3,0.3\n-0.1,0.3\n-0.1,0.08\n", {"--mass", "60"}, 3, 220},
    {"round", round_section(), {"--mass", "200"}, 2, 360},
    {"ship", "0,0\n4,0.2\n9,1\n11,5\n11,9\n", {"--mass", "100000"}, 4, 480},
    {"as fast as in real water", wedge(6), {"--mass", "60"}, 10, 1450},
    {"slow", wedge(20), {"--mass", "60"}, 0.3, 16},
    {"shallow", wedge(20), {"--mass", "60", "--depth", "0.83"}, 3, 160},
    {"of deep water", wedge(20), {"--mass", "60", "--depth", "50"}, 3, 160},
    {"of a stated record", wedge(20), {"--mass", "60", "--record", "0.012"}, 3, 160},
};

Words command(const ScratchFolder& folder, const Words& flags, const std::string& file = "mine.csv") {
    Words words = {"new", (folder / file).string(), "--out", (folder / "mine.toml").string()};
    words.insert(words.end(), flags.begin(), flags.end());
    return words;
}

/// What the command says of corners and flags: "accepted" or its one line.
std::string refusal(const std::string& corners, const Words& flags) {
    const ScratchFolder folder;
    put_bytes(folder / "mine.csv", corners);
    try {
        run_command_line(command(folder, flags));
    } catch (const InputError& error) {
        CHECK_FALSE(std::filesystem::exists(folder / "mine.toml"));
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("A scene that new writes passes check --strict and fits its spacings", "[generate]") {
    const Kind kind = GENERATE(from_range(kinds));
    CAPTURE(kind.name);
    const ScratchFolder folder;
    put_bytes(folder / "mine.csv", kind.corners);
    Words flags = kind.flags;
    flags.insert(flags.end(), {"--speed", fmt::format("{}", kind.speed)});
    REQUIRE(run_command_line(command(folder, flags)) == exit_done);
    const std::string file = (folder / "mine.toml").string();
    CHECK(run_command_line({"check", file, "--strict"}) == exit_done);

    const Scene scene = read_scene(file);
    CHECK(scene.model.water.eos.sound_speed == Approx(kind.sound_speed).margin(0.5));
    const std::vector<double> spacings = scene.tiers.at("quick").at(scene.variant);
    CHECK(spacings.size() == 3);
    CHECK(spacings.front() / spacings.back() == Approx(2));
    CHECK(scene.air == (kind.name.find("air") != std::string::npos || kind.name == "two hulls"));
    const auto entry = water_entry(scene, scene.bodies.front());
    REQUIRE(entry);
    CHECK(entry->speed == Approx(kind.speed));
    const double record = scene.end_time - entry->time;
    CHECK(entry->level >= 0.999 * 0.5 * scene.model.water.eos.sound_speed * record);  // no echo of the floor
}

TEST_CASE("The depth and the record that are asked for are kept", "[generate]") {
    const ScratchFolder folder;
    put_bytes(folder / "mine.csv", wedge(20));
    REQUIRE(run_command_line(command(folder, {"--mass", "60", "--speed", "3", "--depth", "0.83"})) == 0);
    CHECK(read_scene(folder / "mine.toml").initial.surface == Approx(0.83));
    REQUIRE(run_command_line(
                command(folder, {"--mass", "60", "--speed", "3", "--record", "0.012", "--force"})) == 0);
    const Scene scene = read_scene(folder / "mine.toml");
    const double contact = water_entry(scene, scene.bodies.front())->time;
    CHECK(scene.end_time - contact == Approx(0.012).margin(0.0001));
}

TEST_CASE("What is no section, and values that fit no scene, are refused with the flag or line",
          "[generate]") {
    struct Wrong {
        std::string corners;
        Words flags;
        std::string expected;
    };
    const Words both = {"--speed", "3", "--mass", "60"};
    const std::vector<Wrong> all = {
        {"0, 0\n1, 1\n", both, "mine.csv: holds 2 corners"},
        {"0, 0\n1, one\n1, 1\n", both, "mine.csv:2: expected two numbers"},
        {"0, 0\n1, 1\n1, 0\n-0.5, 1\n", both, "mine.csv: the outline"},
        {"x [kg], y [m]\n0, 0\n1, 1\n-1, 1\n", both, "the unit 'kg' is none of length"},
        {"0, 0\n250, 91\n-250, 91\n", both, "is 500 m wide: expected its unit in the first line"},
        {"# kind: experiment\nt [s],vy [m/s]\n0,1\n1,2\n2,3\n", both, "is a curve with a header"},
        {"0, 0\n1, 0\n1, 1\n0, 1\n", both, "expected --half (mirror it) or --whole"},
        {"0.1, 0\n1, 0.5\n1, 1\n", {"--speed", "3", "--mass", "60", "--half"}, "off the axis x = 0"},
        {wedge(20), {"--mass", "60"}, "--speed is missing: expected the speed downwards"},
        {wedge(20), {"--speed", "3"}, "--mass is missing: expected the mass per metre of span"},
        {wedge(20), {"--speed", "-3", "--mass", "60"}, "--speed is -3, expected a positive number"},
        {wedge(20), {"--speed", "nan", "--mass", "60"}, "--speed is nan, expected a positive number"},
        {wedge(20), {"--speed", "3", "--mass", "0"}, "--mass is 0, expected a positive number"},
        {wedge(20), {"--speed", "3", "--mass", "60000"}, "times the mass of the water it would displace"},
        {wedge(20),
         {"--speed", "3", "--mass", "60", "--depth", "0.02"},
         "--depth is 0.02 m: at 160 m/s sound"},
        {wedge(20), {"--speed", "3", "--mass", "60", "--record", "0"}, "--record is 0, expected a positive"},
        {wedge(20), {"--speed", "3", "--mass", "60", "--constant-speed"}, "beside --constant-speed"},
        {wedge(20), {"--speed", "3", "--mass", "60", "--air", "--no-air"}, "expected one of the two"},
        {"-0.5,0\n0.5,0\n0.5,0.001\n-0.5,0.001\n", both, "a part of the section is thinner than"},
    };
    for (const Wrong& wrong : all) {
        CAPTURE(wrong.corners, wrong.expected);
        CHECK_THAT(refusal(wrong.corners, wrong.flags), Contains(wrong.expected));
    }
}

TEST_CASE("new never replaces a file without --force, and names what is wrong with --out", "[generate]") {
    const ScratchFolder folder;
    put_bytes(folder / "mine.csv", wedge(20));
    const Words flags = {"--speed", "3", "--mass", "60"};
    put_bytes(folder / "mine.toml", "mine");
    CHECK_THROWS_WITH(run_command_line(command(folder, flags)),
                      Contains("mine.toml exists: expected another"));
    CHECK(bytes_of(folder / "mine.toml") == "mine");
    Words forced = command(folder, flags);
    forced.emplace_back("--force");
    CHECK(run_command_line(forced) == exit_done);
    CHECK(bytes_of(folder / "mine.toml") != "mine");
    const Words words = {"new", (folder / "mine.csv").string(), "--speed", "3", "--mass", "60", "--out"};
    for (const auto& [out, expected] : std::map<std::string, std::string>{
             {"mine.csv", "expected the name of a scene file"}, {"none/mine.toml", "there is no folder"}}) {
        Words other = words;
        other.push_back((folder / out).string());
        CHECK_THROWS_WITH(run_command_line(other), Contains(expected));
    }
    forced[1] = (folder / "none.csv").string();
    CHECK_THROWS_WITH(run_command_line(forced), Contains("no such file of corners"));
    CHECK(run_command_line({"new", (folder / "mine.csv").string()}) == exit_usage);
}

TEST_CASE("A curve of short sides has the slopes of its pieces", "[generate]") {
    Outline curve;
    for (int k = 0; k <= 200; ++k) {  // y = x^2/2 over -1 to 1, slopes from 0 to 45 degrees
        const double x = -1 + k / 100.0;
        curve.emplace_back(x, 0.5 * x * x);
    }
    CHECK(has_flat_bottom(curve));
    const auto least = flattest_deadrise(curve);
    REQUIRE(least);
    CHECK(*least > flattest_deadrise_of_wedge);
    CHECK(*least < 12 * std::numbers::pi / 180);
}
