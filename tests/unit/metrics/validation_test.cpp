// SPDX-License-Identifier: BSD-3-Clause
// Comparison error and its uncertainty, suite statistics, cheapest runs: made-up runs with known answers.
#include "validation/metrics/validation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "validation/metrics/analysis.hpp"
#include "validation/metrics/speed_error.hpp"
#include "validation/metrics/statistics.hpp"

using namespace wetdeck;

namespace {

AnalysisSpec scene() {
    AnalysisSpec spec;
    spec.scene = "tank";
    spec.default_variant = "a";
    QuantitySpec peak;
    peak.name = "peak";
    peak.metric = &metric_named("maximum");
    peak.series = "p";
    peak.expected = 10;
    peak.tolerance = 1;
    peak.expected_kind = ReferenceKind::experiment;
    peak.expected_uncertainty = 0.1;
    spec.quantities = {peak};
    return spec;
}

RunSummary run(double dx, double top, const std::string& variant = "a") {
    RunSummary r;
    r.record.scene = "tank";
    r.record.variant = variant;
    r.record.particle_spacing = dx;
    r.record.cost.core_s = 1 / dx;
    r.record.series["p"] = {"Pa", "", {0, 1, 2}, {0, top, 0}, {}};
    return r;
}

SensitivitySpec mass_study() {
    SensitivitySpec spec;
    spec.key = "body.mass";
    spec.low = 90;
    spec.high = 110;
    spec.uncertainty = 5;
    spec.source = "made up";
    return spec;
}

/// Values 11 + 300 h^2: S = 11.03 at the finest, u_num = 0.5 * 1.25 * 0.03.
std::vector<RunSummary> sweep() {
    return {run(0.04, 11.48), run(0.02, 11.12), run(0.01, 11.03)};
}

Summary analysed(const AnalysisSpec& spec, std::vector<RunSummary> runs,
                 std::vector<SensitivityRun> varied = {}) {
    return analyse({spec}, std::move(runs), "/nonexistent", std::move(varied));
}

ScatterPoint pair(double expected, double predicted, std::optional<double> u_data) {
    ScatterPoint p;
    p.quantity_class = "pressure";
    p.kind = ReferenceKind::experiment;
    p.expected = expected;
    p.predicted = predicted;
    p.u_data = u_data;
    p.counted = true;
    return p;
}

}  // namespace

TEST_CASE("E, u_num and u_data of a quantity are as stated, u_input stays unknown without a study",
          "[validation]") {
    const Summary summary = analysed(scene(), sweep());
    REQUIRE(summary.validation.size() == 1);
    const ValidationRow& row = summary.validation[0];
    CHECK(row.error == Approx(1.03));
    CHECK(row.u_num.value() == Approx(0.5 * 1.25 * 0.03));
    CHECK(row.u_data.value() == 0.1);
    CHECK_FALSE(row.u_input.has_value());
    CHECK_FALSE(row.u_val.has_value());
    CHECK(row.u_known == Approx(std::hypot(0.1, 0.5 * 1.25 * 0.03)));
    CHECK(row.verdict == "unknown");
    CHECK_THAT(row.sentence, Catch::Contains("u_input unknown: the error of the model cannot be bounded"));
}

TEST_CASE("An uncertainty of the data that nobody stated is unknown, not zero", "[validation]") {
    AnalysisSpec spec = scene();
    spec.quantities[0].expected_uncertainty.reset();
    const ValidationRow row = analysed(spec, sweep()).validation.at(0);
    CHECK_FALSE(row.u_data.has_value());
    CHECK_FALSE(row.u_val.has_value());
}

TEST_CASE("Where the spacings swing the whole range stands for the numerical uncertainty", "[validation]") {
    const ValidationRow row =
        analysed(scene(), {run(0.04, 11), run(0.02, 12), run(0.01, 11.4)}).validation.at(0);
    CHECK(row.u_num.value() == Approx(1));
    CHECK(row.u_num_source == "oscillatory: range of three spacings");
    CHECK_FALSE(analysed(scene(), {run(0.02, 11)}).validation.at(0).u_num.has_value());
}

TEST_CASE("Two runs with one input changed give its share of the uncertainty", "[validation]") {
    AnalysisSpec spec = scene();
    spec.sensitivities = {mass_study()};
    std::vector<SensitivityRun> varied{{"body.mass", 90, run(0.02, 10.8)},
                                       {"body.mass", 110, run(0.02, 11.6)}};
    const Summary summary = analysed(spec, sweep(), varied);
    REQUIRE(summary.sensitivity.size() == 1);
    CHECK(summary.sensitivity[0].u_input == Approx(0.04 * 5));
    CHECK(summary.validation[0].u_input.value() == Approx(0.2));
    CHECK(summary.validation[0].u_val.value() == Approx(std::hypot(0.2, 0.1, 0.5 * 1.25 * 0.03)));
    CHECK(summary.validation[0].verdict == "too high");
    CHECK(summary.validation[0].assumed.empty());
    CHECK(summary.validation[0].u_input_variant == "a");
    varied.pop_back();
    CHECK(analysed(spec, sweep(), varied).sensitivity.empty());
}

TEST_CASE("A variant without a study takes the input uncertainty of the default variant", "[validation]") {
    AnalysisSpec spec = scene();
    spec.sensitivities = {mass_study()};
    spec.sensitivities[0].assumed = true;
    std::vector<RunSummary> runs = sweep();
    for (const double dx : {0.04, 0.02, 0.01}) runs.push_back(run(dx, 11, "b"));
    AnalysisSpec a = spec, b = spec;  // as the program has them: one each, in any order
    a.variant = "a";
    b.variant = "b";
    const std::vector<SensitivityRun> varied = {{"body.mass", 90, run(0.04, 10.8)},
                                                {"body.mass", 110, run(0.04, 11.6)}};
    const Summary summary = analyse({b, a}, std::move(runs), "/nonexistent", varied);
    REQUIRE(summary.validation.size() == 2);
    for (const ValidationRow& row : summary.validation) {
        CHECK(row.u_input.value() == Approx(0.2));
        CHECK(row.u_input_variant == "a");
        CHECK(row.assumed == std::vector<std::string>{"u_input"});
    }
}

TEST_CASE("A curve compared with one reference in two windows has two rows with values of their own",
          "[validation]") {
    AnalysisSpec spec = scene();
    spec.quantities.clear();
    std::vector<RunSummary> runs = sweep();
    for (const char* title : {"early", "late"}) {
        ComparisonSpec compared;
        compared.title = title;
        compared.quantity = "p";
        compared.reference = "gauge";
        spec.comparisons.push_back(compared);
        double size = compared.title == "early" ? 1 : 10;
        for (RunSummary& each : runs) {
            ComparisonResult result;
            result.title = title;
            result.quantity = "p";
            result.reference = "gauge";
            result.kind = ReferenceKind::experiment;
            result.features = {{"mean", 5 + size, 5}};
            each.comparisons.push_back(result);
            size /= 4;  // second order
        }
    }
    const std::vector<ValidationRow> rows = judged_rows(spec, runs, {{}, {}}).validation;
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].quantity == "early: mean");
    CHECK(rows[1].quantity == "late: mean");
    CHECK(rows[1].u_num.value() == Approx(10 * rows[0].u_num.value()));
}

TEST_CASE("Only the default variant is judged with fewer than three spacings", "[validation]") {
    std::vector<RunSummary> runs = {run(0.02, 11), run(0.02, 11, "b"), run(0.01, 11, "b")};
    const Summary summary = analysed(scene(), runs);
    REQUIRE(summary.validation.size() == 1);
    CHECK(summary.validation[0].variant == "a");
}

TEST_CASE("An uncertainty of the data by judgement counts and is named", "[validation]") {
    AnalysisSpec spec = scene();
    spec.quantities[0].assumed_reason = "by judgement";
    const ValidationRow row = analysed(spec, sweep()).validation.at(0);
    CHECK(row.u_data.value() == 0.1);
    CHECK(row.assumed == std::vector<std::string>{"u_data"});
}

TEST_CASE("Error measures, statements and other simulations are not validated against", "[validation]") {
    AnalysisSpec spec = scene();
    const ReferenceKind kind =
        GENERATE(ReferenceKind::stated, ReferenceKind::peer_simulation, ReferenceKind::analytic);
    spec.quantities[0].expected_kind = kind;
    CHECK(analysed(spec, sweep()).validation.empty());
    spec = scene();
    spec.quantities[0].metric = &metric_named("standard_deviation");
    CHECK(analysed(spec, sweep()).validation.empty());
}

TEST_CASE("Bias and scatter of predictions that are 10 % high and 20 % apart", "[statistics]") {
    const double s = 0.2;
    const auto points = std::vector{pair(1, 1.1 * std::exp(s), {}), pair(3, 3 * 1.1, {}),
                                    pair(2, 2 * 1.1 * std::exp(-s), {})};
    const ClassStatistics result = class_statistics(points).at(0);
    CHECK(result.count == 3);
    CHECK(result.bias.value() == Approx(1.1));
    CHECK(result.scatter.value() == Approx(s));
    CHECK_FALSE(result.sigma_data.has_value());
    CHECK_FALSE(result.sigma_model.has_value());
    // Student's t at 97.5 % with two degrees of freedom
    CHECK(result.bias_high.value() == Approx(1.1 * std::exp(4.30265 * s / std::sqrt(3))).epsilon(1e-5));
}

TEST_CASE("A known uncertainty of the data is taken out of the scatter", "[statistics]") {
    const double s = 0.2, data = 0.12;
    const auto points =
        std::vector{pair(1, std::exp(s), data), pair(3, 3, data), pair(2, 2 * std::exp(-s), data)};
    const ClassStatistics result = class_statistics(points).at(0);
    CHECK(result.sigma_data.value() == Approx(0.12));
    CHECK(result.sigma_model.value() == Approx(0.16));
    CHECK(result.bias.value() == Approx(std::exp(0.5 * (0.16 * 0.16 - 0.12 * 0.12))));
}

TEST_CASE("One point gives a bias and no scatter; a point that is not counted gives nothing",
          "[statistics]") {
    const ClassStatistics one = class_statistics({pair(2, 3, {})}).at(0);
    CHECK(one.bias.value() == Approx(1.5));
    CHECK_FALSE(one.scatter.has_value());
    ScatterPoint out = pair(2, 3, {});
    out.counted = false;
    CHECK(class_statistics({out}).empty());
}

TEST_CASE("Only the finest sound run of the default variant counts, in SI units", "[statistics]") {
    AnalysisSpec spec = scene();
    spec.quantities[0].y_scale = 100;
    auto runs = sweep();
    for (RunSummary& r : runs)
        for (double& p : r.record.series["p"].value) p *= 100;
    runs.push_back(run(0.005, 99, "b"));
    runs.push_back(run(0.002, 99));
    runs.back().record.status = RunStatus::unstable;
    const Summary summary = analysed(spec, runs);
    REQUIRE(summary.scatter.size() == 1);
    CHECK(summary.scatter[0].counted);
    CHECK(summary.scatter[0].quantity_class == "pressure");
    CHECK(summary.scatter[0].expected == Approx(1000));
    CHECK(summary.scatter[0].predicted == Approx(1103));
    CHECK(summary.scatter[0].u_data.value() == Approx(0.01));
    CHECK(summary.statistics.at(0).bias.value() == Approx(1.103));
}

TEST_CASE("Exact solutions have statistics of their own, from every variant, each value once",
          "[statistics]") {
    AnalysisSpec spec = scene();
    spec.quantities[0].expected_kind = ReferenceKind::analytic;
    spec.quantities[0].expected_uncertainty.reset();
    const std::vector<RunSummary> runs = {run(0.02, 12), run(0.01, 11), run(0.01, 13, "b")};
    Summary summary = analysed(spec, runs);
    REQUIRE(summary.scatter.size() == 2);
    CHECK(summary.scatter[0].variant == "a");
    CHECK(summary.scatter[1].dropped == "the variant 'a' stands for this value");
    REQUIRE(summary.statistics.size() == 1);
    CHECK(summary.statistics[0].against == ReferenceKind::analytic);
    CHECK(summary.statistics[0].bias.value() == Approx(1.1));
    CHECK(summary.statistics[0].sigma_data.value() == 0);

    AnalysisSpec other = spec;  // the same quantity, with another value for variant b
    spec.variant = "a";
    other.variant = "b";
    other.quantities[0].expected = 12;
    summary = analyse({spec, other}, runs, "/nonexistent", {});
    CHECK(summary.statistics.at(0).count == 2);
    CHECK(summary.statistics[0].bias.value() ==
          Approx(std::sqrt(1.1 * 13 / 12) * std::exp(0.5 * 0.5 * std::pow(std::log(1.1 * 12 / 13), 2))));
}

TEST_CASE("Measurements and exact solutions of one class are not mixed", "[statistics]") {
    ScatterPoint exact = pair(2, 2.2, 0);
    exact.kind = ReferenceKind::analytic;
    const auto rows = class_statistics({exact, pair(2, 3, {})});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].against == ReferenceKind::experiment);
    CHECK(rows[0].bias.value() == Approx(1.5));
    CHECK(rows[1].bias.value() == Approx(1.1));
}

TEST_CASE("Positions, velocities, angles and accelerations are motion", "[statistics]") {
    for (const char* const each : {"position", "velocity", "angle", "acceleration", "angular velocity"})
        CHECK(statistics_class(each) == "motion");
    CHECK(statistics_class("slope of force") == "force");
    CHECK(statistics_class("pressure") == "pressure");
    CHECK(statistics_class("time") == "time");
}

TEST_CASE("Two negative values count by their ratio", "[statistics]") {
    const auto points = std::vector{pair(-2, -2.2, {})};
    CHECK(class_statistics(points).at(0).bias.value() == Approx(1.1));
}

TEST_CASE("A pair that cannot count is dropped with the reason", "[statistics]") {
    AnalysisSpec spec = scene();
    const auto dropped = [&] { return analysed(spec, sweep()).scatter.at(0).dropped; };
    spec.quantities[0].expected_kind = ReferenceKind::peer_simulation;
    CHECK(dropped() == "another simulation, no measurement");
    spec.quantities[0].expected_kind = std::nullopt;
    CHECK(dropped() == "the scene does not say what kind the expected value is");
    spec.quantities[0].expected_kind = ReferenceKind::experiment;
    spec.quantities[0].expected = -1;
    CHECK(dropped() == "of another sign, or zero: no logarithm of the ratio");
    spec.quantities[0].expected = 0;
    CHECK(dropped() == "of another sign, or zero: no logarithm of the ratio");
}

TEST_CASE("The cheapest run within 5 and 10 percent is found, and the best", "[speed_error]") {
    AnalysisSpec spec = scene();
    const auto rows = analysed(spec, {run(0.04, 11.48), run(0.02, 10.8), run(0.01, 10.3), run(0.005, 10.1),
                                      run(0.02, 12, "b")})
                          .cheapest;
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].within_10->dx == 0.02);
    CHECK(rows[0].within_5->dx == 0.01);
    CHECK(rows[0].best->dx == 0.005);
    CHECK_FALSE(analysed(spec, {run(0.04, 15)}).cheapest.at(0).within_10.has_value());
}
