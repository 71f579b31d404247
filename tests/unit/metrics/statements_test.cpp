// SPDX-License-Identifier: BSD-3-Clause
// Statements of a source: which runs judge them, and each measure on known numbers.
#include "validation/metrics/statements.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "validation/metrics/summary.hpp"

using namespace wetdeck;
using Measure = SourceStatement::Measure;

namespace {

/// A run with one quantity, and a series that is `factor` times a parabola.
RunSummary run(const std::string& variant, double dx, double peak, double factor = 1) {
    RunSummary summary;
    summary.record.scene = "tank";
    summary.record.variant = variant;
    summary.record.particle_spacing = dx;
    Series series{"N/m", "", {}, {}, {}};
    for (int k = 0; k <= 200; ++k) {
        const double t = 0.01 * k;
        series.time.push_back(t);
        series.value.push_back(factor * t * (2 - t));
    }
    summary.record.series["force"] = series;
    QuantityResult quantity;
    quantity.name = "peak";
    quantity.unit = "N/m";
    quantity.value = peak;
    summary.quantities.push_back(quantity);
    return summary;
}

AnalysisSpec scene_with(const SourceStatement& statement) {
    AnalysisSpec scene;
    scene.scene = "tank";
    scene.statements.push_back(statement);
    return scene;
}

SourceStatement air_matters(Measure measure) {
    SourceStatement s;
    s.says = "air matters";
    s.variants = {"with"};
    s.against = {"without"};
    s.measure = measure;
    s.quantity = s.against_quantity = measure == Measure::curve_difference ? "force" : "peak";
    s.low = -std::numeric_limits<double>::infinity();
    s.high = 0.5;
    return s;
}

}  // namespace

TEST_CASE("A statement is judged at the finest spacing that both variants have", "[statements]") {
    const std::vector<RunSummary> runs{run("with", 0.04, 10), run("with", 0.02, 12), run("with", 0.01, 13),
                                       run("without", 0.04, 30), run("without", 0.02, 48)};
    const auto ratio = judge_statements(scene_with(air_matters(Measure::ratio)), runs);
    REQUIRE(ratio.size() == 1);
    CHECK(ratio[0].dx == 0.02);
    CHECK(ratio[0].value == Approx(12.0 / 48));
    CHECK(ratio[0].unit == "-");
    CHECK(ratio[0].holds() == true);
    const auto difference = judge_statements(scene_with(air_matters(Measure::difference)), runs);
    CHECK(difference[0].value == Approx(-36));
    CHECK(difference[0].unit == "N/m");
}

TEST_CASE("The difference of curves is their rms over the range of the second", "[statements]") {
    SourceStatement statement = air_matters(Measure::curve_difference);
    statement.window = Window{0, 2};
    const auto results =
        judge_statements(scene_with(statement), {run("with", 0.02, 1, 3), run("without", 0.02, 1)});
    // A - B = 2 t (2 - t); mean of t^2 (2 - t)^2 over [0, 2] is 8/15; B spans [0, 1]
    REQUIRE(results.size() == 1);
    CHECK(*results[0].value == Approx(2 * std::sqrt(8.0 / 15)).epsilon(1e-3));
    CHECK(results[0].holds() == false);
    statement.window = Window{0, 3};
    CHECK(judge_statements(scene_with(statement), {run("with", 0.02, 1), run("without", 0.02, 1)})[0].note ==
          "a series does not cover the window");
}

TEST_CASE("What cannot be judged says why", "[statements]") {
    const AnalysisSpec scene = scene_with(air_matters(Measure::ratio));
    const auto note = [&](const std::vector<RunSummary>& runs) {
        const auto results = judge_statements(scene, runs);
        REQUIRE(results.size() == 1);
        CHECK_FALSE(results[0].holds());
        return results[0].note;
    };
    CHECK(note({}) == "no spacing that both variants were run at");
    CHECK(note({run("with", 0.02, 1), run("without", 0.01, 1)}) ==
          "no spacing that both variants were run at");
    CHECK(note({run("with", 0.02, 1), run("without", 0.02, 0)}) == "peak is zero");
    RunSummary unstable = run("without", 0.02, 1);
    unstable.record.status = RunStatus::unstable;
    CHECK(note({run("with", 0.02, 1), unstable}) == "no spacing that both variants were run at");
    RunSummary empty = run("without", 0.02, 1);
    empty.quantities.front().value.reset();
    CHECK(note({run("with", 0.02, 1), empty}) == "no value of peak");
}

TEST_CASE("Two quantities of one run are related", "[statements]") {
    SourceStatement statement = air_matters(Measure::difference);
    statement.against.clear();
    statement.against_quantity = "trough";
    RunSummary one = run("with", 0.02, 5);
    one.quantities.push_back(one.quantities.front());
    one.quantities.back().name = "trough";
    one.quantities.back().value = 4.75;
    const auto results = judge_statements(scene_with(statement), {one});
    REQUIRE(results.size() == 1);
    CHECK(results[0].against == "trough");
    CHECK(*results[0].value == Approx(0.25));
}

TEST_CASE("A value that the source states is a statement of every variant that has it", "[statements]") {
    AnalysisSpec scene;
    scene.scene = "tank";
    QuantitySpec spec;
    spec.name = "peak";
    spec.expected_kind = ReferenceKind::stated;
    scene.quantities.push_back(spec);
    std::vector<RunSummary> runs{run("with", 0.04, 10), run("with", 0.02, 12), run("without", 0.04, 30)};
    for (RunSummary& one : runs) {
        one.quantities.front().expected = 11;
        one.quantities.front().tolerance = 1.5;
        one.quantities.front().expected_source = "stated in the text";
    }
    const auto results = judge_statements(scene, runs);
    REQUIRE(results.size() == 2);
    CHECK(results[0].variant == "with");
    CHECK(results[0].dx == 0.02);
    CHECK(results[0].holds() == true);
    CHECK(results[1].holds() == false);
    CHECK(results[1].says == "stated in the text");
}
