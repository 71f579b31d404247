// SPDX-License-Identifier: BSD-3-Clause
// Values at several sound speeds and spacings, made up with known limits.
#include "validation/metrics/sound_speed.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "validation/metrics/analysis.hpp"

using namespace wetdeck;

namespace {

constexpr double limit = 14, of_sound = -400, of_spacing = 3000;

double made_up(double sound_speed, double dx) {
    return limit + of_sound / (sound_speed * sound_speed) + of_spacing * dx * dx;
}

AnalysisSpec scene() {
    AnalysisSpec spec;
    spec.scene = "tank";
    spec.default_variant = "a";
    spec.sound_speed = 20;
    spec.sound_speed_variants = {"a"};
    QuantitySpec peak;
    peak.name = "peak";
    peak.metric = &metric_named("maximum");
    peak.series = "p";
    peak.expected = 14.5;
    peak.tolerance = 1;
    spec.quantities = {peak};
    return spec;
}

RunSummary run(double dx, double top) {
    RunSummary r;
    r.record.scene = "tank";
    r.record.variant = "a";
    r.record.particle_spacing = dx;
    r.record.series["p"] = {"Pa", "", {0, 1, 2}, {0, top, 0}, {}};
    return r;
}

std::vector<RunSummary> sweep() {
    return {run(0.04, made_up(20, 0.04)), run(0.02, made_up(20, 0.02)), run(0.01, made_up(20, 0.01))};
}

std::vector<SensitivityRun> study(double dx = 0.04) {
    return {{sound_speed_key, 10, run(dx, made_up(10, dx))}, {sound_speed_key, 40, run(dx, made_up(40, dx))}};
}

std::vector<SoundSpeedRow> rows_of(std::vector<RunSummary> runs, std::vector<SensitivityRun> varied) {
    return analyse({scene()}, std::move(runs), "/nonexistent", std::move(varied)).sound_speed;
}

}  // namespace

TEST_CASE("a line in 1/c^2 gives the value of incompressible water and the scatter about it") {
    const SoundSpeedFit exact =
        fit_sound_speed({{10, 3 + 5 / 100.}, {20, 3 + 5 / 400.}, {40, 3 + 5 / 1600.}});
    CHECK(exact.limit == Approx(3));
    CHECK(exact.coefficient == Approx(5));
    CHECK(exact.u_limit < 1e-12);
    const SoundSpeedFit scattered = fit_sound_speed({{10, 3.06}, {20, 3.0}, {40, 3.01}});
    CHECK(scattered.u_limit > 0.001);
    CHECK_THROWS_AS(fit_sound_speed({{10, 3}, {20, 4}}), std::invalid_argument);
}

TEST_CASE("the parts of sound speed and spacing stand apart and leave the limit of both") {
    const std::vector<SoundSpeedRow> rows = rows_of(sweep(), study());
    REQUIRE(rows.size() == 1);
    const SoundSpeedRow& row = rows[0];
    CHECK(row.quantity == "peak");
    CHECK(row.sound_speed == std::vector<double>{10, 20, 40});
    CHECK(row.sound_part == Approx(of_sound / 400));
    CHECK(row.finest_dx == 0.01);
    CHECK(row.spacing_part.value() == Approx(of_spacing * 1e-4));
    CHECK(row.limit == Approx(limit));
    CHECK(row.u_limit.value() == Approx(row.u_num.value()));  // no scatter about the line
    CHECK(row.expected == 14.5);
}

TEST_CASE("without convergence the part of the spacing is unknown and stays in the limit") {
    std::vector<RunSummary> runs = sweep();
    runs[1] = run(0.02, 30);
    const std::vector<SoundSpeedRow> rows = rows_of(runs, study());
    REQUIRE(rows.size() == 1);
    CHECK_FALSE(rows[0].spacing_part.has_value());
    CHECK(rows[0].limit == Approx(made_up(20, 0.01) - of_sound / 400));
    CHECK(rows[0].u_limit.value() > 10);
    // two spacings: no uncertainty of the spacing
    CHECK_FALSE(rows_of({sweep()[0], sweep()[2]}, study())[0].u_limit.has_value());
}

TEST_CASE("a study that lacks a run, or is of another spacing or set-up, gives no row") {
    std::vector<SensitivityRun> one = study();
    one.pop_back();
    CHECK(rows_of(sweep(), one).empty());
    CHECK(rows_of(sweep(), study(0.05)).empty());
    std::vector<SensitivityRun> unstable = study();
    unstable[0].run.record.status = RunStatus::unstable;
    CHECK(rows_of(sweep(), unstable).empty());
    std::vector<SensitivityRun> other = study();
    other[0].key = "water.density";
    CHECK(rows_of(sweep(), other).empty());
    CHECK(rows_of({sweep()[1], sweep()[2]}, study()).empty());
}

TEST_CASE("an input that is varied for its uncertainty is no study of the sound speed") {
    AnalysisSpec spec = scene();
    spec.sound_speed_variants.clear();
    CHECK(analyse({spec}, sweep(), "/nonexistent", study()).sound_speed.empty());
}
