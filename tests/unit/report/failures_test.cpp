// SPDX-License-Identifier: BSD-3-Clause
// Failures in the report: those that nobody expects on the first page, all on the page of their scene.
#include <catch2/catch.hpp>

#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;
using samples::between;
using samples::contains;
using samples::page_of;

namespace {

/// The chapter of the only scene.
std::string failures_of(const std::string& page) {
    return between(page, "id=\"section-tank-failures\">", "<h2");
}

/// The chapter of the first page; empty without one.
std::string on_first_page(const std::string& page) {
    const std::string first = page.substr(0, page.find("</html>"));
    return contains(first, ">Failures</h2>") ? between(first, ">Failures</h2>", "<h2") : "";
}

/// As of a run that did not reach what the quantity needs.
void leave_uncomputed(RunSummary& run, const char* why) {
    run.quantities[0].value.reset();
    run.quantities[0].within.reset();
    run.quantities[0].note = why;
}

}  // namespace

TEST_CASE("A complete report says so by not saying incomplete", "[report]") {
    const std::string page = page_of(samples::summary());
    CHECK(contains(page, "<title>wetdeck report, tier quick</title>"));
    CHECK_FALSE(contains(page, "INCOMPLETE"));
    CHECK(contains(page, "Every run completed, and every value and curve with a tolerance lies within it."));
    CHECK_FALSE(contains(page, "validated"));
}

TEST_CASE("A missing run is named and marks the title incomplete", "[report]") {
    Summary summary = samples::summary();
    summary.missing = {"tank paper dx 0.005"};
    const std::string page = page_of(summary);
    CHECK(contains(page, "<title>INCOMPLETE: wetdeck report"));
    CHECK(contains(page, "<h1>INCOMPLETE: wetdeck report"));
    CHECK(contains(on_first_page(page), "tank paper dx 0.005"));
    CHECK_FALSE(contains(between(page, ">Runs</h2>", "<h2"), "tank paper dx 0.005"));  // told once
}

TEST_CASE("A run that became unstable comes first, with its reason", "[report]") {
    Summary summary = samples::summary();
    summary.runs[0].record.status = RunStatus::unstable;
    summary.runs[0].record.stop_reason = "density error 0.3 at t = 0.1 s";
    leave_uncomputed(summary.runs[0], "ended before the window");
    const std::string page = page_of(summary);
    const std::string failures = failures_of(page);
    CHECK(contains(failures, "single-phase<br>0.01 m"));
    CHECK(contains(failures, "density error 0.3 at t = 0.1 s"));
    CHECK(contains(on_first_page(page), "density error 0.3 at t = 0.1 s"));
    CHECK(page.find("1 run became unstable or failed, and nobody expects it") <
          page.find("What was reached"));
    CHECK(page.find(">Failures</h2>") < page.find(">Runs</h2>"));
    CHECK(contains(page, "<b>3 of 4</b><span>runs completed</span>"));
}

TEST_CASE("A run that its scene expects to become unstable is no failure", "[report]") {
    Summary summary = samples::summary();
    RunSummary& run = summary.runs[0];
    run.record.status = RunStatus::unstable;
    run.record.stop_reason = "density error 0.3 at t = 0.1 s";
    run.expected_unstable = true;
    const std::string page = page_of(summary);
    const std::string failures = failures_of(page);
    CHECK_FALSE(contains(failures, "Runs that became unstable or failed"));
    CHECK(contains(between(failures, "Runs that became unstable as their scene expects", "</table>"),
                   "density error 0.3 at t = 0.1 s"));
    CHECK(contains(failures, "Every other run completed"));
    CHECK(on_first_page(page).empty());
    CHECK_FALSE(contains(between(page, "What was reached", "</article>"), "density error 0.3"));
    CHECK(contains(page, "<b>3 of 3</b><span>runs completed, besides 1 that became unstable as expected"));
    run.record.status = RunStatus::failed;  // any other end is a failure all the same
    CHECK(contains(failures_of(page_of(summary)), "Runs that became unstable or failed"));
    CHECK(contains(on_first_page(page_of(summary)), "density error 0.3 at t = 0.1 s"));
}

TEST_CASE("Values that an unstable run lacks are not listed again, and the page says so", "[report]") {
    Summary summary = samples::summary();
    RunSummary& unstable = summary.runs[0];
    unstable.record.status = RunStatus::unstable;
    leave_uncomputed(unstable, "ended before the window");
    unstable.comparisons[0].within = false;
    const std::string failures = failures_of(page_of(summary));
    CHECK_FALSE(contains(failures, "ended before the window"));
    CHECK_FALSE(contains(failures, "Outside tolerance"));
    CHECK(contains(failures, "runs that became unstable or failed (1) are not listed again"));
}

TEST_CASE("What a sound run did not reach is listed with the reason", "[report]") {
    Summary summary = samples::summary();
    leave_uncomputed(summary.runs[0], "does not rise through 5");
    CHECK(contains(failures_of(page_of(summary)), "not computed: does not rise through 5"));
}

TEST_CASE("What a run did not reach that was asked to stop early is no failure", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) {
        leave_uncomputed(run, "the series spans less");
    }
    CHECK(contains(failures_of(page_of(summary)), "not computed: the series spans less"));
    for (RunSummary& run : summary.runs) run.record.parameters["run.until"] = 0.5;
    const std::string failures = failures_of(page_of(summary));
    CHECK_FALSE(contains(failures, "not computed"));
    CHECK(contains(failures, "4 of the runs were stopped on request before the end time of the scene"));
}

TEST_CASE("A hard case that became unstable shows its picture", "[report]") {
    Summary summary;
    summary.stress = {{"column", "10 m/s", false, "unstable at t = 1 s", "stress/column.png"},
                      {"column", "1 m/s", true, "stable"}};
    report::ReportInputs inputs = samples::inputs();
    inputs.instabilities["stress/column.png"] = "made-up bytes";
    const std::string page = page_of(summary, inputs);
    CHECK(contains(page, "alt=\"column, 10 m/s\""));
    CHECK_FALSE(contains(page, "alt=\"column, 1 m/s\""));
}

TEST_CASE("What lies outside tolerance is listed among the failures", "[report]") {
    Summary summary = samples::summary();
    summary.runs[2].quantities[0].within = false;
    summary.runs[2].comparisons[0].within = false;
    summary.runs[2].comparisons[0].nrmse = 0.234;
    const std::string page = page_of(summary);
    const std::string failures = failures_of(page);
    CHECK(contains(failures, "<td rowspan=\"2\" class=\"name\">two-phase<br>0.01 m</td>"));
    CHECK(contains(failures, "expected 100\u00a0Pa, made up"));
    CHECK(contains(failures, "NRMSE 0.234"));
    CHECK(contains(page, "outside tolerance"));
}

TEST_CASE("A comparison without a reference file is neither a success nor a failure", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) {
        run.comparisons[0].available = false;
        run.comparisons[0].within = false;
        run.comparisons[0].nrmse.reset();
        run.comparisons[0].note = "no such file";
    }
    const std::string page = page_of(summary);
    CHECK_FALSE(contains(failures_of(page), "no such file"));
    CHECK(contains(page, "no such file"));
    CHECK(contains(page, "<b>4 of 4</b><span>reference curves within tolerance"));
}

TEST_CASE("A run with compressed water or particles outside the tank is doubtful, whatever its values",
          "[report]") {
    Summary summary = samples::summary();
    summary.runs[0].record.series["density_error_max"] = {"-", "", {0, 1}, {0.01, 0.189}, {}};
    summary.runs[1].record.series["particles_outside"] = {"-", "", {0, 1}, {0, 2}, {}};
    const std::string failures = failures_of(page_of(summary));
    CHECK(contains(failures, "Runs with a doubtful flow"));
    CHECK(contains(failures, "off by up to 19 %, more than 5 %"));
    CHECK(contains(failures, "2 fluid particles are beyond the tank&#39;s faces"));
    CHECK(contains(failures, "the flow of the runs above is doubtful all the same"));
}

TEST_CASE("Water that is compressed by a few per cent is in order", "[report]") {
    Summary summary = samples::summary();
    summary.runs[0].record.series["density_error_max"] = {"-", "", {0, 1}, {0.01, 0.049}, {}};
    summary.runs[0].record.series["particles_outside"] = {"-", "", {0, 1}, {0, 0}, {}};
    CHECK_FALSE(contains(page_of(summary), "Runs with a doubtful flow"));
}
