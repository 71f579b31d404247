// SPDX-License-Identifier: BSD-3-Clause
// Bodies whose place, mass centre or mass cannot be meant.
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

std::string refused(const std::vector<std::string>& overrides) {
    const std::string box =
        "[body]\noutline = [[-0.1, -0.05], [0.1, -0.05], [0.1, 0.05], [-0.1, 0.05]]\n"
        "position = [0.5, 0.3]\nfree = [\"y\"]\nmass = 5.0\n\n[initial]\n";
    return samples::refusal(samples::with("[initial]\n", box), std::nullopt, overrides);
}

}  // namespace

TEST_CASE("a body that touches the tank is refused with what to do, one beyond it with how far", "[scene]") {
    const std::pair<const char*, const char*> table[] = {
        {"body.position=[0.5, 0.05]", "touches the tank's floor: leave a gap of less than half a spacing"},
        {"body.position=[0.5, 0.43]", "touches the tank's roof"},
        {"body.position=[0.1, 0.3]", "touches the tank's left wall"},
        {"body.position=[0.9, 0.3]", "touches the tank's right wall"},
        {"body.position=[0.5, 0.02]", "reaches outside the tank: 0.03 m beyond the floor"},
        {"body.position=[0.5, 0.45]", "0.02 m beyond the roof"},
        {"body.position=[0.05, 0.3]", "0.05 m beyond the left wall"},
        {"body.position=[1.0, 0.3]", "0.1 m beyond the right wall"},
    };
    for (const auto& [position, text] : table) CHECK_THAT(refused({position}), Contains(text));
    CHECK(refused({"body.position=[0.5, 0.051]"}).empty());
    CHECK_THAT(refused({"body.position=[0.5, 0.05]"}), Contains("table [contact]"));
    CHECK_THAT(refused({"body.position=[0.5, 0.05]", "body.free=[]"}), !Contains("table [contact]"));
    CHECK(refused({"body.position=[0.5, 0.05]", "contact.restitution=0.5"}).empty());
    CHECK_FALSE(refused({"body.position=[0.5, 0.05]", "contact.restitution=0.5", "body.free=[]"}).empty());
}

TEST_CASE("a mass centre outside the outline is refused, with the frame that it is in", "[scene]") {
    for (const char* outside : {"[0.5, 0.3]", "[0.11, 0.0]", "[0.0, -0.06]", "[-0.2, 0.0]", "[0.0, 3.0]"}) {
        const std::string message = refused({std::string("body.mass_centre=") + outside});
        CHECK_THAT(message, Contains("key 'body.mass_centre'") &&
                                Contains("from (-0.1, -0.05) to (0.1, 0.05)") &&
                                Contains("in the frame of the outline"));
    }
    for (const char* within : {"[0.0, 0.0]", "[0.1, 0.05]", "[-0.05, 0.01]"})
        CHECK(refused({std::string("body.mass_centre=") + within}).empty());
}

TEST_CASE("a body that is free to turn alone needs a mass or an inertia, and says so", "[scene]") {
    const std::string box =
        "[body]\noutline = [[0.4, 0.3], [0.6, 0.3], [0.6, 0.4], [0.4, 0.4]]\n"
        "position = [0.0, 0.0]\nfree = [\"rotation\"]\n\n[initial]\n";
    const auto said = [&](const std::vector<std::string>& overrides) {
        return samples::refusal(samples::with("[initial]\n", box), std::nullopt, overrides);
    };
    CHECK_THAT(said({}), Contains("key 'body.mass': missing") && Contains("or its inertia [kg m]"));
    CHECK(said({"body.mass=20"}).empty());
    CHECK(said({"body.inertia=0.1"}).empty());
    CHECK_THAT(said({"body.inertia=0"}), Contains("key 'body.inertia'"));
    CHECK_THAT(said({"body.mass=0"}), Contains("key 'body.mass'"));
}
