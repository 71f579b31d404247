// SPDX-License-Identifier: BSD-3-Clause
// Slips that make a sound scene file of another meaning.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/scene/trapped_air.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

/// The small scene with a plate of 0.2 x 0.05 m, 5 kg/m, at rest.
Scene with_plate(const std::vector<std::string>& overrides) {
    const std::string plate =
        "[body]\noutline = [[0.1, 0.3], [0.3, 0.3], [0.3, 0.35], [0.1, 0.35]]\nposition = [0.0, 0.0]\n"
        "free = [\"y\"]\nmass = 5.0\n\n[initial]\n";
    return parse_scene(samples::with("[initial]\n", plate), "small.toml", std::nullopt, overrides);
}

std::vector<std::string> doubts_of(const std::vector<std::string>& overrides) {
    return doubtful(with_plate(overrides));
}

/// One doubt that holds the text.
void expect_doubt(const std::vector<std::string>& overrides, const std::string& text) {
    const std::vector<std::string> doubts = doubts_of(overrides);
    CAPTURE(overrides, doubts);
    CHECK(std::count_if(doubts.begin(), doubts.end(), [&](const std::string& doubt) {
              return doubt.find(text) != std::string::npos;
          }) == 1);
}

}  // namespace

TEST_CASE("the scenes that come with the program mean what they say") {
    for (const std::string& name : scene_names()) {
        const Scene scene = read_scene(find_scene(name));
        CAPTURE(name);
        for (const VariantInfo& variant : scene.variants) {
            CAPTURE(variant.name);
            const std::vector<std::string> doubts = doubtful(read_scene(find_scene(name), variant.name));
            CAPTURE(doubts);
            CHECK(doubts.empty());
        }
    }
}

TEST_CASE("a plate in the air of a sensible mass is not doubted") {
    CHECK(doubts_of({}).empty());
}

TEST_CASE("water that the fall compresses by more than a percent is doubted") {
    // falls 0.1 m to the surface: 1.4 m/s more than the velocity that it has
    const auto doubts = doubts_of({"body.velocity_y=-1.5"});
    REQUIRE(doubts.size() == 1);
    CHECK_THAT(doubts[0], Contains("water.sound_speed is 14 m/s") && Contains("2.05 m/s"));
}

TEST_CASE("a body that starts in the water is told") {
    const std::string deep = "body.outline=[[0.1, 0.1], [0.3, 0.1], [0.3, 0.35], [0.1, 0.35]]";
    REQUIRE(remarks(with_plate({})).size() == 1);
    CHECK_THAT(remarks(with_plate({}))[0], Contains("flat bottom"));
    REQUIRE(remarks(with_plate({deep})).size() == 1);
    CHECK_THAT(remarks(with_plate({deep}))[0], Contains("starts in the water"));
    CHECK(doubts_of({deep}).empty());
}

TEST_CASE("air is squeezed until the fall has no energy left, and below a third that is doubted") {
    // B w(x) = weight (1 - x) for gamma = 2: w = 1/x - 1 - (1 - x) = (1 - x)^2 / x, so that x = B / (B +
    // weight)
    for (const double ratio : {0.1, 0.5, 1.0, 2.0, 10.0})
        CHECK(squeezed_share(ratio * 1000, 1000, 2) == Approx(1 / (1 + ratio)));
    CHECK(squeezed_share(0, 1000, 2, 1000) == Approx((3 - std::sqrt(5.0)) / 2));  // (1 - x)^2 = x
    CHECK(squeezed_share(500, 1000, 1) == Approx(squeezed_share(500, 1000, 1 + 1e-6)));
    // 0.2 m of water over 0.1 m of air in the whole tank: 1962 Pa
    const auto doubts = [](const char* air, const char* floor) {
        return doubtful(parse_scene(samples::small_scene, "small.toml", std::nullopt,
                                    {std::string("air.sound_speed=") + air, "model.background_pressure=0",
                                     std::string("water.boxes=[[0.0, ") + floor + ", 1.0, 0.3]]",
                                     std::string("air.boxes=[[0.0, 0.3, 1.0, 0.48]") +
                                         (floor == std::string("0.0") ? "]" : ", [0.0, 0.0, 1.0, 0.1]]"),
                                     "initial.surface=0.3", "water.sound_speed=40"}));
    };
    const auto soft = doubts("20", "0.1");
    CAPTURE(soft);
    REQUIRE(std::count_if(soft.begin(), soft.end(), [](const std::string& d) {
                return d.find("squeezes it to about") != std::string::npos;
            }) == 1);
    for (const auto& none : {doubts("200", "0.1"), doubts("20", "0.0")})
        CHECK(std::none_of(none.begin(), none.end(),
                           [](const std::string& d) { return d.find("squeezes") != std::string::npos; }));
}

TEST_CASE("a mass in tonnes or grams is doubted") {
    for (const char* mass : {"body.mass=0.005", "body.mass=5000.0"}) {
        const auto doubts = doubts_of({mass});
        REQUIRE(doubts.size() == 1);
        CHECK_THAT(doubts[0], Contains("times the mass of the water it would displace"));
    }
}

TEST_CASE("a background pressure of the order of the air's stiffness is doubted") {
    const double stiffness =
        parse_scene(samples::small_scene, "small.toml", std::nullopt, {}).model.air.eos.coefficient();
    const auto doubts = [](double pressure) {
        return doubts_of({"model.background_pressure=" + std::to_string(pressure)});
    };
    CHECK(doubts(0.49 * stiffness).empty());
    REQUIRE(doubts(0.51 * stiffness).size() == 1);
    CHECK_THAT(doubts(0.51 * stiffness)[0], Contains("the air's own stiffness"));
}

TEST_CASE("a value that nothing uses is doubted") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> table = {
        {{"water.viscosity=200"}, "water.viscosity is not used: model.viscosity is none"},
        {{"air.viscosity=1e-5"}, "air.viscosity is not used"},
        {{"model.wall_slip=no"}, "model.wall_slip is not used"},
        {{"model.wall_slip=no", "model.viscosity=symmetric"}, "model.wall_slip is not used"},
        {{"model.viscosity=symmetric"}, "model.viscosity is not used: no fluid has a viscosity"},
        {{"model.air=false", "model.background_pressure=0"}, "the table [air] is not used"},
        {{"air.law=physical"}, "air.sound_speed is not used: air.law gives the sound speed"},
        {{"model.switch_velocity=modulus"}, "model.switch_velocity is not used"},
        {{"model.mean_guard=same-sign-zero"}, "model.mean_guard is not used: no mean is harmonic"},
        {{"model.sponge_ramp=larsen-dancy"}, "model.sponge_ramp is not used"},
        {{"model.dissipation=riemann", "model.dissipation_slope=3"}, "model.dissipation_slope is not used"},
        {{"initial.released_face=0.4"}, "initial.released_face is not used"},
        {{"body.free=[]", "body.mass=5"}, "body.mass is not used: the body keeps its velocity"},
        {{"body.inertia=0.1"}, "body.inertia is not used: the body is not free to turn"},
        {{"body.applied_torque=3"}, "body.applied_torque is not used"},
        {{"body.applied_force=[5.0, 0.0]"}, "body.applied_force is not used"},
        {{"contact.stiffness=0", "contact.restitution=0.5"}, "contact.restitution is not used"},
    };
    for (const auto& [overrides, text] : table) expect_doubt(overrides, text);
    for (const std::vector<std::string>& used :
         {std::vector<std::string>{"water.viscosity=0.001", "model.viscosity=symmetric"},
          {"body.applied_force=[0.0, 3.0]"},
          {"contact.restitution=0.4"}})
        CHECK(doubts_of(used).empty());
}

TEST_CASE("a value that another variant uses is in order, unless it is a large viscosity") {
    std::string text = samples::with("[variants.single-phase]\n",
                                     "[variants.single-phase]\nmodel.viscosity = \"symmetric\"\n");
    const auto doubts = [&](const char* viscosity) {
        return doubtful(parse_scene(text, "small.toml", "two-phase", {viscosity}));
    };
    CHECK(doubts("water.viscosity=0.001").empty());
    REQUIRE(doubts("water.viscosity=1").size() == 1);  // c H / nu = 14 * 0.2 * 1000
    CHECK_THAT(doubts("water.viscosity=1")[0], Contains("water.viscosity is not used"));
}

TEST_CASE("tension is doubted where no air bears it with a background pressure") {
    const auto doubts = [](const char* variant, const char* value) {
        return doubtful(parse_scene(samples::small_scene, "small.toml", variant, {value}));
    };
    CHECK(doubts("two-phase", "model.negative_pressure=true").empty());
    CHECK(doubts("single-phase", "model.negative_pressure=false").empty());
    const std::vector<std::string> found = doubts("single-phase", "model.negative_pressure=true");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0], Contains("water under tension clumps into lines"));
}

TEST_CASE("absurd values are doubted") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> table = {
        {{"gravity=[0.0, 9.81]"}, "gravity points up"},
        {{"gravity=[-9.81, 0.0]"}, "gravity points sideways"},
        {{"model.courant_number=0.9"}, "model.courant_number is 0.9: beyond 0.8"},
        {{"water.density=1.025", "air.density=0.001"}, "is it in t/m3?"},
        {{"water.sound_speed=2500"}, "more than that of real water"},
        {{"body.position=[0.3, 0.0]", "body.outline=[[0.0, 0.3], [0.1, 0.35], [0.1, 0.4]]"},
         "for a half section write mirrored = true"},
        {{"body.position=[0.3, 0.0]", "body.outline=[[0.1, 0.4], [0.1, 0.35], [0.0, 0.3]]"},
         "for a half section write mirrored = true"},
        {{"gravity=[1.0, -9.81]"}, "gravity is tilted by 5.82 degrees"},
        {{"air.boxes=[[0.4, 0.0, 1.0, 0.2], [0.0, 0.25, 1.0, 0.48]]"}, "leave 10.4 % of the tank empty"},
        {{"air.boxes=[[0.6, 0.3, 1.0, 0.48]]"}, "of the tank empty"},
        {{"gravity=[0.0, -981.0]"}, "gravity is 981 m/s2"},
        {{"initial.surface=0.3"}, "initial.surface is 0.3 m, but the top of the water is at 0.2 m"},
        {{"initial.surface=0.19"}, "initial.surface is 0.19 m"},
        {{"run.sample_interval=0.01"}, "fewer than 50"},
        {{"run.sample_interval=1"}, "has 1 samples"},
        {{"run.frames=[0.05, 0.3]"}, "run.frames asks for 0.3 s"},
        {{"air.density=1200"}, "more than water.density"},
        {{"model.air=false", "model.background_pressure=500"}, "500 Pa without air"},
        {{"model.sponge_thickness=0.2"}, "slows down more than half of a side"},
        {{"run.force_filter=0.05"}, "filtered peaks would be means"},
        {{"body.free=[\"rotation\"]", "body.inertia=1000"}, "body.inertia is 1000 kg m"},
        {{"body.free=[\"rotation\"]", "body.inertia=1e-5"}, "body.inertia is 1e-05 kg m"},
        {{"body.free=[]", "body.velocity_x=-1"}, "leads it out of the tank"},
        {{"body.free=[]", "body.angular_velocity=30", "body.position=[0.0, 0.1]"},
         "leads it out of the tank"},
        {{"body.free=[\"x\"]", "body.velocity_y=2"}, "leads it out of the tank"},
        {{"water.boxes=[[0.0, 0.36, 1.0, 0.4]]", "air.boxes=[[0.0, 0.4, 1.0, 0.48]]"},
         "of the water that falls"},
        {{"body.velocity_y=-1.9"}, "m/s of body"},
        {{"body.angular_velocity=20"}, "m/s of body"},
        {{"initial.pressure=greco", "initial.released_face=0.1", "water.boxes=[[0.0, 0.0, 0.1, 0.2]]",
          "air.boxes=[[0.6, 0.3, 1.0, 0.48]]"},
         "that of a long column"},
    };
    for (const auto& [overrides, text] : table) expect_doubt(overrides, text);
}

TEST_CASE("what only looks like one of these slips is not doubted") {
    for (const std::vector<std::string>& good :
         {std::vector<std::string>{"water.boxes=[[0.0, 0.0, 0.4, 0.1], [0.0, 0.1, 0.4, 0.2]]"},
          {"water.boxes=[[0.0, 0.0, 0.2, 0.2], [0.2, 0.0, 0.4, 0.1]]",
           "air.boxes=[[0.4, 0.0, 1.0, 0.2], [0.2, 0.1, 0.4, 0.2], [0.0, 0.2, 1.0, 0.48]]"},
          {"body.free=[\"x\"]", "body.velocity_y=0.5"},
          {"body.free=[\"rotation\"]", "body.inertia=0.03"}})
        CHECK(doubts_of(good).empty());
}

TEST_CASE("a window or an instant that the run does not reach is doubted") {
    // scales.time is 0.1428 s, the run ends at 0.2 s
    const std::vector<std::array<std::string, 3>> table = {
        {"window = [0.2, 0.8]", "window = [2.0, 3.0]",
         "'front_mean' has the window 0.2856 to 0.4284 s, after"},
        {"window = [0.2, 0.8]", "window = [0.2, 1.6]", "has the window 0.02856 to 0.22848 s, beyond the end"},
        {"window = [0.2, 0.8]", "window = [0.2, 0.8]\nx_origin = \"release\"",
         "0.17856 to 0.26424 s, beyond"},
        {"window = [0.0, 1.0]", "window = [1.5, 2.0]",
         "comparison 'front' has the window 0.2142 to 0.2856 s"},
        {"metric = \"mean\"", "metric = \"value_at\"\nthreshold = 2.0",
         "is taken at 0.2856 s, after the end"},
        {"window = [0.2, 0.8]", "window = [-0.5, 0.8]",
         "has the window -0.0714 to 0.11424 s, before the start"},
        {"metric = \"mean\"", "metric = \"maximum\"\nthreshold = 9.0", ""},
        {"window = [0.2, 0.8]", "window = [0.2, 1.4]", ""},
        {"window = [0.0, 1.0]", "window = [0.0, 3.0]", ""},
        {"series = \"front\"\nx_scale = \"time\"", "series = \"film\"\ninstant = 0.3",
         "is taken at the instant 0.3 s"},
        {"series = \"front\"\nx_scale = \"time\"", "series = \"film\"\ninstant = 0.1", ""},
        {"series = \"front\"\nx_scale = \"time\"", "series = \"film\"\ninstant = [0.1, 0.3]",
         "is taken up to 0.3 s, after the end"},
        {"series = \"front\"\nx_scale = \"time\"", "series = \"film\"\ninstant = [0.1, 0.2]", ""}};
    for (const auto& [piece, instead, doubt] : table) {
        std::string text = samples::with(piece, instead);
        if (instead.find("film") != std::string::npos)
            text = samples::replaced(text, "[[quantities]]",
                                     "[[probes]]\nname = \"film\"\ntype = \"free_surface\"\nlow = "
                                     "0.0\nhigh = 1.0\npoints = 11\n\n[[quantities]]");
        if (instead.find("release") != std::string::npos)
            text = samples::replaced(text, "[scales]", "[time_origins]\nrelease = 0.15\n\n[scales]");
        const std::vector<std::string> doubts = doubtful(parse_scene(text, "small.toml"));
        CAPTURE(instead, doubts);
        REQUIRE(doubts.size() == (doubt.empty() ? 0 : 1));
        if (!doubt.empty()) CHECK_THAT(doubts[0], Contains(doubt));
    }
}

TEST_CASE("a plain scale of two dimensions is doubted") {
    const auto doubts = [](const std::string& x, const std::string& y) {
        std::string text = samples::with("[scales]\n", "[scales]\nmilli = 0.001\nkilo = \"1 kPa\"\n");
        text = samples::replaced(text, "x_scale = \"time\"\ny_scale = \"length\"",
                                 "x_scale = \"" + x + "\"\ny_scale = \"" + y + "\"");
        return doubtful(
            parse_scene(samples::replaced(text, "window = [0.2, 0.8]", "window = [0.2, 0.4]"), "small.toml"));
    };
    CHECK(doubts("time", "length").empty());
    REQUIRE(doubts("time", "kilo").size() == 1);  // metres over pascals
    CHECK_THAT(doubts("time", "kilo")[0],
               Contains("values in m over scales.kilo in Pa") && Contains("is this scale meant?"));
    for (const auto& [x, y] : {std::pair("length", "length"), std::pair("time", "time"),
                               std::pair("milli", "milli"), std::pair("length", "time")}) {
        CAPTURE(x, y);
        const auto found = doubts(x, y);
        REQUIRE_FALSE(found.empty());
        CHECK_THAT(found[0], Contains("is a plain number and divides values in") && Contains(" in s") &&
                                 Contains(" in m"));
    }
}

TEST_CASE("a body in the water less than two spacings from something is doubted", "[scene]") {
    const auto doubts = [](double low, double left, double particle_spacing) {
        const std::string outline = fmt::format(
            "body.outline=[[{0}, {1}], [0.3, {1}], [0.3, {2}], [{0}, {2}]]", left, low, low + 0.1);
        return doubts_at_spacing(with_plate({outline}), particle_spacing);
    };
    CHECK(doubts(0.04, 0.04, 0.02).empty());
    CHECK(doubts(0.001, 0.1, 0.02).empty());  // no water enters
    CHECK(doubts(0.3, 0.01, 0.02).empty());   // in the air
    for (const double gap : {0.003, 0.008, 0.01, 0.015, 0.02, 0.03, 0.035}) {
        CAPTURE(gap);
        REQUIRE(doubts(gap, 0.1, 0.02).size() == 1);
        CHECK_THAT(doubts(gap, 0.1, 0.02)[0], Contains("from the floor"));
        REQUIRE(doubts(0.06, gap, 0.02).size() == 1);
        CHECK_THAT(doubts(0.06, gap, 0.02)[0], Contains("from the left wall"));
    }
}

TEST_CASE("a run that goes on to a later time is judged by that time", "[scene]") {
    const Scene scene =
        parse_scene(samples::with("window = [0.2, 0.8]", "window = [2.0, 2.5]"), "small.toml");
    CHECK(doubts_of_run(scene, 0.02).size() == 1);
    CHECK(doubts_of_run(scene, 0.02, 0.05).size() == 1);
    CHECK(doubts_of_run(scene, 0.02, 0.4).empty());
}
