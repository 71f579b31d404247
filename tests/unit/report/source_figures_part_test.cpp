// SPDX-License-Identifier: BSD-3-Clause
// Figures of the sources: links into the page, and reasons where there is none.
#include <catch2/catch.hpp>

#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;
using samples::between;
using samples::contains;
using samples::page_of;

namespace {

Summary with_figures() {
    Summary summary = samples::summary();
    summary.scenes[0].source_figures = {
        {"4", "the energy", {"tank-two-phase-energy", "section-tank-fields"}, "", "An author (2001)"},
        {"5b", "waves <3>", {"tank-waves"}, "no gauge", "An author (2001)"},
        {"1", "a photograph", {}, "not drawn", "Another author (1999)"}};
    return summary;
}

}  // namespace

TEST_CASE("Figures of each source are listed with links to what the page shows", "[report]") {
    const std::string page = page_of(with_figures());
    const std::string table = between(page, "<h4>An author (2001)</h4>", "</table>");
    CHECK(contains(table,
                   "<td>4</td><td>the energy</td><td><a href=\"scene-tank.html#tank-two-phase-energy\">"));
    CHECK(contains(table, "<a href=\"scene-tank.html#tank-two-phase-energy-change\">"));
    CHECK(contains(table, "<a href=\"scene-tank.html#section-tank-fields\">tank Fields</a>"));
    CHECK(contains(page, "id=\"tank-two-phase-energy\""));
    CHECK(contains(page, "id=\"section-tank-fields\""));
    const std::string other = between(page, "<h4>Another author (1999)</h4>", "</table>");
    CHECK(contains(other, "<td>1</td><td>a photograph</td><td>—</td><td>not drawn</td>"));
}

TEST_CASE("A figure without a counterpart has a reason", "[report]") {
    Summary summary = with_figures();
    CHECK(contains(page_of(summary),
                   "<td>5b</td><td>waves &lt;3&gt;</td><td>Not shown: the runs in this directory do not hold "
                   "the data for it.</td><td>no gauge</td>"));
    summary.runs.clear();
    summary.missing = {"runs/tank"};
    CHECK(contains(page_of(summary), "Not shown: this directory holds no run of the scene."));
}

TEST_CASE("The figures of a source that several scenes share are listed from its first on", "[report]") {
    Summary summary = with_figures();
    summary.scenes.push_back(summary.scenes[0]);
    summary.scenes[1].scene = "zz";
    summary.scenes[1].source_figures = {{"10", "late", {}, "none", "S, section 2"}};
    summary.scenes[0].source_figures = {{"19", "last", {}, "none", "S, section 3"}};
    summary.scenes.push_back(summary.scenes[0]);
    summary.scenes[2].scene = "zzz";
    summary.scenes[2].source_figures = {{"1", "early", {}, "none", "S, section 1"}};
    const std::string page = page_of(summary);
    const std::size_t early = page.find("<h4>S, section 1"), late = page.find("<h4>S, section 2");
    CHECK(early < late);
    CHECK(late < page.find("<h4>S, section 3"));
}

TEST_CASE("A figure names the curves of others that it shows, at hand or not", "[report]") {
    Summary summary = with_figures();
    summary.scenes[0].source_figures[0].curves = {{"measured", true}, {"<lost>", false}};
    const std::string table = between(page_of(summary), "<h4>An author (2001)</h4>", "</table>");
    CHECK(contains(
        table,
        "<a href=\"scene-tank.html#section-tank-provenance\">reference_data/tank/measured.csv</a><br>"
        "curve not available: reference_data/tank/&lt;lost&gt;.csv</td>"));
}

TEST_CASE("Reference files that nothing is compared with are listed with the reason", "[report]") {
    Summary summary = samples::summary();
    CHECK_FALSE(contains(page_of(summary), "Reference files that no comparison uses"));
    summary.scenes[0].unused_references = {{"square_column", "another <shape>"}};
    const std::string table =
        between(page_of(summary), "<h4>Reference files that no comparison uses</h4>", "</table>");
    CHECK(contains(table, "<td>square_column</td>"));
    CHECK(contains(table, "another &lt;shape&gt;"));
}

TEST_CASE("An aligned comparison has a figure of its own", "[report]") {
    Summary summary = samples::summary();
    ComparisonSpec spec;
    spec.title = "Pressure against gauge";
    spec.quantity = "pressure_gauge";
    spec.reference = "gauge";
    spec.align_peaks = true;
    summary.scenes[0].comparisons = {spec};
    const std::string page = page_of(summary);
    CHECK(contains(page, "id=\"tank-two-phase-pressure-gauge-aligned\""));
    CHECK(contains(page, "id=\"tank-two-phase-pressure-gauge\""));
}

TEST_CASE("Scenes without figures of a source have no such chapter", "[report]") {
    CHECK_FALSE(contains(page_of(samples::summary()), "Figures of the sources"));
}
