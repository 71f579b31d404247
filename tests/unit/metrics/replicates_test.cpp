// SPDX-License-Identifier: BSD-3-Clause
// The spread of replicates and what it does to a verdict, with numbers that are known beforehand.
#include "validation/metrics/replicates.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "validation/metrics/metric.hpp"
#include "validation/metrics/validation.hpp"

using namespace wetdeck;

namespace {

std::vector<double> normal_draws(double mean, double deviation, int n, unsigned seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(mean, deviation);
    std::vector<double> values;
    for (int k = 0; k < n; ++k) values.push_back(normal(engine));
    return values;
}

AnalysisSpec scene() {
    AnalysisSpec spec;
    spec.scene = "made_up";
    spec.default_variant = "a";
    QuantitySpec quantity;
    quantity.name = "peak";
    quantity.metric = &metric_named("maximum");
    quantity.expected_kind = ReferenceKind::experiment;
    quantity.expected_uncertainty = 0.1;
    spec.quantities = {quantity};
    return spec;
}

RunSummary run(double dx, double value, const std::string& variant = "a") {
    RunSummary made;
    made.record.scene = "made_up";
    made.record.variant = variant;
    made.record.particle_spacing = dx;
    made.record.status = RunStatus::ok;
    made.quantities = {{"peak", "Pa", value, "", 10.0, 1.0, "made up", {}}};
    return made;
}

std::vector<SensitivityRun> replicates(const std::vector<double>& values, const std::string& variant = "a") {
    std::vector<SensitivityRun> runs;
    double seed = 0;
    for (const double value : values) runs.push_back({arrangement_key, ++seed, run(0.04, value, variant)});
    return runs;
}

ValidationRow judged(const std::vector<double>& by_spacing, const std::vector<SensitivityRun>& repeated,
                     const std::string& variant = "a") {
    std::vector<RunSummary> runs;
    double dx = 0.04;
    for (const double value : by_spacing) {
        runs.push_back(run(dx, value, variant));
        dx /= 2;
    }
    const std::vector<ReplicateRow> rows = replicate_rows(scene(), repeated);
    return judged_rows(scene(), runs, {{}, rows}).validation.at(0);
}

}  // namespace

TEST_CASE("Mean, deviation and interval of five numbers are those of a table of Student's t",
          "[replicates]") {
    const ReplicateRow row = spread_of({12, 9, 10, 8, 11});
    CHECK(row.mean == Approx(10));
    CHECK(row.deviation == Approx(std::sqrt(2.5)));
    CHECK(row.high - row.mean == Approx(2.7764 * std::sqrt(2.5 / 5)).epsilon(1e-4));  // t(0.975, 4)
    CHECK(row.mean - row.low == Approx(row.high - row.mean));
    CHECK(std::is_sorted(row.value.begin(), row.value.end()));
    CHECK_THROWS_AS(spread_of({1}), std::invalid_argument);
}

TEST_CASE("The interval of the mean covers it in 95 of 100 samples", "[replicates]") {
    int covered = 0;
    for (unsigned sample = 0; sample < 1000; ++sample) {
        const ReplicateRow row = spread_of(normal_draws(3, 0.5, 20, sample));
        covered += row.low <= 3 && 3 <= row.high;
    }
    CHECK(covered >= 930);
    CHECK(covered <= 970);
}

TEST_CASE("The area between two distributions is that of the textbook", "[replicates]") {
    // two steps: the distance of the places
    CHECK(area_metric({7, 7, 7}, 10, 0) == Approx(3));
    CHECK(area_metric({9, 11}, 10, 0) == Approx(1));
    // far from each other: the distance of the means, whatever the widths
    CHECK(area_metric(normal_draws(0, 1, 200, 1), 100, 2) ==
          Approx(100 - spread_of(normal_draws(0, 1, 200, 1)).mean).epsilon(1e-9));
    // one step in the middle of a normal distribution: the mean modulus, sqrt(2/pi) sigma
    CHECK(area_metric({10}, 10, 2) == Approx(2 * std::sqrt(2 / M_PI)));
    // draws of the same distribution: the more of them, the less
    const double few = area_metric(normal_draws(0, 1, 20, 7), 0, 1),
                 many = area_metric(normal_draws(0, 1, 20000, 7), 0, 1);
    CHECK(many < 0.02);
    CHECK(few > 3 * many);
}

TEST_CASE("Rows hold the replicates that ended well, by variant", "[replicates]") {
    std::vector<SensitivityRun> runs = replicates({10, 12, 11});
    for (SensitivityRun& other : replicates({20, 22}, "b")) runs.push_back(other);
    runs[2].run.record.status = RunStatus::unstable;
    runs.push_back({"body.mass", 1, run(0.04, 99)});
    const std::vector<ReplicateRow> rows = replicate_rows(scene(), runs);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].variant == "a");
    CHECK(rows[0].value == std::vector<double>{10, 12});
    CHECK(rows[0].reference.value() == 10);
    CHECK(rows[0].area.has_value());
    CHECK(rows[1].variant == "b");
    CHECK(rows[1].mean == Approx(21));
    CHECK(replicate_rows(scene(), replicates({10})).empty());
}

TEST_CASE("Spacings that differ as replicates do leave no uncertainty of the spacing", "[replicates]") {
    const auto repeated = replicates(normal_draws(10, 0.5, 20, 3));
    const double s = replicate_rows(scene(), repeated).at(0).deviation;
    const ValidationRow chance = judged({10.3, 9.9, 10.1}, repeated);
    CHECK(chance.u_scatter.value() == Approx(s));
    CHECK(chance.u_grid.value() == 0);
    CHECK(chance.u_num.value() == Approx(s));
    CHECK(chance.verdict == "within the uncertainty");

    const ValidationRow alone = judged({10.3, 9.9, 10.1}, {});
    CHECK(alone.u_grid.value() == Approx(0.4));  // the range
    CHECK(!alone.u_scatter);
}

TEST_CASE("Spacings that differ by more than replicates keep what exceeds these", "[replicates]") {
    const auto repeated = replicates(normal_draws(11, 0.1, 20, 3));
    const double s = replicate_rows(scene(), repeated).at(0).deviation;
    const ValidationRow oscillating = judged({12, 10, 12}, repeated);
    CHECK(oscillating.u_grid.value() == Approx(std::sqrt(4.0 / 3 - s * s)));
    CHECK(oscillating.u_num.value() == Approx(std::hypot(oscillating.u_grid.value(), s)));
    const ValidationRow converging = judged({15, 12, 11.25}, repeated);  // second order
    CHECK(converging.u_num_source == "GCI / 2");
    CHECK(converging.u_grid.value() == Approx(0.5 * 1.25 * 0.25));
    const ValidationRow diverging = judged({11, 12, 14}, repeated);
    CHECK(diverging.u_grid.value() == Approx(3));
}

TEST_CASE("A variant without replicates takes those of the default variant", "[replicates]") {
    const ValidationRow other = judged({11.3, 10.9, 11.1}, replicates({10.5, 11.5}), "b");
    CHECK(other.u_scatter.value() == Approx(std::sqrt(0.5)));
}
