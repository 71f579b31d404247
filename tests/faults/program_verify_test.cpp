// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck verify` as a user sees it: files, exit codes, and the line about a problem that does not exist.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::run_program;
using samples::ScratchFolder;

TEST_CASE("verify leaves a report and a summary, and keeps the results of other problems", "[faults]") {
    const ScratchFolder folder;
    const std::string out = folder / "out";
    REQUIRE(run_program({"verify", "--fast", "--only", "riemann", "--out", out}).code == 0);
    REQUIRE(run_program({"verify", "--fast", "--only", "kernel_moments", "--out", out}).code == 0);
    REQUIRE(std::filesystem::exists(out + "/index.html"));
    std::ifstream in(out + "/summary.json");
    const auto list = nlohmann::json::parse(in).at("verification");
    const auto holds = [&](const char* name) {
        return std::any_of(list.begin(), list.end(),
                           [&](const auto& row) { return row.at("problem") == name; });
    };
    CHECK(holds("riemann"));
    CHECK(holds("kernel_moments"));
    CHECK(run_program({"report", out}).code == 0);
}

TEST_CASE("verify names the problems there are when asked for another", "[faults]") {
    const ScratchFolder folder;
    const Outcome outcome = run_program({"verify", "--only", "perpetuum_mobile", "--out", folder / "out"});
    CHECK(outcome.code == 2);
    CHECK(outcome.one_line());
    CHECK_THAT(outcome.err, Contains("unknown problem 'perpetuum_mobile', expected some of kernel_moments"));
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}
