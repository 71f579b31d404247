// SPDX-License-Identifier: BSD-3-Clause
// Sweeps as a user runs them: the table, the report, taking up again, refusals.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;

namespace {

/// Its density is a parameter; three spacings of water alone.
const std::string scene = samples::replaced(
    samples::replaced(
        samples::replaced(samples::with("[scales]\n", "[parameters]\nrho = 1000.0\n\n[scales]\n"),
                          "density = 1000.0", "density = \"= rho\""),
        "single-phase = [0.02, 0.04]", "single-phase = [0.04, 0.02, 0.01]"),
    "default_variant = \"two-phase\"", "default_variant = \"single-phase\"");

std::vector<std::string> sweep(const ScratchFolder& folder, const std::string& over) {
    return {"sweep", put_scene(folder, scene), "--over", over, "--out", folder / "out", "--jobs", "1"};
}

}  // namespace

TEST_CASE("a sweep writes a table and a report, and its finished runs are reused", "[faults]") {
    const ScratchFolder folder;
    const Outcome outcome = run_program(sweep(folder, "rho=900:1000:2"));
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    const std::string table = samples::bytes_of(folder / "out/sweep.csv");
    CHECK_THAT(table, Contains("rho,dx [m],front_mean [-],front_mean_u_num [-]"));
    CHECK_THAT(table, Contains("\n900,0.01,") && Contains("\n1000,0.01,") && Contains(",ok\n"));
    CHECK_THAT(samples::bytes_of(folder / "out/index.html"), Contains("front mean"));
    CHECK_THAT(run_program(sweep(folder, "rho=900:1000:2")).out, Contains("0 runs to do"));
    REQUIRE(run_program({"report", folder / "out"}).code == 0);
    CHECK(samples::bytes_of(folder / "out/sweep.csv") == table);
    // a grid with more points takes the runs that are there
    CHECK_THAT(run_program(sweep(folder, "rho=900:1000:3")).out, Contains("3 runs to do"));
}

TEST_CASE("a sweep of one spacing says that its numerical uncertainty is unknown", "[faults]") {
    const ScratchFolder folder;
    std::vector<std::string> arguments = sweep(folder, "rho=900:1000:2");
    arguments.insert(arguments.end(), {"--dx", "0.04"});
    const Outcome outcome = run_program(arguments);
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.err, Contains("doubt: 1 spacing at each point"));
}

TEST_CASE("what a sweep cannot do is refused in one line before anything is run", "[faults]") {
    const ScratchFolder folder;
    for (const char* over : {"rho=1:2", "water.nothing=1:2:2", "rho=-5:-4:2", "rho=1:2:2 lemons"}) {
        const Outcome outcome = run_program(sweep(folder, over));
        INFO(over << " " << outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.one_line());
    }
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
    REQUIRE(run_program(sweep(folder, "rho=900:1000:2")).code == 0);
    std::vector<std::string> other = sweep(folder, "rho=900:1000:2");
    other.insert(other.end(), {"--variant", "two-phase", "--dx", "0.04"});
    const Outcome outcome = run_program(other);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Contains("expected another directory"));
}
