// SPDX-License-Identifier: BSD-3-Clause
// Least-squares estimates of made-up values whose limit is known.
#include "validation/metrics/least_squares_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "validation/metrics/convergence.hpp"

using namespace wetdeck;

namespace {

using Points = std::vector<std::pair<double, double>>;

template <class Value>
Points values_at(const std::vector<double>& spacings, Value value) {
    Points points;
    for (const double h : spacings) points.emplace_back(h, value(h));
    return points;
}

const std::vector<double> five = {0.04, 0.03, 0.02, 0.015, 0.01};

}  // namespace

TEST_CASE("Values on a curve of one power give its limit, its order and 1.25 times the error",
          "[least_squares]") {
    const double p = GENERATE(0.6, 1.0, 1.5, 2.0);
    const auto fit =
        fit_least_squares(values_at(five, [p](double h) { return 5 + 3 * std::pow(h / 0.01, p); }));
    REQUIRE(fit);
    CHECK(fit->limit == Approx(5).epsilon(1e-4));
    if (fit->order) CHECK(*fit->order == Approx(p).epsilon(1e-4));  // none where rounding puts p beyond 2
    CHECK(fit->uncertainty == Approx(1.25 * 3).epsilon(0.01));
}

TEST_CASE("A higher order than the method's is not believed: second order, three times the error",
          "[least_squares]") {
    const auto fit = fit_least_squares(values_at(five, [](double h) { return 5 + std::pow(h / 0.01, 4); }));
    REQUIRE(fit);
    CHECK(!fit->order);
    CHECK(fit->uncertainty > 1);  // the error of the finest
}

TEST_CASE("Values that scatter about a constant have a multiple of their scatter", "[least_squares]") {
    const auto fit =
        fit_least_squares({{0.04, 1.02}, {0.03, 0.98}, {0.02, 1.03}, {0.015, 0.97}, {0.01, 1.01}});
    REQUIRE(fit);
    CHECK(fit->uncertainty > 0.03);
    CHECK(fit_least_squares({{4, 1}, {3, 1}, {2, 1}, {1, 1}})->uncertainty == 0);
}

TEST_CASE("Fewer than four spacings have no least-squares fit", "[least_squares]") {
    CHECK(!fit_least_squares({{4, 1}, {2, 2}, {1, 3}}));
    CHECK(!convergence({{4, 1}, {2, 2}, {1, 2.5}}).least_squares);
    const ConvergenceRow four = convergence({{8, 5}, {4, 2}, {2, 1.25}, {1, 1.0625}});
    REQUIRE(four.least_squares);
    CHECK(numerical_uncertainty(four).value() == Approx(0.5 * *four.least_squares));
}

TEST_CASE("The interval of least squares holds the limit in 95 of 100 cases where noise is 2 % of the error",
          "[least_squares]") {
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> order(0.6, 2);
    int held = 0;
    constexpr int cases = 1000;
    for (int k = 0; k < cases; ++k) {
        const double p = order(engine);
        const Points points = values_at(
            five, [&](double h) { return 5 + 0.1 * std::pow(h / 0.01, p) + 0.002 * normal(engine); });
        held += std::abs(points.back().second - 5) <= fit_least_squares(points)->uncertainty;
    }
    CHECK(held >= 0.95 * cases);
}
