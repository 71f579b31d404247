// SPDX-License-Identifier: BSD-3-Clause
// The kernel: normalisation, slope, support.
#include "solver/physics/wendland_c2.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "tests/support/quadrature.hpp"

using namespace wetdeck;

TEST_CASE("The kernel's integral over the plane is one", "[kernel]") {
    const WendlandC2 kernel{GENERATE(0.01, 1.0, 3.7)};
    const auto ring = [&](double r) { return 2 * std::numbers::pi * r * kernel.value(r); };
    CHECK(samples::integral(ring, 0, kernel.support_radius()) == Approx(1).epsilon(1e-12));
}

TEST_CASE("The kernel's slope is the derivative of its value", "[kernel]") {
    const WendlandC2 kernel{0.05};
    const double q = GENERATE(0.05, 0.3, 0.8, 1.0, 1.5, 1.9);
    const double r = q * kernel.smoothing_length, step = 1e-6 * kernel.smoothing_length;
    const double difference = (kernel.value(r + step) - kernel.value(r - step)) / (2 * step);
    // a central difference with this step has an error near 1e-10 of the largest slope
    const double largest = kernel.slope_over_distance(0) * kernel.smoothing_length;
    CHECK(-r * kernel.slope_over_distance(r) == Approx(difference).margin(1e-8 * largest));
}

TEST_CASE("Kernel value and slope vanish at two smoothing lengths and beyond", "[kernel]") {
    const WendlandC2 kernel{0.05};
    CHECK(kernel.support_radius() == 0.1);
    const double r = GENERATE(0.1, 0.1000001, 0.2, 5.0);
    CHECK(kernel.value(r) == 0);
    CHECK(kernel.slope_over_distance(r) == 0);
    CHECK(kernel.value(0.0999) > 0);
    CHECK(kernel.slope_over_distance(0.0999) > 0);
}

TEST_CASE("The kernel's value at its centre is 7 / (4 pi h^2)", "[kernel]") {
    CHECK(WendlandC2{0.5}.value(0) == Approx(7 / std::numbers::pi).epsilon(1e-14));
}
