// SPDX-License-Identifier: BSD-3-Clause
// Fluid inside a body of a scene is found, wherever the body has moved to.
#include "validation/run/penetration_monitor.hpp"

#include <catch2/catch.hpp>

#include "validation/run/assemble.hpp"

using namespace wetdeck;

TEST_CASE("Fluid deeper in a body than one spacing is found, fluid beside it is not", "[execute]") {
    const Scene scene = read_scene(find_scene("wedge"));
    const double dx = scene.tiers.at("quick").begin()->second.front();
    Simulation simulation = assemble(scene, dx, 1);
    const Simulation::StabilityMonitor watch = penetration_monitor(scene);
    REQUIRE(watch);
    for (int n = 0; n < 20; ++n) REQUIRE_FALSE(simulation.step(1));
    REQUIRE_FALSE(watch(simulation));

    const std::size_t one = simulation.fluid().size() / 2;
    const RigidBody& body = simulation.bodies().front();
    const auto depth_of = [&](Vec2 place) {  // in the outline as it was placed at the start
        return -distance_to(scene.bodies.front().outline,
                            scene.bodies.front().body.placed(body.local(place)));
    };
    const BodySpec& spec = scene.bodies.front();
    Vec2 place = body.placed(spec.body.local(area_moments(spec.outline).centroid));
    REQUIRE(depth_of(place) > 2 * dx);
    while (depth_of(place) > 1.01 * dx) place.y() -= 0.005 * dx;  // down to just above the threshold
    simulation.disturb().state[one].x = place.x();
    simulation.disturb().state[one].y = place.y();
    const std::optional<Instability> instability = watch(simulation);
    REQUIRE(instability);
    CHECK(instability->particle == simulation.fluid().id[one]);
    CHECK(instability->position == place);
    CHECK_THAT(instability->quantity, Catch::Contains("deep inside body 1"));
    while (depth_of(place) > 0.99 * dx) place.y() -= 0.005 * dx;
    simulation.disturb().state[one].y = place.y();
    CHECK_FALSE(watch(simulation));
}

TEST_CASE("Scenes without bodies are not watched for fluid in them", "[execute]") {
    CHECK_FALSE(penetration_monitor(read_scene(find_scene("dam_break"))));
}
