// SPDX-License-Identifier: BSD-3-Clause
// The time that is left, as a run and a suite show it.
#include "validation/run/progress.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

TEST_CASE("the time left is that of the pace so far, and unknown at the start", "[progress]") {
    TimeLeft left;
    CHECK_FALSE(left.estimate(10, 0.001).has_value());
    CHECK(left.estimate(10, 0.1).value() == Approx(90));
    CHECK(left.estimate(20, 0.2).value() == Approx(80));
    CHECK(left.estimate(20, 0.8).value() == Approx(5));
    CHECK(left.estimate(20, 1).value() == 0);
}

TEST_CASE("a machine that slows down raises the time left by at most a third an estimate", "[progress]") {
    TimeLeft left;
    double last = left.estimate(10, 0.5).value();
    double share = 0.5;
    for (const double elapsed : {20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0, 1290.0, 1300.0, 1310.0}) {
        share += 0.001;
        const double now = left.estimate(elapsed, share).value();
        CHECK(now <= last * 4 / 3 + 1e-9);
        CHECK(now <= elapsed * (1 - share) / share + 1e-9);
        last = now;
    }
    CHECK(last > 100);  // and it follows
}
