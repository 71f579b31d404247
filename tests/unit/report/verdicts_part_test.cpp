// SPDX-License-Identifier: BSD-3-Clause
// The table of all verdicts, the replicates, and what each says would help most.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/report/report_samples.hpp"
#include "validation/metrics/replicates.hpp"
#include "validation/metrics/verdict.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;

namespace {

ValidationRow row(const std::string& quantity, double error, double u_grid, double u_data) {
    ValidationRow r;
    r.scene = "tank";
    r.variant = "two-phase";
    r.quantity = quantity;
    r.against = "somebody (1999)";
    r.kind = ReferenceKind::experiment;
    r.unit = "Pa";
    r.dx = 0.01;
    r.reference = 100;
    r.simulated = 100 + error;
    r.error = error;
    r.u_num = r.u_grid = u_grid;
    r.u_num_source = "GCI / 2";
    r.u_input = 1;
    r.largest_input = "body.mass";
    r.u_data = u_data;
    r.u_val = r.u_known = std::hypot(u_grid, 1, u_data);
    r.interval = {error - confidence * r.u_known, error + confidence * r.u_known};
    conclude(r);
    return r;
}

Summary with_verdicts() {
    Summary s = samples::summary();
    s.validation = {row("alpha", 20, 2, 1), row("beta", 3, 5, 1), row("gamma", 3, 1, 5)};
    s.agreement = {row("delta", 1, 1, 2)};
    s.agreement[0].kind = ReferenceKind::peer_simulation;
    conclude(s.agreement[0]);
    return s;
}

std::string verdicts_of(const Summary& summary) {
    return between(page_of(summary), "id=\"section-verdicts\"", "id=\"section-suite-statistics\"");
}

}  // namespace

TEST_CASE("The table of verdicts says what was reached, how sure it is and what would help", "[report]") {
    const std::string part = verdicts_of(with_verdicts());
    CHECK(contains(part, "<b>too high</b>"));
    CHECK(contains(part, "<b>refine first</b>"));
    CHECK(contains(part, "<b>within the uncertainty</b>"));
    CHECK(contains(part, "<b>agrees</b>"));
    // 20 +- 1.96 sqrt(2^2 + 1 + 1)
    CHECK(contains(part, "+15.2 to +24.8 %"));
    CHECK(contains(part, "Verdicts: refine first 1, too high 1, within the uncertainty 1."));
    CHECK(contains(part, "most would help: better reference data 1, finer spacing 1."));
    CHECK(contains(part, ">40</td>"));  // core-seconds of both spacings of the variant
}

TEST_CASE("A value that rests on a judgement says so in the table", "[report]") {
    Summary s = with_verdicts();
    CHECK_FALSE(contains(verdicts_of(s), "by judgement</span>"));
    s.validation[0].assumed = {"u_data"};
    CHECK(contains(verdicts_of(s), "by judgement</span>"));
}

TEST_CASE("Without any value to judge there is no table of verdicts", "[report]") {
    CHECK_FALSE(contains(page_of(samples::summary()), "section-verdicts"));
}

TEST_CASE("Replicates have a table and their distributions a figure", "[report]") {
    Summary s = with_verdicts();
    CHECK_FALSE(contains(page_of(s), "area metric"));
    ReplicateRow spread = spread_of({98, 101, 104, 97, 105});
    spread.scene = "tank";
    spread.variant = "two-phase";
    spread.quantity = "alpha";
    spread.unit = "Pa";
    spread.dx = 0.02;
    spread.reference = 100;
    spread.u_reference = 2;
    spread.area = 1.5;
    s.replicates = {spread};
    const std::string page = page_of(s);
    CHECK(contains(page, "Values of all replicates"));
    CHECK(contains(page, "area metric"));
    CHECK(contains(page, "tank-replicates-alpha"));
    CHECK(contains(page, "5 replicates, two-phase at 0.02 m"));
}
