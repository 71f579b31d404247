// SPDX-License-Identifier: BSD-3-Clause
// Quantities of interest of made-up series with known answers.
#include "validation/metrics/quantities.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "solver/core/errors.hpp"

using namespace wetdeck;

namespace {

/// A run with one series "p" = f(t), t = 0 to 10 s, unevenly sampled.
template <typename Function>
RunRecord run_with(Function f, double end = 10) {
    RunRecord record;
    Series series;
    for (int i = 0; i <= 4000; ++i) {
        const double t = end * std::pow(i / 4000.0, 1.2);
        series.time.push_back(t);
        series.value.push_back(f(t));
    }
    record.series["p"] = std::move(series);
    return record;
}

QuantitySpec spec_of(const std::string& metric) {
    QuantitySpec spec;
    spec.name = "q";
    spec.metric = &metric_named(metric);
    spec.series = "p";
    return spec;
}

QuantityResult evaluate(const QuantitySpec& spec, const RunRecord& record) {
    ReferenceShelf shelf(std::filesystem::path(WETDECK_SOURCE_DIR) / "reference_data" / "dam_break");
    return evaluate_quantity(spec, record, shelf);
}

double line(double t) {
    return 3 * t + 1;
}
double wave(double t) {
    return std::sin(t);
}

}  // namespace

TEST_CASE("Each metric gives the known number of a made-up series", "[quantities]") {
    const auto [metric, expected] =
        GENERATE(table<std::string, double>({{"mean", 13},
                                             {"standard_deviation", 3 * 4 / std::sqrt(12.0)},
                                             {"maximum", 19},
                                             {"time_of_maximum", 6},
                                             {"minimum", 7},
                                             {"slope", 3}}));
    QuantitySpec spec = spec_of(metric);
    spec.window = Window{2, 6};
    CHECK(evaluate(spec, run_with(line)).value.value() == Approx(expected).epsilon(1e-5));
}

TEST_CASE("A proportion is the slope of the best line through the origin", "[quantities]") {
    RunRecord record;
    record.series["p"] = {"-", "", {1, 2, 3}, {1, 3, 2}, {}};
    CHECK(evaluate(spec_of("proportion"), record).value.value() == Approx((1 + 6 + 6) / 14.0));
}

TEST_CASE("Uneven sampling does not weigh in a mean", "[quantities]") {
    RunRecord record;
    record.series["p"] = {"-", "", {0, 0.001, 0.002, 0.003, 1, 2}, {1, 1, 1, 1, 1, 3}, {}};
    CHECK(evaluate(spec_of("mean"), record).value.value() == Approx(1.5));
}

TEST_CASE("Time and value are scaled before the window is applied", "[quantities]") {
    QuantitySpec spec = spec_of("slope");
    spec.x_scale = 2;
    spec.y_scale = 3;
    spec.window = Window{1, 4};  // 2 s to 8 s
    CHECK(evaluate(spec, run_with(line)).value.value() == Approx(2));
}

TEST_CASE("The first peak is integrated up to where it has fallen to its share", "[quantities]") {
    // a triangle of height 2 about t = 2, and a second, lower one about t = 6
    const auto peaks = [](double t) { return std::max({0.0, 2 - std::abs(t - 2), 1 - std::abs(t - 6)}); };
    QuantitySpec spec = spec_of("first_peak_integral");
    spec.threshold = 0.5;  // at t = 3
    CHECK(evaluate(spec, run_with(peaks)).value.value() == Approx(2 + 1.5).epsilon(1e-4));
    spec.threshold = -0.1;
    const QuantityResult none = evaluate(spec, run_with(peaks));
    CHECK_FALSE(none.value);
    CHECK_THAT(none.note, Catch::Contains("does not fall to -0.1 of its peak"));
}

TEST_CASE("The first crossing is upward, interpolated and inside the window", "[quantities]") {
    QuantitySpec spec = spec_of("first_crossing");
    spec.threshold = 0.5;
    CHECK(evaluate(spec, run_with(wave)).value.value() == Approx(M_PI / 6).epsilon(1e-5));
    CHECK(evaluate(spec, run_with(wave)).note.empty());
    spec.window = Window{1, 10};  // starts above the threshold: the next rise counts
    CHECK(evaluate(spec, run_with(wave)).value.value() == Approx(2 * M_PI + M_PI / 6).epsilon(1e-5));
    CHECK(evaluate(spec, run_with(wave)).note == "starts above 0.5, and falls through it before it rises");
}

TEST_CASE("A threshold that is never reached leaves the quantity empty", "[quantities]") {
    QuantitySpec spec = spec_of("first_crossing");
    spec.threshold = 1.5;
    const QuantityResult result = evaluate(spec, run_with(wave));
    CHECK_FALSE(result.value.has_value());
    CHECK(result.note == "does not rise through 1.5");
}

TEST_CASE("The value at an instant is interpolated and empty outside the series", "[quantities]") {
    QuantitySpec spec = spec_of("value_at");
    spec.threshold = 4.2;
    CHECK(evaluate(spec, run_with(line)).value.value() == Approx(13.6));
    spec.threshold = 10.5;
    CHECK(evaluate(spec, run_with(line)).note == "the series spans 0 to 10, not 10.5");
}

TEST_CASE("The distance to a reference is raw and known for a shifted copy of it", "[quantities]") {
    const Curve buchner =
        column_curve(load_reference(std::filesystem::path(WETDECK_SOURCE_DIR) /
                                    "reference_data/dam_break/buchner2002_pressure_digit2.csv"),
                     "T", "p_star");
    RunRecord record;
    record.series["p"] = {"Pa", "", buchner.x, buchner.y, {}};
    for (double& t : record.series["p"].time) t *= 0.25;
    for (double& p : record.series["p"].value) p = 5886 * (p + 0.1);
    QuantitySpec spec = spec_of("rms_difference");
    spec.reference = "buchner2002_pressure_digit2";
    spec.y_column = "p_star";
    spec.x_scale = 0.25;
    spec.y_scale = 5886;
    spec.window = Window{2.4, 5.3};
    CHECK(evaluate(spec, record).value.value() == Approx(0.1).epsilon(1e-9));
}

TEST_CASE("A quantity against a reference that is not there is empty and says so", "[quantities]") {
    QuantitySpec spec = spec_of("rms_difference");
    spec.reference = "buchner2002_front";
    spec.y_column = "x_over_h";
    spec.window = Window{1, 2};
    const QuantityResult result = evaluate(spec, run_with(wave));
    CHECK_FALSE(result.value.has_value());
    CHECK(result.note == "curve not available: no file buchner2002_front.csv");
}

TEST_CASE("A run that ends inside the window has no value for it", "[quantities]") {
    const std::string metric = GENERATE("mean", "standard_deviation", "maximum", "time_of_maximum", "minimum",
                                        "slope", "rms_difference");
    QuantitySpec spec = spec_of(metric);
    spec.window = Window{2.4, 5.3};
    spec.reference = "buchner2002_pressure_digit2";
    spec.y_column = "p_star";
    const QuantityResult result = evaluate(spec, run_with(wave, 5.2));
    CHECK_FALSE(result.value.has_value());
    CHECK(result.note == "the series spans 0 to 5.2, the window 2.4 to 5.3");
}

TEST_CASE("A series with a NaN gives no number for any metric", "[quantities]") {
    const std::string metric = GENERATE("mean", "standard_deviation", "maximum", "time_of_maximum", "minimum",
                                        "slope", "first_crossing", "value_at", "rms_difference");
    RunRecord record = run_with(wave);
    record.series["p"].value[3990] = std::numeric_limits<double>::quiet_NaN();
    QuantitySpec spec = spec_of(metric);
    spec.threshold = 0.5;
    spec.window = Window{0, 5};
    spec.reference = "buchner2002_pressure_digit2";
    spec.y_column = "p_star";
    const QuantityResult result = evaluate(spec, record);
    CHECK_FALSE(result.value.has_value());
    CHECK_THAT(result.note, Catch::Contains("not finite at sample 3990"));
}

TEST_CASE("A quantity is judged only where something is expected and was computed", "[quantities]") {
    QuantitySpec spec = spec_of("maximum");
    CHECK_FALSE(evaluate(spec, run_with(line)).within.has_value());
    spec.expected = 30;
    spec.tolerance = 1;
    CHECK(evaluate(spec, run_with(line)).within == true);
    spec.expected = 32.5;
    CHECK(evaluate(spec, run_with(line)).within == false);
    spec.window = Window{0, 20};
    CHECK_FALSE(evaluate(spec, run_with(line)).within.has_value());
}

TEST_CASE("An unknown metric is refused", "[quantities]") {
    CHECK_THROWS_WITH(metric_named("median"),
                      Catch::StartsWith("unknown metric 'median', expected one of mean, "));
    CHECK_THROWS_AS(metric_named("median"), InputError);
    QuantitySpec spec = spec_of("mean");
    spec.metric = nullptr;
    CHECK_THROWS_WITH(evaluate(spec, run_with(line)), "quantity 'q' has no metric");
}

TEST_CASE("A metric without the key it needs is refused", "[quantities]") {
    CHECK_THROWS_WITH(evaluate(spec_of("first_crossing"), run_with(line)),
                      "quantity 'q': metric first_crossing needs 'threshold'");
    CHECK_THROWS_WITH(evaluate(spec_of("value_at"), run_with(line)),
                      "quantity 'q': metric value_at needs 'threshold'");
    QuantitySpec spec = spec_of("rms_difference");
    CHECK_THROWS_WITH(evaluate(spec, run_with(line)),
                      "quantity 'q': metric rms_difference needs 'reference'");
    spec.reference = "buchner2002_pressure_digit2";
    CHECK_THROWS_WITH(evaluate(spec, run_with(line)), "quantity 'q': metric rms_difference needs 'y_column'");
    spec.y_column = "p_star";
    CHECK_THROWS_WITH(evaluate(spec, run_with(line)), "quantity 'q': metric rms_difference needs 'window'");
}
