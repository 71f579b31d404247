// SPDX-License-Identifier: BSD-3-Clause
// Variants beside each other: which runs, and on which axes.
#include <catch2/catch.hpp>

#include "reports/figures/figures.hpp"

using namespace wetdeck;
using namespace wetdeck::report;

namespace {

RunSummary run(const std::string& variant, double dx) {
    RunSummary summary;
    summary.record.scene = "tank";
    summary.record.variant = variant;
    summary.record.particle_spacing = dx;
    summary.record.series["force"] = {"N/m", "of the water", {0, 1, 2}, {0, 3000, 1000}, {}};
    return summary;
}

Runs pointers(const std::vector<RunSummary>& runs) {
    Runs out;
    for (const RunSummary& one : runs) out.push_back(&one);
    return out;
}

const SideBySide with_and_without{"With and without air", {"with", "without"}, {}, "force"};

}  // namespace

TEST_CASE("Variants stand beside each other at the finest spacing that all have", "[report]") {
    const std::vector<RunSummary> runs{run("with", 0.04), run("with", 0.02), run("with", 0.01),
                                       run("without", 0.04), run("without", 0.02)};
    const Runs chosen = side_by_side_runs(pointers(runs), with_and_without);
    REQUIRE(chosen.size() == 2);
    CHECK(chosen[0] == &runs[1]);
    CHECK(chosen[1] == &runs[4]);
    const std::vector<RunSummary> apart{run("with", 0.01), run("without", 0.02)};
    const Runs each = side_by_side_runs(pointers(apart), with_and_without);
    REQUIRE(each.size() == 2);
    CHECK(each[0] == &apart[0]);
}

TEST_CASE("Series beside each other have the scales of their comparison and the clock of the run",
          "[report]") {
    AnalysisSpec scene;
    scene.scene = "tank";
    const std::vector<RunSummary> runs{run("with", 0.02), run("without", 0.02)};
    CHECK(side_by_side_figure(scene, with_and_without, pointers(runs)).y.unit == "N/m");

    ComparisonSpec compared;
    compared.quantity = "force";
    compared.x_scale = 0.001;
    compared.y_scale = 1000;
    compared.x_label = "time [ms]";
    compared.y_label = "force [kN/m]";
    scene.comparisons.push_back(compared);
    const Figure scaled = side_by_side_figure(scene, with_and_without, pointers(runs));
    REQUIRE(scaled.series.size() == 2);
    CHECK(scaled.name == "tank-with-and-without-air-curves");
    CHECK(scaled.series[1].data.x.back() == Approx(2000));
    CHECK(scaled.series[1].data.y[1] == Approx(3));
    CHECK(axis_title(scaled.x) == "time [ms]");

    scene.comparisons.front().origin = "contact";  // of one variant alone
    scene.comparisons.front().x_offset = 0.5;
    const Figure own_clock = side_by_side_figure(scene, with_and_without, pointers(runs));
    CHECK(own_clock.series[0].data.x.back() == Approx(2));
    CHECK(axis_title(own_clock.x) == "time [s]");
    CHECK(axis_title(own_clock.y) == "force [kN/m]");
}
