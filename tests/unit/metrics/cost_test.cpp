// SPDX-License-Identifier: BSD-3-Clause
// Rates and shares of a made-up cost.
#include "validation/metrics/cost.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

TEST_CASE("The rate is particle-steps over wall time, and nothing without a time", "[cost]") {
    RunCost cost;
    cost.particle_steps = 500;
    CHECK_FALSE(particle_rate(cost).has_value());
    cost.wall_s = 10;
    CHECK(particle_rate(cost) == 50.0);
}

TEST_CASE("Shares of the stages add up to one", "[cost]") {
    RunCost cost;
    CHECK(stage_shares(cost).empty());
    cost.stage_seconds = {{"list", 1}, {"rates", 3}};
    CHECK(stage_shares(cost) == std::map<std::string, double>{{"list", 0.25}, {"rates", 0.75}});
}

TEST_CASE("What limits the step comes with its share, the most frequent first", "[cost]") {
    RunCost cost;
    cost.limiting_criterion = {{"acoustic", 100}, {"body", 0}, {"viscous", 300}};
    const std::vector<std::pair<std::string, double>> expected{{"viscous", 0.75}, {"acoustic", 0.25}};
    CHECK(limiting_shares(cost) == expected);
}

TEST_CASE("The source's particle-steps are its particles times its steps", "[cost]") {
    CHECK(particle_steps(SourceRun{2000, 50, ""}) == 1e5);
}
