// SPDX-License-Identifier: BSD-3-Clause
// Scaling, cutting and interpolation of curves.
#include "validation/metrics/resample.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace wetdeck;

namespace {

RunRecord record_with(Series series) {
    RunRecord record;
    record.series["p"] = std::move(series);
    return record;
}

std::string problem_of(Series series) {
    return series_curve(record_with(std::move(series)), "p").problem;
}

}  // namespace

TEST_CASE("Linear interpolation meets the samples and the chords between them", "[resample]") {
    const Curve curve{{0, 1, 3}, {2, 4, 0}};
    CHECK(interpolate(curve, 0) == 2);
    CHECK(interpolate(curve, 1) == 4);
    CHECK(interpolate(curve, 0.25) == Approx(2.5));
    CHECK(interpolate(curve, 2.5) == Approx(1));
    CHECK(interpolate(curve, 3) == 0);
}

TEST_CASE("A clipped curve ends at the interpolated ends of the window", "[resample]") {
    const Curve part = clip({{0, 1, 2, 3}, {0, 10, 20, 30}}, {0.5, 2});
    CHECK(part.x == std::vector<double>{0.5, 1, 2});
    CHECK(part.y == std::vector<double>{5, 10, 20});
    CHECK(clip({{0, 1}, {0, 1}}, {2, 3}).x.empty());
}

TEST_CASE("A window counts as covered from 98 percent on", "[resample]") {
    CHECK(covers({{0, 9.81}, {0, 0}}, {0, 10}));
    CHECK_FALSE(covers({{0, 9.79}, {0, 0}}, {0, 10}));
    CHECK_FALSE(covers({{0.21, 12}, {0, 0}}, {0, 10}));
    CHECK_FALSE(covers({{11, 12}, {0, 0}}, {0, 10}));
}

TEST_CASE("The root mean square difference takes 2000 instants with both ends", "[resample]") {
    // Against zero, y = x on [0, 1] at n equidistant instants gives the square root of (2n - 1)/(6(n - 1)).
    const Curve line{{0, 1}, {0, 1}};
    const Curve zero{{0, 1}, {0, 0}};
    CHECK(rms_difference(line, zero, {0, 1}) == Approx(std::sqrt(3999.0 / (6 * 1999.0))).epsilon(1e-13));
    CHECK(rms_difference(line, line, {0, 1}) == 0);
}

TEST_CASE("A series is scaled and its offset taken off after scaling", "[resample]") {
    const auto result =
        series_curve(record_with({"Pa", "", {0, 2}, {100, 300}, {}}), "p", {0, 2, 100, 0.5, {}});
    CHECK(result.problem.empty());
    CHECK(result.curve.x == std::vector<double>{0, 1});
    CHECK(result.curve.y == std::vector<double>{0.5, 2.5});
}

TEST_CASE("A series that is not sound is named as such", "[resample]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(series_curve(RunRecord{}, "p").problem == "the run has no series 'p'");
    CHECK(problem_of({}) == "series 'p' is empty");
    CHECK(problem_of({"Pa", "", {0, 1}, {1}, {}}) == "series 'p' has 2 times and 1 values");
    CHECK(problem_of({"Pa", "", {0}, {1, 2}, {0, 1}}) == "series 'p' has several columns");
    CHECK(problem_of({"Pa", "", {0, 1}, {1, nan}, {}}) == "series 'p' is not finite at sample 1, t = 1 s");
    CHECK(problem_of({"Pa", "", {0, 1}, {infinity, 0}, {}}) ==
          "series 'p' is not finite at sample 0, t = 0 s");
    CHECK(problem_of({"Pa", "", {0, 1, 1}, {1, 2, 3}, {}}) ==
          "the time of series 'p' does not increase at sample 2, t = 1 s");
}

TEST_CASE("the row of a profile nearest to an instant becomes a curve over its abscissa") {
    const RunRecord record =
        record_with({"Pa", "", {0, 1, 2}, {1, 2, 3, 10, 20, 30, 100, 200, 300}, {0.1, 0.2, 0.3}});
    const auto result = series_curve(record, "p", {0.1, 0.1, 10, 0, 1.4});
    REQUIRE(result.problem.empty());
    CHECK(result.curve.x[2] == Approx(2));
    CHECK(result.curve.y == std::vector<double>{1, 2, 3});
    CHECK_THAT(series_curve(record, "p").problem, Catch::Contains("several columns"));
    CHECK_THAT(series_curve(record, "p", {0, 1, 1, 0, 2.5}).problem, Catch::Contains("spans 0 to 2 s"));
}

TEST_CASE("a profile averaged over an interval has the means of its columns", "[resample]") {
    // columns t and 10 - 2 t^2 at 0, 1, 2, 3, as linear pieces
    const RunRecord record = record_with({"Pa", "", {0, 1, 2, 3}, {0, 10, 1, 8, 2, 2, 3, -8}, {0.1, 0.2}});
    struct Row {
        double begin, interval, first, second;
    };
    for (const Row& row : std::vector<Row>{{0, 1, 0.5, 9},
                                           {0, 2, 1, 7},
                                           {0, 3, 1.5, 11.0 / 3},
                                           {1, 1, 1.5, 5},
                                           {1, 2, 2, 1},
                                           {2, 1, 2.5, -3},
                                           {0.5, 0.5, 0.75, 8.5},
                                           {0.5, 1, 1, 7.5},
                                           {1.5, 1, 2, 1.5},
                                           {2.5, 0.5, 2.75, -5.5}}) {
        SeriesScaling scaling{0, 1, 1, 0, row.begin};
        scaling.interval = row.interval;
        const auto result = series_curve(record, "p", scaling);
        CAPTURE(row.begin, row.interval);
        REQUIRE(result.problem.empty());
        CHECK(result.curve.x == std::vector<double>{0.1, 0.2});
        CHECK(result.curve.y[0] == Approx(row.first));
        CHECK(result.curve.y[1] == Approx(row.second));
    }
    SeriesScaling late{0, 1, 1, 0, 2.5};
    late.interval = 1;
    CHECK(series_curve(record, "p", late).problem == "series 'p' spans 0 to 3 s, not 3.5");
}
