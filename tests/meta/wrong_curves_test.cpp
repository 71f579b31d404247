// SPDX-License-Identifier: BSD-3-Clause
// Tests of the tests: the comparison is fed the measured curve itself and then spoilt copies of it. Each copy
// must fail; a comparison that lets one pass would let a wrong solver pass.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "validation/metrics/compare.hpp"
#include "validation/metrics/quantities.hpp"

using namespace wetdeck;

namespace {

const std::filesystem::path folder =
    std::filesystem::path(WETDECK_SOURCE_DIR) / "reference_data" / "dam_break";
constexpr double second_per_T = 0.247308;  // sqrt(h/g) of the 0.6 m column
constexpr double pressure_scale = 5886;    // rho g h [Pa]

/// What a run that hits the second reading of Buchner exactly would have recorded.
RunRecord perfect_run() {
    const Curve buchner =
        column_curve(load_reference(folder / "buchner2002_pressure_digit2.csv"), "T", "p_star");
    Series gauge;
    for (std::size_t i = 0; i < buchner.x.size(); ++i) {
        gauge.time.push_back(second_per_T * buchner.x[i]);
        gauge.value.push_back(pressure_scale * buchner.y[i]);
    }
    RunRecord record;
    record.series["pressure_gauge"] = std::move(gauge);
    return record;
}

ComparisonSpec comparison() {
    ComparisonSpec spec;
    spec.quantity = "pressure_gauge";
    spec.reference = "buchner2002_pressure_digit2";
    spec.x_column = "T";
    spec.y_column = "p_star";
    spec.x_scale = second_per_T;
    spec.y_scale = pressure_scale;
    spec.window = Window{2.4, 6.5};
    spec.tolerance = 0.1;
    return spec;
}

ComparisonResult judge(const RunRecord& record, const ComparisonSpec& spec = comparison()) {
    ReferenceShelf shelf(folder);
    return compare(spec, record, shelf);
}

Series& gauge_of(RunRecord& record) {
    return record.series["pressure_gauge"];
}

}  // namespace

TEST_CASE("The measured curve itself passes with no error", "[meta]") {
    const ComparisonResult result = judge(perfect_run());
    CHECK(result.within);
    CHECK(result.nrmse.value() == Approx(0).margin(1e-12));
    CHECK(result.peak_error.value() == Approx(0).margin(1e-12));
    CHECK(result.time_error.value() == Approx(0).margin(1e-12));
}

TEST_CASE("The other reading of the same experiment passes", "[meta]") {
    ComparisonSpec spec = comparison();
    spec.reference = "buchner2002_pressure_digit1";
    CHECK(judge(perfect_run(), spec).within);
}

TEST_CASE("A curve shifted in time fails with its shift as time error", "[meta]") {
    const double shift = GENERATE(-0.3, 0.3);
    RunRecord record = perfect_run();
    for (double& t : gauge_of(record).time) t += shift * second_per_T;
    const ComparisonResult result = judge(record);
    CHECK_FALSE(result.within);
    CHECK(result.time_error.value() == Approx(shift));
}

TEST_CASE("A curve scaled in height fails with its factor as peak error", "[meta]") {
    const double factor = GENERATE(0.6, 1.5);
    RunRecord record = perfect_run();
    for (double& p : gauge_of(record).value) p *= factor;
    const ComparisonResult result = judge(record);
    CHECK_FALSE(result.within);
    CHECK(result.peak_error.value() == Approx(factor - 1));
}

TEST_CASE("A curve of the wrong sign or of nothing at all fails", "[meta]") {
    const double factor = GENERATE(-1.0, 0.0);
    RunRecord record = perfect_run();
    for (double& p : gauge_of(record).value) p *= factor;
    CHECK_FALSE(judge(record).within);
}

TEST_CASE("A curve raised by a hydrostatic offset fails", "[meta]") {
    RunRecord record = perfect_run();
    for (double& p : gauge_of(record).value) p += 0.15 * pressure_scale;
    CHECK_FALSE(judge(record).within);
}

TEST_CASE("A series in the wrong unit fails", "[meta]") {
    RunRecord record = perfect_run();
    SECTION("kPa for Pa") {
        for (double& p : gauge_of(record).value) p /= 1000;
    }
    SECTION("ms for s") {
        for (double& t : gauge_of(record).time) t *= 1000;
    }
    SECTION("scaled values for Pa") {
        for (double& p : gauge_of(record).value) p /= pressure_scale;
    }
    CHECK_FALSE(judge(record).within);
}

TEST_CASE("A curve cut off before the end of the window gets no number", "[meta]") {
    RunRecord record = perfect_run();
    const auto kept =
        std::lower_bound(gauge_of(record).time.begin(), gauge_of(record).time.end(), 6.0 * second_per_T) -
        gauge_of(record).time.begin();
    gauge_of(record).time.resize(static_cast<std::size_t>(kept));
    gauge_of(record).value.resize(static_cast<std::size_t>(kept));
    const ComparisonResult result = judge(record);
    CHECK_FALSE(result.within);
    CHECK_FALSE(result.nrmse.has_value());
    CHECK_THAT(result.note, Catch::StartsWith("the series spans"));
}

TEST_CASE("A run that stopped early gets no number from a comparison without a window", "[meta]") {
    RunRecord record = perfect_run();
    record.status = RunStatus::unstable;
    ComparisonSpec spec = comparison();
    spec.window.reset();
    CHECK_FALSE(judge(record, spec).within);
    CHECK_FALSE(judge(record, spec).nrmse.has_value());
}

TEST_CASE("A curve that runs backwards in time gets no number", "[meta]") {
    RunRecord record = perfect_run();
    std::reverse(gauge_of(record).time.begin(), gauge_of(record).time.end());
    std::reverse(gauge_of(record).value.begin(), gauge_of(record).value.end());
    const ComparisonResult result = judge(record);
    CHECK_FALSE(result.within);
    CHECK_FALSE(result.nrmse.has_value());
    CHECK_THAT(result.note, Catch::Contains("does not increase"));
}

TEST_CASE("A curve whose values are in reverse order fails", "[meta]") {
    RunRecord record = perfect_run();
    std::reverse(gauge_of(record).value.begin(), gauge_of(record).value.end());
    CHECK_FALSE(judge(record).within);
}

TEST_CASE("A single value that is not finite takes the number away, wherever it is", "[meta]") {
    const std::size_t place = GENERATE(0u, 40u, 97u);
    const double poison =
        GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
    RunRecord record = perfect_run();
    gauge_of(record).value[place] = poison;
    const ComparisonResult result = judge(record);
    CHECK_FALSE(result.within);
    CHECK_FALSE(result.nrmse.has_value());
    CHECK_FALSE(result.peak_error.has_value());
    for (const double y : result.simulated.y) CHECK(std::isfinite(y));
}

TEST_CASE("The right curve under the name of another gauge fails", "[meta]") {
    ComparisonSpec spec = comparison();
    spec.reference = "buchner2002_pressure_upper_digit2";
    spec.window = Window{3.2, 6.5};
    CHECK_FALSE(judge(perfect_run(), spec).within);
}

TEST_CASE("A run without the series fails", "[meta]") {
    const ComparisonResult result = judge(RunRecord{});
    CHECK_FALSE(result.within);
    CHECK(result.note == "the run has no series 'pressure_gauge'");
}

TEST_CASE("A frozen gauge fails although its mean is right", "[meta]") {
    RunRecord record = perfect_run();
    for (double& p : gauge_of(record).value) p = 0.54 * pressure_scale;
    CHECK_FALSE(judge(record).within);
}
