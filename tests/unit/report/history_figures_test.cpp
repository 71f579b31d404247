// SPDX-License-Identifier: BSD-3-Clause
// Histories of probes and bodies that no comparison shows.
#include <catch2/catch.hpp>
#include <set>

#include "reports/figures/figures.hpp"
#include "reports/figures/selection.hpp"
#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;

namespace {

/// Each run of the sample with two probes, a profile, a body and a series of every run.
Summary recorded() {
    Summary s = samples::summary();
    s.scenes[0].probes = {"pressure_gauge", "depth", "film", "surface"};
    for (RunSummary& run : s.runs) {
        auto& series = run.record.series;
        series["pressure_gauge"] = {"Pa", "", {0, 1, 2}, {0, 5, 3}, {}};  // compared
        series["depth"] = {"m", "depth at the wall", {0, 1, 2}, {0, 0.1, 0.2}, {}};
        series["film"] = {"m", "", {0, 1, 2}, {0.3, 0.3, 0.3}, {}};  // nothing to see
        series["surface"] = {"m", "", {0, 1}, {1, 2, 3, 4}, {0.1, 0.2}};
        series["body_force_y"] = {"N/m", "", {0, 1, 2}, {0, 7, 1}, {}};
        series["mach_max"] = {"-", "", {0, 1, 2}, {0, 0.1, 0.2}, {}};
    }
    return s;
}

std::multiset<std::string> identifiers(const Summary& s) {
    std::multiset<std::string> names;
    for (const report::Figure& figure : report::history_figures(s.scenes[0], report::runs_of(s, s.scenes[0])))
        names.insert(figure.identifier);
    return names;
}

}  // namespace

TEST_CASE("Every probe that no comparison shows is drawn, of the variants and over the spacings",
          "[report]") {
    const Summary s = recorded();
    CHECK(identifiers(s) == std::multiset<std::string>{"body_force_y", "body_force_y", "depth", "depth"});
    const report::Runs runs = report::runs_of(s, s.scenes[0]);
    for (const report::Figure& figure : report::history_figures(s.scenes[0], runs))
        CHECK(figure.series.size() == 2);  // variants, or spacings
    CHECK(samples::contains(samples::page_of(s), "depth at the wall"));
}

TEST_CASE("A probe that a comparison shows is not drawn again, one that none shows is", "[report]") {
    Summary s = recorded();
    for (RunSummary& run : s.runs) run.comparisons.clear();
    CHECK(identifiers(s).count("pressure_gauge") == 2);
    s.scenes[0].probes.clear();
    CHECK(identifiers(s).count("pressure_gauge") == 0);
    CHECK(identifiers(s).count("depth") == 0);
}
