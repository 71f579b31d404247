// SPDX-License-Identifier: BSD-3-Clause
// The first page: one line a scene, what to look at next, and nothing red that is expected.
#include <catch2/catch.hpp>

#include "reports/page/thumbnail.hpp"
#include "reports/parts/outcomes.hpp"
#include "tests/unit/report/report_samples.hpp"
#include "validation/metrics/verdict.hpp"

using namespace wetdeck;
using samples::between;
using samples::contains;

namespace {

std::string first_page(const Summary& summary) {
    return samples::pages_of(summary).at("index.html");
}

std::string outcomes_in(const std::string& page) {
    return between(page, "<div class=\"table compact stacked outcomes", "</table>");
}

QuantitySpec peak_of(const std::string& series) {
    QuantitySpec spec;
    spec.name = "peak";
    spec.metric = &metric_named("maximum");
    spec.series = series;
    return spec;
}

ValidationRow judged(const std::string& quantity, ReferenceKind kind, double error, double u_grid) {
    ValidationRow row;
    row.scene = "tank";
    row.variant = "two-phase";
    row.quantity = quantity;
    row.kind = kind;
    row.against = "somebody (1999)";
    row.unit = "Pa";
    row.reference = 100;
    row.simulated = 100 + error;
    row.error = error;
    row.u_num = row.u_grid = u_grid;
    row.u_input = row.u_data = 0.1;
    row.u_val = row.u_known = std::hypot(u_grid, 0.1, 0.1);
    row.interval = {error - confidence * row.u_known, error + confidence * row.u_known};
    conclude(row);
    return row;
}

}  // namespace

TEST_CASE("The first table has one line a scene, of the default variant at its finest spacing", "[report]") {
    Summary summary = samples::summary();
    summary.scenes[0].quantities = {peak_of("pressure_gauge")};
    AnalysisSpec empty;
    empty.scene = "unrun";
    summary.scenes.push_back(empty);
    const std::string page = first_page(summary);
    const std::string table = outcomes_in(page);
    CHECK(samples::occurrences(table, "<tr><td") == 2);
    CHECK(page.find("<table>") > page.find("stacked outcomes"));  // it is the first
    for (const char* part :
         {"<a href=\"scene-tank.html\" title=\"tank\">Tank</a>", "two-phase, 0.01 m",
          "<span title=\"peak\">largest pressure gauge</span>", "100 ± 20", "kind not stated", ">105<",
          ">Pa<", "<span class=\"badge good\">within tolerance</span>", ">20<", "<svg class=\"thumbnail\"",
          "not run"}) {
        INFO(part);
        CHECK(contains(table, part));
    }
    CHECK_FALSE(contains(table, "single-phase"));
    CHECK_FALSE(contains(table, "0.02 m"));
}

TEST_CASE("Expected deaths, coarse spacings, other variants and other codes are not on the first screen",
          "[report]") {
    Summary summary = samples::summary();
    RunSummary dead = samples::run("paper", 0.01);
    dead.record.status = RunStatus::unstable;
    dead.record.stop_reason = "density error 0.3";
    dead.expected_unstable = true;
    summary.runs.push_back(dead);
    const std::string page = first_page(summary);
    const std::string screen =
        page.substr(page.find("<h1>"), page.find("Other variants, coarser") - page.find("<h1>"));
    for (const char* word :
         {"paper", "unstable", "density error", "single-phase", "0.02", "other_code", "badge bad"}) {
        INFO(word);
        CHECK_FALSE(contains(screen, word));
    }
    const std::string rest = between(page, "Other variants, coarser", "</table>");
    CHECK(contains(rest, "two-phase, paper, single-phase"));
    CHECK(contains(rest, "<td class=\"number\">5</td><td class=\"number\">1</td>"));
    CHECK_FALSE(contains(page, "card bad"));
}

TEST_CASE("The main quantity is the best that has a verdict", "[report]") {
    Summary summary = samples::summary();
    summary.scenes[0].quantities = {peak_of("pressure_gauge")};
    const auto chosen = [&] { return report::outcomes_of(summary).at(0); };
    CHECK(chosen().verdict == "within tolerance");
    CHECK(chosen().words == "largest pressure gauge");

    const ValidationRow exact = judged("pressure_gauge: mean against theory", ReferenceKind::analytic, 30, 1);
    ValidationRow measured =
        judged("pressure_gauge: peak against gauge", ReferenceKind::experiment, 0.1, 0.01);
    const ValidationRow main = judged("peak", ReferenceKind::peer_simulation, 5, 1);
    const ValidationRow elsewhere = judged("front: mean against film", ReferenceKind::experiment, 1, 1);
    summary.agreement = {exact};
    summary.validation = {elsewhere};
    CHECK(chosen().kind == "exact solution");
    CHECK(chosen().verdict == "higher");
    summary.validation = {elsewhere, measured};
    CHECK(chosen().kind == "experiment");
    CHECK(chosen().quantity == measured.quantity);
    CHECK(chosen().tone == report::Tone::good);
    summary.agreement = {exact, main};
    CHECK(chosen().quantity == "peak");
    CHECK(chosen().kind == "other code");
    measured = judged("peak", ReferenceKind::experiment, 1, 100);
    summary.validation = {measured};
    CHECK(chosen().verdict == "refine first");
    CHECK(chosen().open == "needs finer spacing");
}

TEST_CASE("A scene whose run stopped has its end for a verdict", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) run.record.status = RunStatus::unstable;
    CHECK(report::outcomes_of(summary).at(0).verdict == "became unstable");
    CHECK(report::outcomes_of(summary).at(0).tone == report::Tone::bad);
    for (RunSummary& run : summary.runs) run.expected_unstable = true;
    CHECK(report::outcomes_of(summary).at(0).verdict == "became unstable, as expected");
    CHECK(report::outcomes_of(summary).at(0).tone == report::Tone::open);
    for (RunSummary& run : summary.runs) run.record.status = RunStatus::failed;
    CHECK(report::outcomes_of(summary).at(0).verdict == "failed");
}

TEST_CASE("What to look at next: the worst values, doubtful flows, what would help most", "[report]") {
    Summary summary = samples::summary();
    CHECK_FALSE(contains(first_page(summary), "What to look at next"));
    summary.validation = {judged("alpha", ReferenceKind::experiment, 20, 1),
                          judged("beta", ReferenceKind::experiment, -40, 1),
                          judged("gamma", ReferenceKind::experiment, 1, 10)};
    summary.runs[2].record.series["density_error_max"] = {"-", "", {0, 1}, {0.01, 0.189}, {}};
    const std::string list = between(first_page(summary), "What to look at next", "</ul>");
    CHECK(contains(
        list,
        "<span title=\"beta\">beta</span> is too low, 60 against 100\u00a0Pa (experiment): 40 % off, "
        "at least 38 % with 95 % confidence."));
    CHECK_FALSE(contains(list, "alpha"));  // one a scene
    CHECK(contains(list, "off by up to 19 %"));
    CHECK(contains(list, "1 value has no decision yet; <b>finer spacing</b> would help most"));
    for (ValidationRow& row : summary.validation) row.variant = "single-phase";
    CHECK_FALSE(contains(first_page(summary), ">beta<"));  // no default variant
}

TEST_CASE("A run whose water is compressed by more than one per cent has an amber mark and a remedy",
          "[report]") {
    Summary summary = samples::summary();
    RunSummary& run = summary.runs[2];  // two-phase, finest
    run.record.parameters["water.sound_speed"] = 60;
    for (const auto& [change, marked] :
         {std::pair(0.009, false), std::pair(0.011, true), std::pair(0.08, true)}) {
        INFO(change);
        run.record.series["density_error_max"] = {"-", "", {0, 1}, {0, change}, {}};
        const std::string page = first_page(summary);
        CHECK(contains(outcomes_in(page), ">density changes by ") == marked);
        CHECK(contains(page, "so that peaks depend on its sound speed, 60 m/s") == marked);
        CHECK_FALSE(contains(page, "the water&#39;s density is off"));
    }
}

TEST_CASE("Runs that are left out are named before the first number, many of them in a box", "[report]") {
    Summary summary = samples::summary();
    for (const std::size_t runs : {2U, 9U}) {
        summary.left_out.assign(
            runs, {"runs/tank/dx1", "tank", "two-phase", 1, {"water.depth is <1>, in the latest run 2"}});
        const std::string page = first_page(summary);
        const std::string before = page.substr(0, page.find("What was reached"));
        CHECK(samples::occurrences(
                  before, "runs/tank/dx1 is left out: water.depth is &lt;1&gt;, in the latest run 2") ==
              runs);
        CHECK(contains(before, "9 runs are left out</summary>") == (runs == 9));
    }
}

TEST_CASE("A thumbnail shows lines and points inside the axes and tells what it is", "[report]") {
    report::Figure figure;
    figure.title = "p <1>";
    CHECK(report::thumbnail(figure).empty());
    figure.x.range = Window{0, 1};
    figure.y.range = Window{0, 1};
    figure.series = {report::line("", {{0, 0.5, 1, 2}, {0, 1, 0, 0}}, "#08519c")};
    figure.series.push_back(figure.series[0]);
    figure.series[1].style = report::Style::points;
    const std::string svg = report::thumbnail(figure);
    CHECK(contains(svg, "<title>p &lt;1&gt;</title>"));
    CHECK(contains(svg, "<polyline points=\"3.0,45.0 75.0,3.0 147.0,45.0\""));
    CHECK(contains(svg, "<path d=\"M3.0,45.0h0M75.0,3.0h0M147.0,45.0h0\""));
}
