// SPDX-License-Identifier: BSD-3-Clause
// Observed order, Richardson value and grid convergence index of made-up sequences.
#include "validation/metrics/convergence.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace wetdeck;

namespace {

ConvergenceRow row_of(const std::vector<double>& spacings, double limit, double factor, double order) {
    std::vector<std::pair<double, double>> points;
    for (const double h : spacings) points.emplace_back(h, limit + factor * std::pow(h, order));
    return convergence(points);
}

}  // namespace

TEST_CASE("A second-order sequence gives order 2.00, its limit and its index", "[gci]") {
    const ConvergenceRow row = row_of({0.04, 0.02, 0.01}, 1, 3, 2);
    CHECK(row.verdict == "monotonic");
    CHECK(row.monotone);
    CHECK(row.order.value() == Approx(2).epsilon(1e-9));
    CHECK(row.extrapolated.value() == Approx(1).epsilon(1e-12));
    // the error of the finest value is 3 h^2 exactly
    CHECK(row.gci_fine.value() == Approx(1.25 * 3e-4).epsilon(1e-9));
    CHECK_FALSE(row.asymptotic_ratio.has_value());
}

TEST_CASE("The order is found for ratios that are not constant and any sign of the error", "[gci]") {
    const double order = GENERATE(0.6, 1.0, 1.7, 2.0, 3.5);
    const double factor = GENERATE(-4.0, 4.0);
    const ConvergenceRow row = row_of({0.01, 0.031, 0.017}, -2, factor, order);
    CHECK(row.order.value() == Approx(order).epsilon(1e-8));
    CHECK(row.extrapolated.value() == Approx(-2).epsilon(1e-9));
    CHECK(row.gci_fine.value() == Approx(1.25 * 4 * std::pow(0.01, order)).epsilon(1e-7));
}

TEST_CASE("Spacings are put in order from coarse to fine", "[gci]") {
    const ConvergenceRow row = row_of({0.01, 0.04, 0.02}, 1, 3, 2);
    CHECK(row.dx == std::vector<double>{0.04, 0.02, 0.01});
    CHECK(row.value[2] == Approx(1.0003));
}

TEST_CASE("Fewer than three spacings give no order", "[gci]") {
    const ConvergenceRow row = row_of({0.04, 0.02}, 1, 3, 2);
    CHECK(row.verdict == "too few spacings");
    CHECK_FALSE(row.order.has_value());
    CHECK_FALSE(row.gci_fine.has_value());
    CHECK(convergence({}).verdict == "too few spacings");
}

TEST_CASE("A sequence that swings is oscillatory and has no index", "[gci]") {
    const ConvergenceRow row = convergence({{0.04, 1.0}, {0.02, 1.2}, {0.01, 1.1}});
    CHECK(row.verdict == "oscillatory");
    CHECK_FALSE(row.monotone);
    CHECK_FALSE(row.order.has_value());
    CHECK_FALSE(row.extrapolated.has_value());
    CHECK_FALSE(row.gci_fine.has_value());
}

TEST_CASE("A sequence whose steps grow is divergent and has no index", "[gci]") {
    const ConvergenceRow row = convergence({{0.04, 1.0}, {0.02, 1.1}, {0.01, 1.4}});
    CHECK(row.verdict == "divergent");
    CHECK(row.monotone);
    CHECK(row.order.value() == Approx(-std::log2(3)));
    CHECK_FALSE(row.gci_fine.has_value());
}

TEST_CASE("Equal steps under halving have order zero and diverge", "[gci]") {
    const ConvergenceRow row = convergence({{0.04, 1.0}, {0.02, 1.25}, {0.01, 1.5}});
    CHECK(row.verdict == "divergent");
    CHECK(row.order.value() == Approx(0).margin(1e-9));
    CHECK_FALSE(row.gci_fine.has_value());
}

TEST_CASE("An order outside the credible band is not asymptotic and has no index", "[gci]") {
    const double order = GENERATE(0.4, 4.2, 9.0);
    const ConvergenceRow row = row_of({0.4, 0.2, 0.1}, 1, 3, order);
    CHECK(row.verdict == "not asymptotic");
    CHECK(row.order.value() == Approx(order).epsilon(1e-6));
    CHECK_FALSE(row.extrapolated.has_value());
    CHECK_FALSE(row.gci_fine.has_value());
}

TEST_CASE("Values that do not change are not asymptotic", "[gci]") {
    CHECK(convergence({{0.04, 1.0}, {0.02, 1.0}, {0.01, 1.0}}).verdict == "not asymptotic");
    CHECK(convergence({{0.04, 1.0}, {0.02, 1.1}, {0.01, 1.1}}).verdict == "not asymptotic");
}

TEST_CASE("A fourth spacing on the curve confirms the asymptotic range", "[gci]") {
    const ConvergenceRow row = row_of({0.08, 0.04, 0.02, 0.01}, 1, 3, 2);
    CHECK(row.asymptotic_ratio.value() == Approx(1).epsilon(1e-9));
    CHECK(row.verdict == "monotonic");
}

TEST_CASE("A fourth spacing off the curve denies the asymptotic range", "[gci]") {
    // the finest three are of order 2 with a step of 0.0036 before them; the coarsest is 10 times too far
    // away
    const ConvergenceRow row =
        convergence({{0.08, 1.0048 + 0.144}, {0.04, 1.0048}, {0.02, 1.0012}, {0.01, 1.0003}});
    CHECK(row.asymptotic_ratio.value() == Approx(10).epsilon(1e-6));
    CHECK(row.verdict == "not asymptotic");
    CHECK_FALSE(row.gci_fine.has_value());
}
