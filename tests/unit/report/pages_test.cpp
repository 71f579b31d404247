// SPDX-License-Identifier: BSD-3-Clause
// The pages of a report: which there are, that every link leads somewhere, print, and all of them as one
// file.
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "reports/page/html.hpp"
#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;
using samples::between;
using samples::contains;

namespace {

/// Two scenes, exact solutions, hard cases, figures of sources.
Summary everything() {
    Summary summary = samples::summary();
    summary.scenes[0].source_figures = {{"4", "energy", {"tank-two-phase-energy"}, "", "An author (2001)"}};
    AnalysisSpec other = summary.scenes[0];
    other.scene = "other_tank";
    other.title = "Another tank";
    summary.scenes.push_back(other);
    RunSummary run = samples::run("two-phase", 0.01);
    run.record.scene = "other_tank";
    summary.runs.push_back(run);
    summary.stress = {{"column", "10 m/s", false, "unstable at t = 1 s"}};
    VerificationProblem problem;
    problem.name = "drop";
    problem.title = "Oscillating drop";
    summary.verification = {problem};
    return summary;
}

std::vector<std::string> matches(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> out;
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
        out.push_back((*at)[1]);
    return out;
}

/// Markup alone: without style, scripts and embedded drawings.
std::string without_code(const std::string& page) {
    std::string out;
    for (std::size_t at = 0; at < page.size();) {
        const std::size_t script = page.find("<script", at), style = page.find("<style", at);
        const std::size_t open = std::min(script, style);
        out += page.substr(at, open == std::string::npos ? open : open - at);
        if (open == std::string::npos) break;
        at = page.find(script < style ? "</script>" : "</style>", open);
    }
    return out;
}

}  // namespace

TEST_CASE("A report has a first page, one page a scene and one for the statistics", "[report]") {
    std::set<std::string> names;
    for (const auto& [name, page] : samples::pages_of(everything())) names.insert(name);
    CHECK(names == std::set<std::string>{"exact-solutions.html", "hard-cases.html", "index.html",
                                         "library.html", "scene-other-tank.html", "scene-tank.html",
                                         "sources.html", "statistics.html"});
    names.clear();
    for (const auto& [name, page] : samples::pages_of(samples::summary())) names.insert(name);
    CHECK(names == std::set<std::string>{"index.html", "scene-tank.html", "statistics.html"});
}

TEST_CASE("Every link of every page leads to a page, a file or an anchor that is there", "[report]") {
    const samples::ScratchFolder folder;
    report::write_report(folder, everything(), samples::inputs());
    const auto pages = samples::pages_in(folder);
    std::size_t links = 0;
    for (const auto& [name, page] : pages) {
        for (const std::string& address : matches(without_code(page), "href=\"([^\"]*)\"")) {
            INFO(name << ": " << address);
            const std::size_t hash = address.find('#');
            const std::string file = address.substr(0, hash);
            const std::string target = file.empty() ? name : file;
            REQUIRE(std::filesystem::exists(folder / target));
            if (hash != std::string::npos)
                CHECK(contains(pages.at(target), "id=\"" + address.substr(hash + 1) + "\""));
            ++links;
        }
        for (const auto& [other, ignored] : pages)
            CHECK(contains(between(page, "<nav class=\"pages\"", "</nav>"), "href=\"" + other + "\""));
        CHECK(contains(page, "<a href=\"" + name + "\" aria-current=\"page\">"));
    }
    CHECK(links > 50);
}

TEST_CASE("Two scenes whose names differ by letters that no file name keeps have a page each", "[report]") {
    Summary summary = everything();
    summary.scenes[1].scene = "tank_";
    summary.runs.back().record.scene = "tank_";
    const auto pages = samples::pages_of(summary);
    REQUIRE(pages.count("scene-tank.html") == 1);
    REQUIRE(pages.count("scene-tank-2.html") == 1);
    CHECK(contains(pages.at("scene-tank-2.html"), "<h1>Another tank</h1>"));
    CHECK(contains(pages.at("index.html"), "<a href=\"scene-tank-2.html\" title=\"tank_\">Another tank</a>"));
}

TEST_CASE("No anchor and no figure stands twice in a report", "[report]") {
    std::set<std::string> seen;
    for (const auto& [name, page] : samples::pages_of(everything()))
        for (const std::string& id : matches(without_code(page), " id=\"([^\"]*)\"")) {
            INFO(name << ": " << id);
            CHECK(seen.insert(id).second);
        }
}

TEST_CASE("As a single file the report has all pages and no link to another file", "[report]") {
    const samples::ScratchFolder folder;
    report::ReportInputs inputs = samples::inputs();
    report::write_report(folder, everything(), inputs);
    samples::put_bytes(folder / "mine.html", "<p>mine</p>");
    const auto apart = samples::pages_in(folder);
    inputs.single_file = true;
    report::write_report(folder, everything(), inputs);
    const auto pages = samples::pages_in(folder);
    REQUIRE(pages.size() == 2);  // the pages of the report before are gone, a file of the user stays
    CHECK(pages.at("mine.html") == "<p>mine</p>");
    const std::string& all = pages.at("index.html");
    for (const std::string& address : matches(without_code(all), "href=\"([^\"]*)\"")) {
        INFO(address);
        REQUIRE(address.substr(0, 1) == "#");
        CHECK(contains(all, "id=\"" + address.substr(1) + "\""));
    }
    CHECK(samples::occurrences(all, "window.Plotly = {}") == 1);
    CHECK(samples::occurrences(all, "<!DOCTYPE html>") == 1);
    for (const auto& [name, page] : apart) {
        if (name == "mine.html") continue;
        INFO(name);
        CHECK(contains(all, "id=\"page-" + name.substr(0, name.find('.')) + "\""));
        CHECK(contains(all, "<h1>" + between(page, "<h1>", "</h1>").substr(4) + "</h1>"));
    }
    inputs.single_file = false;
    report::write_report(folder, everything(), inputs);
    CHECK(samples::pages_in(folder) == apart);
}

TEST_CASE("Title, caption and provenance of a figure stand once", "[report]") {
    const auto pages = samples::pages_of(samples::summary());
    const std::string& page = pages.at("scene-tank.html");
    CHECK(samples::occurrences(
              page, "<figcaption><span title=\"pressure_gauge\">tank, two-phase: pressure gauge</span>") ==
          1);
    CHECK_FALSE(contains(page, "Program revision"));
    for (const auto& [name, each] : pages) {
        INFO(name);
        CHECK(samples::occurrences(each, "<footer>revision abc1234") == 1);
        CHECK(samples::occurrences(without_code(each), "abc1234") <= (name == "index.html" ? 1U : 2U));
    }
    CHECK(samples::occurrences(page, "Largest increase of the total") == 1);  // of two variants
}

TEST_CASE("On paper every table is as wide as the page, whatever its columns", "[report]") {
    const std::string page = samples::page_of(samples::summary());
    const std::string print = between(page, "@media print {", "</style>");
    for (const char* rule :
         {".table { overflow: visible;", "white-space: normal;", "overflow-wrap: anywhere;",
          ".columns-many table { font-size: 7.5pt; }", ".columns-most table { font-size: 6.5pt; }",
          "nav.pages, nav.contents { display: none; }",
          "details::details-content { content-visibility: visible;"}) {
        INFO(rule);
        CHECK(contains(print, rule));
    }
    for (const auto& [columns, css] :
         {std::pair(2, "\"table\""), std::pair(6, "\"table\""), std::pair(7, "\"table columns-many\""),
          std::pair(10, "\"table columns-many\""), std::pair(11, "\"table columns-most\""),
          std::pair(20, "\"table columns-most\"")}) {
        report::Table table(std::vector<std::string>(static_cast<std::size_t>(columns), "header"));
        INFO(columns);
        CHECK(contains(table.html(), std::string("<div class=") + css + ">"));
    }
    for (const std::string& table : matches(without_code(page), "<div class=\"(table[^\"]*)\"")) {
        INFO(table);
        CHECK(table.rfind("table", 0) == 0);
    }
    CHECK(samples::occurrences(page, "<table>") == samples::occurrences(page, "<div class=\"table"));
}

TEST_CASE("On a narrow screen tables scroll in their boxes, and the first becomes a list", "[report]") {
    const std::string page = samples::pages_of(samples::summary()).at("index.html");
    CHECK(contains(page, ".table { overflow-x: auto;"));
    CHECK(contains(page, ".stacked td::before { content: attr(data-label);"));
    const std::string first = between(page, "<div class=\"table compact stacked outcomes", "</table>");
    for (const char* label :
         {"scene", "main quantity", "expected", "reached", "unit", "verdict", "core-seconds", "curve"})
        CHECK(samples::occurrences(first, std::string(" data-label=\"") + label + "\"") == 1);
}
