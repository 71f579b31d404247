// SPDX-License-Identifier: BSD-3-Clause
// Spacings that a scene can and cannot be run at, and what they will cost.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

Scene small(const std::vector<std::string>& overrides = {}) {
    return parse_scene(samples::small_scene, "small.toml", std::nullopt, overrides);
}

}  // namespace

TEST_CASE("a spacing that divides every side is taken") {
    REQUIRE_NOTHROW(check_spacing(small(), 0.02));
    REQUIRE_NOTHROW(check_spacing(small(), 0.04));
}

TEST_CASE("a spacing that does not fit a side is refused with the nearest that fit all") {
    REQUIRE_THROWS_AS(check_spacing(small(), 0.07), InputError);
    REQUIRE_THROWS_WITH(check_spacing(small(), 0.07),
                        Contains("particle spacing 0.07 m does not fit the side of 0.4 m (5.71 particles)") &&
                            Contains("the nearest that fit all boxes: 0.04 m"));
    // not 0.08 nor 0.0667: the air above is 0.28 m high
    for (const double no : {0.08, 0.0666667, 0.05}) REQUIRE_THROWS_AS(check_spacing(small(), no), InputError);
}

TEST_CASE("a spacing that is not a positive number is refused") {
    for (const double bad : {0.0, -0.02, std::nan("")})
        REQUIRE_THROWS_WITH(check_spacing(small(), bad), Contains("expected a positive spacing"));
}

TEST_CASE("a spacing that would make too many particles is refused before they are made") {
    REQUIRE_THROWS_WITH(check_spacing(small(), 1e-6),
                        Contains("would make 4.8e+11 particles, expected at most 5e+07"));
}

TEST_CASE("a gauge smaller than the spacing is refused") {
    const Scene scene =
        small({"probes=[{name=\"front\", type=\"front\"}, "
               "{name=\"g\", type=\"wall_pressure\", centre=[1.0,0.1], diameter=0.03}]"});
    REQUIRE_THROWS_AS(check_spacing(scene, 0.04), InputError);
    REQUIRE_THROWS_WITH(check_spacing(scene, 0.04),
                        Contains("a pressure gauge of 0.03 m is smaller than the particle spacing 0.04 m"));
}

TEST_CASE("a scene is assembled with the particles that its boxes hold") {
    const Simulation simulation = assemble(small(), 0.04, 1);
    REQUIRE(simulation.fluid().size() == 25 * 12);
    double mass = 0;
    for (std::size_t i = 0; i < simulation.fluid().size(); ++i)
        mass += simulation.fluid().state[i].volume * simulation.fluid().state[i].density;
    REQUIRE(mass == Approx(1000 * 0.4 * 0.2 + 1 * (0.48 - 0.08)).epsilon(0.01));
}

TEST_CASE("the estimated particles are those that a run makes") {
    REQUIRE(estimate_cost(small(), 0.04).fluid_particles == Approx(300));
    REQUIRE(estimate_cost(small({"model.air=false"}), 0.04).fluid_particles == Approx(50));
}

TEST_CASE("half the spacing costs four times the particles, twice the steps, and files only four times") {
    const CostEstimate coarse = estimate_cost(small(), 0.04), fine = estimate_cost(small(), 0.02);
    REQUIRE(fine.fluid_particles / coarse.fluid_particles == Approx(4));
    REQUIRE(fine.steps / coarse.steps == Approx(2).epsilon(0.05));
    REQUIRE(fine.particle_steps / coarse.particle_steps == Approx(8).epsilon(0.05));
    REQUIRE(fine.core_seconds / coarse.core_seconds > 4);
    REQUIRE(fine.core_seconds / coarse.core_seconds < 8);
    const CostEstimate plain = estimate_cost(small({"model.air_substeps=1"}), 0.02);
    REQUIRE(plain.particle_steps == Approx(plain.fluid_particles * plain.steps));
    const CostEstimate three = estimate_cost(small({"model.air_substeps=3"}), 0.02);
    REQUIRE(three.particle_steps == Approx((200 + 3 * 1000) * three.steps));
}

TEST_CASE("twice the time costs twice the steps") {
    REQUIRE(estimate_cost(small({"run.end_time=0.4"}), 0.02).steps / estimate_cost(small(), 0.02).steps ==
            Approx(2));
}

TEST_CASE("water alone costs less than water and air") {
    REQUIRE(estimate_cost(small({"model.air=false"}), 0.02).core_seconds <
            0.25 * estimate_cost(small(), 0.02).core_seconds);
}
