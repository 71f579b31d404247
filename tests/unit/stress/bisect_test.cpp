// SPDX-License-Identifier: BSD-3-Clause
// The search for a limit, against limits that are known.
#include "validation/stress/bisect.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace wetdeck::stress;

TEST_CASE("A limit above and one below the start are enclosed as closely as wanted", "[stress]") {
    const double truth = GENERATE(0.93, 1.7, 3.99);
    int runs = 0;
    const Limit up = find_limit(0.5, 4, 1.05, [&](double value) {
        ++runs;
        return value <= truth;
    });
    REQUIRE((up.alive && up.dead));
    CHECK(*up.alive <= truth);
    CHECK(*up.dead > truth);
    CHECK(*up.dead / *up.alive <= 1.05);
    CHECK(runs <= 2 + static_cast<int>(std::ceil(std::log2(std::log(8) / std::log(1.05)))));
    const Limit down = find_limit(4, 0.5, 1.05, [&](double value) { return value >= truth; });
    REQUIRE((down.alive && down.dead));
    CHECK(*down.alive >= truth);
    CHECK(*down.dead < truth);
    CHECK(*down.alive / *down.dead <= 1.05);
}

TEST_CASE("A range without a limit says which side of it all is", "[stress]") {
    const Limit all = find_limit(1, 10, 1.1, [](double) { return true; });
    CHECK(all.alive == 10);
    CHECK_FALSE(all.dead);
    const Limit none = find_limit(1, 10, 1.1, [](double) { return false; });
    CHECK_FALSE(none.alive);
    CHECK(none.dead == 1);
}
