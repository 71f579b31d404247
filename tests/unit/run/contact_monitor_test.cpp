// SPDX-License-Identifier: BSD-3-Clause
// A body that touches the tank or another body is found, with the place and what it touches.
#include "validation/run/contact_monitor.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"

using namespace wetdeck;

namespace {

/// Two plates of 0.3 x 0.2 m in the air of the small scene.
Scene two_plates(const std::vector<std::string>& overrides) {
    const std::string plates = R"([body]
outline = [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]]
position = [0.6, 0.3]
free = ["y"]
mass = 40.0

[body_2]
outline = [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]]
position = [0.85, 0.3]
free = []

[initial]
)";
    return parse_scene(samples::with("[initial]\n", plates), "small.toml", "single-phase", overrides);
}

}  // namespace

TEST_CASE("each face of the tank and another body stop a body that touches them", "[execute]") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> table = {
        {{"body.free=[]", "body.velocity_y=-10"}, "body touches the floor"},
        {{"body.free=[]", "body.velocity_y=10"}, "body touches the roof"},
        {{"body.free=[]", "body.velocity_x=-30"}, "body touches the left wall"},
        {{"body.free=[]", "body.velocity_x=10"}, "body_2 touches body"},
        {{"body_2.velocity_x=10"}, "body_2 touches the right wall"},
        {{"body_2.velocity_x=-10"}, "body_2 touches body"},
        {{"body_2.velocity_y=-10"}, "body_2 touches the floor"},
        {{"body_2.angular_velocity=60", "body_2.position=[0.87, 0.3]"}, "body_2 touches the right wall"},
        {{"body.free=[\"x\", \"y\"]", "body.velocity_y=-10"}, "body touches the floor"},
        {{"body.free=[\"y\", \"rotation\"]", "body.velocity_y=-10"}, "body touches the floor"},
    };
    for (const auto& [overrides, text] : table) {
        const Scene scene = two_plates(overrides);
        CAPTURE(overrides);
        Simulation simulation = assemble(scene, 0.04, 1);
        const Simulation::StabilityMonitor monitor = contact_monitor(scene);
        REQUIRE(monitor);
        REQUIRE_FALSE(monitor(simulation));
        const std::optional<Instability> found = simulation.run(
            0.05, [](const Simulation&) {}, {}, monitor);
        REQUIRE(found);
        CHECK_THAT(found->quantity, Catch::StartsWith(text));
        CHECK(found->time > 0.003);
        CHECK(found->time < 0.03);
        CHECK((found->position - scene.tank.low).minCoeff() > -0.1);
    }
}

TEST_CASE("bodies that do not move are not watched", "[execute]") {
    CHECK_FALSE(contact_monitor(two_plates({"body.free=[]"})));
    CHECK_FALSE(contact_monitor(read_scene(find_scene("dam_break"))));
}

TEST_CASE("with a law of contact a body goes on until it is a spacing deep", "[execute]") {
    const Scene scene = two_plates({"body.velocity_y=-3", "contact.stiffness=3e3"});
    Simulation simulation = assemble(scene, 0.04, 1);
    const std::optional<Instability> found = simulation.run(
        0.2, [](const Simulation&) {}, {}, contact_monitor(scene));
    REQUIRE(found);
    CHECK_THAT(found->quantity, Catch::Contains("contact.stiffness is too low"));
}
