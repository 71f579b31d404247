// SPDX-License-Identifier: BSD-3-Clause
// The report as a whole, written from a made-up summary.
#include "reports/report.hpp"

#include <stdlib.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "reports/figures/reference_names.hpp"
#include "reports/page/figure.hpp"
#include "solver/core/errors.hpp"
#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;
using samples::between;
using samples::contains;
using samples::page_of;
using samples::pages_of;

namespace {

/// The PATH without any program, restored with the scope.
class EmptyPath {
  public:
    EmptyPath() : before_(::getenv("PATH")) { ::setenv("PATH", "/nonexistent", 1); }
    ~EmptyPath() { ::setenv("PATH", before_.c_str(), 1); }
    EmptyPath(const EmptyPath&) = delete;
    EmptyPath& operator=(const EmptyPath&) = delete;

  private:
    std::string before_;
};

}  // namespace

TEST_CASE("The same inputs give the same bytes, page and figures", "[report]") {
    const samples::ScratchFolder first;
    const samples::ScratchFolder second;
    report::write_report(first, samples::summary(), samples::inputs());
    Summary shuffled = samples::summary();
    std::reverse(shuffled.runs.begin(), shuffled.runs.end());
    report::write_report(second, shuffled, samples::inputs());
    CHECK(samples::pages_in(first) == samples::pages_in(second));
    const auto names = samples::names_in(first / "figures");
    CHECK(names == samples::names_in(second / "figures"));
    for (const std::string& name : names) {
        INFO(name);
        CHECK(samples::bytes_of(first / "figures" / name) == samples::bytes_of(second / "figures" / name));
    }
}

TEST_CASE("Peer simulations have tables of their own and are labelled", "[report]") {
    const std::string page = page_of(samples::summary());
    const std::string measured = between(page, "Compared with measurements</h4>", "<h4>");
    CHECK(contains(measured, "<br>gauge<br>"));
    CHECK_FALSE(contains(measured, "other_code"));
    const std::string peers =
        between(page, "Compared with other simulations (peer simulations, no validation)</h4>", "</table>");
    CHECK(contains(peers, "other_code"));
    CHECK_FALSE(contains(peers, "<br>gauge<br>"));
    CHECK(contains(page, "other_code (peer simulation)"));
}

TEST_CASE("The page forbids every load from outside and holds none", "[report]") {
    const std::string page = page_of(samples::summary());
    CHECK(contains(page,
                   "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
                   "'unsafe-inline'; "
                   "style-src 'unsafe-inline'; img-src data: blob:\">"));
    for (const char* load :
         {"src=\"http", "src=\"//", "href=\"http", "<link", "<iframe", "@import", "url("}) {
        INFO(load);
        CHECK_FALSE(contains(page, load));
    }
    CHECK(samples::occurrences(page, " src=\"") == samples::occurrences(page, " src=\"data:image/"));
}

TEST_CASE("Markup in any text of a scene or run is shown and not obeyed", "[report]") {
    const std::string evil = "<script>alert('x')</script>";
    Summary summary = samples::summary();
    summary.tier = summary.missing.emplace_back() = evil;
    AnalysisSpec& scene = summary.scenes[0];
    scene.title = scene.purpose = scene.source = evil;
    scene.deviations = {{evil, evil, evil, evil}};
    scene.limits = {evil};
    for (RunSummary& run : summary.runs) {
        run.record.variant += evil;
        run.record.stop_reason = run.record.scene_text = evil;
        run.record.status = RunStatus::failed;
        run.record.provenance[evil] = evil;
        run.record.parameters[evil] = 1;
        run.record.cost.stage_seconds[evil] = 1;
        run.record.cost.limiting_criterion[evil] = 1;
        run.quantities[0].name = run.quantities[0].unit = run.quantities[0].expected_source = evil;
        for (ComparisonResult& c : run.comparisons) {
            c.title = c.citation = c.note = c.x_label = c.y_label = evil;
            c.reference += evil;
        }
    }
    summary.convergence[0].qoi = summary.convergence[0].verdict = evil;
    report::ReportInputs inputs = samples::inputs();
    inputs.note = evil;
    inputs.program = inputs.machine = {{evil, evil}};
    inputs.sketches["tank"] = "<svg xmlns='http://www.w3.org/2000/svg'>" + evil + "</svg>";
    inputs.schemes["tank"] = {{evil, evil, evil, evil, evil, evil}};
    for (const auto& [name, page] : pages_of(summary, inputs)) {
        INFO(name);
        CHECK_FALSE(contains(page, "<script>alert"));
        CHECK_FALSE(contains(page, "</script>alert"));
        // the script of the page, plotly.js where there are figures, and one data block for each: closed once
        const std::size_t blocks = samples::occurrences(page, "<script type=\"application/json\"");
        CHECK(samples::occurrences(page, "<script") == blocks + (blocks > 0 ? 2 : 1));
        CHECK(samples::occurrences(page, "</script") == blocks + (blocks > 0 ? 2 : 1));
    }
}

TEST_CASE("A report lists the keys in which schemes differ from that of the source, one column a variant",
          "[report]") {
    report::ReportInputs inputs = samples::inputs();
    CHECK_FALSE(contains(page_of(samples::summary(), inputs), "Schemes against that of the source"));
    inputs.schemes["tank"] = {
        {"two-phase", "model.courant_number", "of the acoustic time step", "Eq. (26)", "0.25", "0.5"},
        {"alone", "model.courant_number", "of the acoustic time step", "Eq. (26)", "0.25", "0.45"},
        {"alone", "model.air", "whether the air is computed", "", "true", "false"}};
    const std::string page = page_of(samples::summary(), inputs);
    CHECK(contains(page, "Schemes against that of the source"));
    CHECK(samples::occurrences(page, "<td>model.courant_number</td>") == 1);
    CHECK(contains(page, "<td>0.25</td><td>0.5</td><td>0.45</td>"));
    CHECK(contains(page, "<td>true</td><td>same</td><td>false</td>"));
}

TEST_CASE("Every figure has a drawing and a table of the same name, and the page links both", "[report]") {
    if (!report::gnuplot_found()) {
        WARN("gnuplot was not found: nothing drawn");
        return;
    }
    const samples::ScratchFolder folder;
    report::write_report(folder, samples::summary(), samples::inputs());
    const std::string page = samples::report_in(folder);
    std::set<std::string> drawings, tables;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "figures")) {
        const std::filesystem::path& path = entry.path();
        INFO(path);
        REQUIRE((path.extension() == ".svg" || path.extension() == ".csv"));
        (path.extension() == ".svg" ? drawings : tables).insert(path.stem());
        CHECK(contains(page, "href=\"figures/" + path.filename().string() + "\""));
    }
    CHECK(drawings == tables);
    CHECK(drawings.count("tank-two-phase-pressure-gauge") == 1);
    CHECK(drawings.count("tank-variants-pressure-gauge") == 1);
    CHECK(drawings.count("tank-convergence-peak") == 1);
    CHECK(drawings.count("tank-speed-error") == 1);
    CHECK(drawings.count("tank-single-phase-energy") == 1);
    CHECK(drawings.count("tank-two-phase-energy-change") == 1);
    CHECK(samples::occurrences(page, "<figure class=\"drawing\"") == drawings.size());
}

TEST_CASE("Figures of an earlier report go, other files stay", "[report]") {
    const samples::ScratchFolder folder;
    std::filesystem::create_directory(folder / "figures");
    samples::put_bytes(folder / "figures/old.csv", "old");
    samples::put_bytes(folder / "figures/notes.txt", "mine");
    report::write_report(folder, samples::summary(), samples::inputs());
    CHECK_FALSE(std::filesystem::exists(folder / "figures/old.csv"));
    CHECK(samples::bytes_of(folder / "figures/notes.txt") == "mine");
}

TEST_CASE("Without gnuplot the page says so and keeps interactive figures and tables", "[report]") {
    const samples::ScratchFolder folder;
    {
        const EmptyPath no_programs;
        report::write_report(folder, samples::summary(), samples::inputs());
    }
    const std::string page = samples::report_in(folder);
    CHECK(contains(page, "gnuplot was not found"));
    CHECK(contains(page, "class=\"plot-data\""));
    CHECK(std::filesystem::exists(folder / "figures/tank-speed-error.csv"));
    CHECK_FALSE(std::filesystem::exists(folder / "figures/tank-speed-error.svg"));
}

TEST_CASE("Without plotly.js the figures are static and the page has its own script alone", "[report]") {
    report::ReportInputs inputs = samples::inputs();
    inputs.plotly.clear();
    const auto pages = pages_of(samples::summary(), inputs);
    for (const auto& [name, page] : pages) {
        INFO(name);
        CHECK(samples::occurrences(page, "<script") == 1);
        CHECK_FALSE(contains(page, "class=\"plot-data\""));
    }
    CHECK(contains(pages.at("index.html"), "the figures are static"));
}

TEST_CASE("plotly.js is part of each page with figures once, whatever it holds", "[report]") {
    for (const auto& [name, page] : pages_of(samples::summary())) {
        INFO(name);
        const std::size_t once = contains(page, "class=\"plot-data\"") ? 1 : 0;
        CHECK(samples::occurrences(page, "window.Plotly = {}; // <\\/script>") == once);
        CHECK((once == 1) == (name != "index.html"));
    }
}

TEST_CASE("Pictures are part of the page, with title, time and colour bar", "[report]") {
    const std::string page = page_of(samples::summary());
    CHECK(contains(page, "<figcaption>Pressure, t = 0.5\u00a0s, T = 2</figcaption>"));
    CHECK(contains(page, "<div class=\"figures player\">\n<figure data-instant=\"t = 0.5\u00a0s, T = 2\">"));
    CHECK(contains(page, "src=\"data:image/png;base64,AQID\""));
    CHECK(contains(page, "linear-gradient(to right,#000000,#ffffff)"));
}

TEST_CASE("A reference is named by authors and year where its title has them", "[report]") {
    const auto name = [](const char* title) { return report::reference_name(title, "stem"); };
    CHECK(name("Gauge pressure, Buchner (2002), first digitisation") == "Buchner (2002), first digitisation");
    CHECK(name("Pressure at 0.267 h_w, incompressible delta-SPH of De Courcy et al. (2024)") ==
          "De Courcy et al. (2024)");
    CHECK(name("Buchner (2002), with words that no legend has the room for") == "Buchner (2002)");
    CHECK(name("Front, WCSPH of a code, H/dx = 400") == "WCSPH of a code, H/dx = 400");
    CHECK(name("Front, Ritter's shallow-water limit: position early, speed late") ==
          "Ritter's shallow-water limit");
    CHECK(name("Force against the two-dimensional free-fall integration") ==
          "the two-dimensional free-fall integration");
    CHECK(name("A title so long that it leaves no room for the curves themselves") == "stem");
    CHECK(name("") == "stem");
}

TEST_CASE("Other codes are measured against the same records as this program", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) {
        run.record.series["pressure_gauge"] = {"Pa", "", {0, 1}, {0, 1}, {}};
        for (ComparisonResult& c : run.comparisons) c.window = Window{0.5, 2};
        run.comparisons[0].measured = {{0, 2}, {1, 1}};
        run.comparisons[1].measured = {{0, 2}, {1.25, 1.25}};                            // 0.25 off
        for (ComparisonResult& c : run.comparisons) c.simulated = {{0, 2}, {1.5, 1.5}};  // 0.5 off
    }
    const std::string table =
        between(page_of(summary), "Other codes against the same measurements", "</table>");
    CHECK(contains(table, ">Pressure against other_code</td><td class=\"number\">0.25</td>"));
    CHECK(contains(table, ">this program, pressure_gauge</td><td class=\"number\">0.5</td>"));
    for (RunSummary& run : summary.runs)
        run.comparisons[1].measured = {{1, 2}, {1, 1}};  // not all of the window
    CHECK(contains(between(page_of(summary), "Other codes against the same measurements", "</table>"),
                   ">Pressure against other_code</td><td class=\"number\">—</td>"));
}

TEST_CASE("Conservation shows growth, change, drift and particles outside of each run", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) {
        run.energy_error = 0.0123;
        run.record.series["mass"] = {"kg/m", "", {0, 1}, {2, 1.5}, {}};
        run.record.series["particles_outside"] = {"-", "", {0, 1}, {0, 7}, {}};
        run.record.series["density_error_max"] = {"-", "", {0, 1}, {0.002, 0.001}, {}};
    }
    const std::string page = page_of(summary);
    const std::string table = between(page, ">Conservation</h2>", "</table>");
    // the three energies of the samples rise by 2 J/m each, the potential one starts from 1 J/m
    for (const char* cell : {">0.0123<", ">6<", ">0.25<", ">7<", ">0.002<"}) {
        INFO(cell);
        CHECK(contains(table, cell));
    }
    CHECK_FALSE(contains(table, "momentum"));
}

TEST_CASE("Cost shows the stages, the pace, the memory of a particle and what limits the step", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) run.record.parameters["bytes_per_particle"] = 281;
    const std::string cost = between(page_of(summary), ">Cost</h2>", "<h2");
    for (const char* part : {"rates [s]", "advance [s]", "acoustic 100 %", ">281<", ">50000<"}) {
        INFO(part);
        CHECK(contains(cost, part));
    }
}

TEST_CASE("Every reference is cited once, with its kind and what is compared with it", "[report]") {
    const std::string page = page_of(samples::summary());
    CHECK(samples::occurrences(page, "Made-up source of gauge") == 1);
    CHECK(contains(between(page, "<h4>References</h4>", "</table>"), "<td>experiment</td><td>unknown</td>"));
}

TEST_CASE("A changed reference file is counted for the runs that used it", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) {
        run.comparisons[0].reference_hash = "fnv1a64:2";
        // the single-phase runs were compared with another file alone
        run.record.provenance["reference_hashes"] =
            run.record.variant == "two-phase" ? "big_gauge fnv1a64:2, gauge fnv1a64:1" : "other fnv1a64:3";
    }
    CHECK(contains(page_of(summary), "fnv1a64:2; 2 of the runs used another version</td>"));
    for (RunSummary& run : summary.runs) run.record.provenance["reference_hashes"] = "gauge fnv1a64:2";
    CHECK_FALSE(contains(page_of(summary), "used another version"));
}

TEST_CASE("A run without a curve has no figure of references alone", "[report]") {
    Summary summary = samples::summary();
    for (RunSummary& run : summary.runs) {
        if (run.record.variant != "single-phase") continue;
        for (ComparisonResult& c : run.comparisons) c.simulated = {{0}, {0}};
    }
    const std::string page = page_of(summary);
    CHECK_FALSE(contains(page, "tank-single-phase-pressure-gauge.csv"));
    CHECK(contains(page, "tank-two-phase-pressure-gauge.csv"));
}

TEST_CASE("A summary without runs and scenes still makes a page", "[report]") {
    const std::string page = page_of(Summary{});
    CHECK(contains(page, "There are no runs."));
    CHECK(contains(page, "tier unknown"));
}

TEST_CASE("The title names the tier, or what was run without one", "[report]") {
    report::ReportInputs inputs = samples::inputs();
    CHECK(contains(page_of(samples::summary(), inputs), "<title>wetdeck report, tier quick</title>"));
    inputs.subject = "single runs";
    CHECK(contains(page_of(samples::summary(), inputs), "<title>wetdeck report, single runs</title>"));
}

TEST_CASE("A directory that cannot be written is an error of the environment", "[report]") {
    const samples::ScratchFolder folder;
    samples::put_bytes(folder / "file", "x");
    CHECK_THROWS_AS(report::write_report(folder / "file", samples::summary(), samples::inputs()),
                    EnvironmentError);
}

TEST_CASE("A report of problems with exact solutions alone names criteria that are not met, and no runs",
          "[report]") {
    VerificationProblem problem;
    problem.name = "drop";
    problem.title = "Oscillating drop";
    Claim claim{"axis", "relative error", "dx / radius", 0.1, Window{0.5, 2}, "first order"};
    for (const double coarsest : {0.08, 0.4}) {
        VerificationRow row{claim, {0.1, 0.05}, {coarsest, coarsest / 2}, {}, false};
        judge(row);
        problem.rows.push_back(row);
    }
    Summary summary;
    summary.verification = {problem};
    const std::string page = page_of(summary);
    CHECK(contains(page, "<b>1 of 2</b><span>criteria met in problems with exact solutions"));
    CHECK(contains(page, "Criteria that are not met"));
    CHECK_FALSE(contains(page, "Every run completed"));
    CHECK_FALSE(contains(page, "There are no runs"));
    CHECK_FALSE(contains(page, "runs completed"));

    Summary with_runs = samples::summary();
    with_runs.verification = {problem};
    const std::string both = page_of(with_runs);
    CHECK(contains(both, "<b>1 of 2</b><span>criteria met in problems with exact solutions"));
    CHECK(contains(both, "runs completed"));
}
