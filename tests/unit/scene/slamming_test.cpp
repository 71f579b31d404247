// SPDX-License-Identifier: BSD-3-Clause
// What slamming asks of the sound speed and of the tank: contact lines, echoes, flat bottoms.
#include "validation/scene/slamming.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/scene/asked_axes.hpp"
#include "validation/scene/plausibility.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

/// A wedge of 30 degrees deadrise and 0.2 m beam, 5 mm above 0.8 m of water in a tank 2 m wide, falling at 2
/// m/s throughout; its force is asked for until 10 ms after it meets the water, at 2.5 ms.
const std::string wedge_scene = R"toml(schema = 1
name = "drop"
title = "A wedge"
purpose = "to test"
source = "none"
gravity = [0.0, -9.81]
default_variant = "alone"

[tank]
size = [2.0, 1.1]

[water]
density = 1000.0
sound_speed = 100.0
exponent = 7.0
boxes = [[0.0, 0.0, 2.0, 0.8]]

[initial]
pressure = "hydrostatic"
surface = 0.8

[body]
outline = [[0.0, 0.0], [0.1, 0.0577350269], [-0.1, 0.0577350269]]
position = [1.0, 0.805]
free = []
velocity_y = -2.0

[run]
end_time = 0.0125
sample_interval = 1.0e-4

[variants.alone]
description = "water alone"
model.air = false
model.background_pressure = 0.0

[[quantities]]
name = "largest_force"
metric = "maximum"
series = "body_force_y"
window = [0.0, 0.0125]
unit = "N/m"
)toml";

Scene wedge(const std::vector<std::string>& overrides = {}) {
    return parse_scene(wedge_scene, "drop.toml", std::nullopt, overrides);
}

/// Outline of a wedge of 0.2 m beam.
std::string of_deadrise(double degrees) {
    const double height = 0.1 * std::tan(degrees * std::numbers::pi / 180);
    return "body.outline=[[0.0, 0.0], [0.1, " + std::to_string(height) + "], [-0.1, " +
           std::to_string(height) + "]]";
}

}  // namespace

TEST_CASE("the contact line moves at pi V / (2 tan b) along the flattest side") {
    for (const double degrees : {5.0, 8.0, 10.0, 20.0, 25.0, 30.0, 37.0, 45.0, 60.0, 64.0}) {
        CAPTURE(degrees);
        const auto line = fastest_contact_line(wedge({of_deadrise(degrees)}));
        REQUIRE(line);
        CHECK(line->entry_speed == Approx(2));
        CHECK(line->deadrise == Approx(degrees * std::numbers::pi / 180).epsilon(1e-4));
        CHECK(line->speed ==
              Approx(2 * std::numbers::pi / (2 * std::tan(degrees * std::numbers::pi / 180))).epsilon(1e-4));
    }
    // a flare counts, a chamfer of less than a twentieth of the beam and the deck do not
    const auto flared = fastest_contact_line(
        wedge({"body.outline=[[0.0, 0.0], [0.05, 0.05], [0.1, 0.06], [-0.1, 0.06], [-0.05, 0.05]]"}));
    CHECK(flared->deadrise == Approx(std::atan2(0.01, 0.05)));
    const auto chamfered = fastest_contact_line(
        wedge({"body.outline=[[0.0, 0.0], [0.095, 0.095], [0.1, 0.096], [-0.1, 0.096], [-0.095, 0.095]]"}));
    CHECK(chamfered->deadrise == Approx(std::numbers::pi / 4));
    CHECK_FALSE(
        fastest_contact_line(wedge({"body.outline=[[-0.1, 0.0], [0.1, 0.0], [0.1, 0.05], [-0.1, 0.05]]"})));
    CHECK_FALSE(fastest_contact_line(wedge({"body.velocity_y=2.0"})));
    CHECK_FALSE(fastest_contact_line(wedge({"body.position=[1.0, 0.75]"})));  // starts in the water
}

TEST_CASE("a fall adds to the speed at the water and takes the time that it takes") {
    const Scene falling =
        wedge({"body.free=[\"y\"]", "body.mass=10.0", "body.velocity_y=-1.0", "body.position=[1.0, 0.9]"});
    CHECK(fastest_contact_line(falling)->entry_speed == Approx(std::sqrt(1 + 2 * 9.81 * 0.1)));
    const Scene carried = wedge({"body.free=[\"y\"]", "body.mass=10.0", "body.velocity_y=-1.0",
                                 "body.position=[1.0, 0.9]", "body.applied_force=[0.0, 98.1]"});
    CHECK(fastest_contact_line(carried)->entry_speed == Approx(1));
}

TEST_CASE("a sound speed below twelve times the contact line's is doubted, with what it costs") {
    CHECK(doubtful(wedge()).empty());  // 5.44 m/s, 65 m/s asked for
    const auto doubts = doubtful(wedge({"water.sound_speed=50"}));
    REQUIRE(doubts.size() == 1);
    CHECK_THAT(doubts[0], Contains("side of 30 degrees of body") && Contains("5.44 m/s") && Contains("3 %") &&
                              Contains("at least 65.3 m/s"));
    CHECK(doubtful(wedge({"water.sound_speed=50", "accepted_doubts.sound_speed=the source has it"})).empty());
    const auto notes =
        remarks(wedge({"water.sound_speed=50", "accepted_doubts.sound_speed=the source has it"}));
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], Contains("accepted: the source has it"));
}

TEST_CASE("a contact, or a window counted from one, that lies after the end of the run is doubted") {
    const std::string from_contact = wedge_scene + "x_origin = \"contact\"\n\n[time_origins]\ncontact = ";
    const auto doubts = [&](const std::string& contact, const std::string& window,
                            const std::vector<std::string>& overrides) {
        std::string text = from_contact + contact + "\n";
        const std::string old = "window = [0.0, 0.0125]";
        text.replace(text.find(old), old.size(), window);
        return unreached_times(parse_scene(text, "drop.toml", std::nullopt, overrides));
    };
    struct Row {
        std::string contact, window;
        std::vector<std::string> overrides;
        std::string expected;  ///< empty: no doubt
    };
    const std::string found = "\"geometric_contact\"";  // at 2.5 ms of 12.5 ms
    const std::vector<Row> rows = {
        {found, "", {}, ""},
        {found, "window = [0.0, 0.01]", {}, ""},
        {found, "window = [0.0, 0.02]", {}, "has the window about 0.0025 to 0.0225 s, beyond the end"},
        {found, "window = [0.011, 0.02]", {}, "has the window about 0.0135 to 0.0225 s, after the end"},
        {found,
         "",
         {"run.end_time=0.002"},
         "counts from contact, at about 0.0025 s, after the end of the run"},
        {found, "", {"body.velocity_y=-0.3"}, "counts from contact, at about 0.0166667 s, after the end"},
        {found, "", {"body.position=[1.0, 0.9]"}, "counts from contact, at about 0.05 s, after the end"},
        {found, "", {"body.velocity_y=0.0"}, ""},  // never: no time to name
        {"0.0025", "", {}, ""},
        {"0.0025", "window = [0.011, 0.02]", {}, "has the window 0.0135 to 0.0225 s, after the end"},
        {"0.03", "", {}, "counts from contact, at 0.03 s, after the end of the run at 0.0125 s"},
        {"\"first_contact\"", "", {"run.end_time=0.002"}, "counts from contact, at about 0.0025 s"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.contact, row.window, row.overrides);
        const auto all = doubts(row.contact, row.window, row.overrides);
        REQUIRE(all.size() == (row.expected.empty() ? 0 : 1));
        if (!all.empty()) CHECK_THAT(all[0], Contains(row.expected));
    }
}

TEST_CASE("a force that is asked for after the echo of floor or sides is doubted") {
    struct Row {
        std::vector<std::string> overrides;
        const char* text;
    };
    const std::vector<Row> table = {
        {{"water.sound_speed=200"},
         "from the floor 0.008 s after it meets the water (1.6 m at 200 m/s), at 0.0105 s"},
        {{"water.sound_speed=400"}, "from the floor 0.004 s after"},
        {{"body.position=[0.4, 0.805]"},
         "from the sides of the tank 0.007 s after it meets the water (0.7 m"},
        {{"body.position=[1.7, 0.805]"},
         "from the sides of the tank 0.005 s after it meets the water (0.5 m"},
        {{"water.sound_speed=200"}, "up to 0.0125 s, enter quantity 'largest_force'"},
        {{"water.sound_speed=200"}, "a larger tank (2 m of way)"},
    };
    for (const auto& [overrides, text] : table) {
        const auto doubts = doubtful(wedge(overrides));
        CAPTURE(overrides, doubts);
        REQUIRE(doubts.size() == 1);
        CHECK_THAT(doubts[0], Contains(text));
    }
    const std::vector<std::vector<std::string>> in_order = {
        {},
        {"water.sound_speed=125"},                          // back at 12.8 + 2.5 ms
        {"water.sound_speed=160", "run.end_time=0.01249"},  // back at 10 + 2.5 ms
        {"water.sound_speed=1100"},                         // of nearly real water: the tank's own
        {"water.sound_speed=200", "accepted_doubts.echo=as in the experiment"},
        {"water.sound_speed=200", "body.velocity_y=2.0"},  // leaves
    };
    for (const auto& overrides : in_order) {
        CAPTURE(overrides, doubtful(wedge(overrides)));
        CHECK(doubtful(wedge(overrides)).empty());
    }
    // a velocity feels the time integral of an echo, and a window that ends before it nothing
    std::string text = wedge_scene;
    text.replace(text.find("window = [0.0, 0.0125]"), 22, "window = [0.0, 0.0100]");
    CHECK(doubtful(parse_scene(text, "drop.toml", std::nullopt, {"water.sound_speed=200"})).empty());
}

TEST_CASE("a mean over an interval asks for the time until its end") {
    Scene scene;
    scene.end_time = 10;
    QuantitySpec mean;
    mean.metric = &metric_named("maximum");
    mean.instant = 1;
    mean.interval = 2;
    scene.analysis.quantities = {mean};
    REQUIRE(asked_times(scene).size() == 1);
    CHECK(asked_times(scene)[0].last == 3);
}

TEST_CASE("a flat bottom is told, and what its first pressure depends on") {
    const std::string flat = "body.outline=[[-0.1, 0.0], [0.1, 0.0], [0.1, 0.05], [-0.1, 0.05]]";
    const auto notes = remarks(wedge({flat}));
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], Contains("rho c V = 200 kPa"));
    CHECK(remarks(wedge()).empty());
}
