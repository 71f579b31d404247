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
    REQUIRE((up.stable && up.unstable));
    CHECK(*up.stable <= truth);
    CHECK(*up.unstable > truth);
    CHECK(*up.unstable / *up.stable <= 1.05);
    CHECK(runs <= 2 + static_cast<int>(std::ceil(std::log2(std::log(8) / std::log(1.05)))));
    const Limit down = find_limit(4, 0.5, 1.05, [&](double value) { return value >= truth; });
    REQUIRE((down.stable && down.unstable));
    CHECK(*down.stable >= truth);
    CHECK(*down.unstable < truth);
    CHECK(*down.stable / *down.unstable <= 1.05);
}

TEST_CASE("A range without a limit says which side of it all is", "[stress]") {
    const Limit all = find_limit(1, 10, 1.1, [](double) { return true; });
    CHECK(all.stable == 10);
    CHECK_FALSE(all.unstable);
    const Limit none = find_limit(1, 10, 1.1, [](double) { return false; });
    CHECK_FALSE(none.stable);
    CHECK(none.unstable == 1);
}
