// SPDX-License-Identifier: BSD-3-Clause
// The pressure at the start is that of the water above each particle; after Greco on either side of the face.
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"

using namespace wetdeck;

namespace {

/// The small scene with air at its roof only, so that the water's boxes may be anywhere below.
const std::string& low_water() {
    static const std::string text =
        samples::with("[[0.4, 0.0, 1.0, 0.2], [0.0, 0.2, 1.0, 0.48]]", "[[0.0, 0.44, 1.0, 0.48]]");
    return text;
}

/// Largest difference between the pressure of the water and an exact one, without air [Pa].
template <class Exact>
double largest_error(const std::vector<std::string>& overrides, const Exact& exact) {
    const Scene scene = parse_scene(low_water(), "small.toml", "single-phase", overrides);
    const Simulation simulation = assemble(scene, 0.02, 1);
    double largest = 0;
    for (const FluidState& p : simulation.fluid().state)
        largest = std::max(largest, std::abs(p.pressure - exact(p.position())));
    return largest;
}

constexpr double weight = 1000 * 9.81;

}  // namespace

TEST_CASE("each column stands under its own level", "[scene]") {
    const auto under = [](double level) { return [level](Vec2 at) { return weight * (level - at.y()); }; };
    CHECK(largest_error({}, under(0.2)) < 1);
    CHECK(largest_error({"initial.surface=0.4"}, under(0.2)) < 1);
    CHECK(largest_error({"water.boxes=[[0.0, 0.0, 0.4, 0.1], [0.0, 0.1, 0.4, 0.2]]"}, under(0.2)) < 1);
    const auto steps = [](double at, double left, double right) {
        return [=](Vec2 p) { return weight * ((p.x() < at ? left : right) - p.y()); };
    };
    CHECK(largest_error({"water.boxes=[[0.0, 0.0, 0.4, 0.2], [0.4, 0.0, 1.0, 0.06]]"},
                        steps(0.4, 0.2, 0.06)) < 1);
    CHECK(largest_error({"water.boxes=[[0.0, 0.0, 0.3, 0.2], [0.7, 0.0, 1.0, 0.1]]"}, steps(0.5, 0.2, 0.1)) <
          1);
    CHECK(largest_error({"water.boxes=[[0.0, 0.0, 1.0, 0.06], [0.6, 0.06, 1.0, 0.2]]"},
                        steps(0.6, 0.06, 0.2)) < 1);
}

TEST_CASE("the surface may be left out: it is the highest top of the water", "[scene]") {
    const Scene scene = parse_scene(samples::without("surface = 0.2\n"), "small.toml");
    CHECK(scene.initial.surface == 0.2);
}

TEST_CASE("Greco's pressure is the same on either side of the released face", "[scene]") {
    const std::vector<std::string> left = {"initial.pressure=greco", "initial.released_face=0.4"};
    const std::vector<std::string> right = {"initial.pressure=greco", "initial.released_face=0.6",
                                            "water.boxes=[[0.6, 0.0, 1.0, 0.2]]"};
    const auto pressures = [](const std::vector<std::string>& overrides, bool mirrored) {
        std::map<std::pair<int, int>, double> all;
        const Simulation simulation =
            assemble(parse_scene(low_water(), "small.toml", "single-phase", overrides), 0.02, 1);
        for (const FluidState& p : simulation.fluid().state) {
            const double x = mirrored ? 1 - p.x : p.x;
            all[{static_cast<int>(std::lround(1000 * x)), static_cast<int>(std::lround(1000 * p.y))}] =
                p.pressure;
        }
        return all;
    };
    const auto a = pressures(left, false), b = pressures(right, true);
    REQUIRE(a.size() == 200);
    REQUIRE(b.size() == a.size());
    for (const auto& [place, pressure] : a) CHECK(b.at(place) == Approx(pressure).margin(1e-3));
    CHECK(a.at({10, 10}) > 0.9 * weight * 0.19);
}

TEST_CASE("Greco's pressure is refused for water that is no column with the released face", "[scene]") {
    const auto refused = [](const char* boxes, const char* face,
                            const char* surface = "initial.surface=0.2") {
        return samples::refusal(low_water(), "single-phase",
                                {"initial.pressure=greco", std::string("water.boxes=") + boxes,
                                 std::string("initial.released_face=") + face, surface});
    };
    CHECK(refused("[[0.0, 0.0, 0.4, 0.2]]", "0.4").empty());
    CHECK(refused("[[0.6, 0.0, 1.0, 0.2]]", "0.6").empty());
    CHECK(refused("[[0.0, 0.0, 0.2, 0.2], [0.2, 0.0, 0.4, 0.2]]", "0.4").empty());
    CHECK(refused("[[0.0, 0.0, 0.4, 0.1], [0.0, 0.1, 0.4, 0.2]]", "0.4").empty());
    const char* const wrong[][2] = {
        {"[[0.0, 0.0, 0.4, 0.2]]", "0.5"},
        {"[[0.0, 0.0, 0.4, 0.2]]", "0.3"},
        {"[[0.6, 0.0, 1.0, 0.2]]", "0.4"},
        {"[[0.0, 0.0, 0.4, 0.2], [0.6, 0.0, 1.0, 0.2]]", "0.4"},
        {"[[0.0, 0.0, 0.4, 0.2], [0.4, 0.0, 1.0, 0.06]]", "0.4"},
        {"[[0.0, 0.1, 0.4, 0.2]]", "0.4"},
    };
    for (const auto& [boxes, face] : wrong) {
        CAPTURE(boxes, face);
        CHECK_THAT(refused(boxes, face), Catch::Contains("key 'initial."));
    }
    CHECK_THAT(refused("[[0.0, 0.0, 1.0, 0.2]]", "1.0"), Catch::Contains("key 'initial.released_face'"));
    CHECK_THAT(refused("[[0.0, 0.0, 0.4, 0.2]]", "0.0"), Catch::Contains("key 'initial.released_face'"));
    CHECK_THAT(refused("[[0.3, 0.0, 0.7, 0.2]]", "0.7"), Catch::Contains("is free at both ends"));
    CHECK_THAT(refused("[[0.0, 0.0, 0.4, 0.2]]", "0.4", "initial.surface=0.3"),
               Catch::Contains("key 'initial.pressure'"));
}
