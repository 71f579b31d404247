// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck stress` as a user sees it: rows, pictures of instabilities, exit codes.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::run_program;
using samples::ScratchFolder;

TEST_CASE("stress keeps rows of stable and unstable settings, with a picture, and rows of other cases",
          "[faults]") {
    const ScratchFolder folder;
    const std::string out = folder / "out";
    // the one quick setting of this case cannot be survived, and survival is not required
    REQUIRE(run_program({"stress", "--fast", "--jobs", "1", "--only", "courant", "--out", out}).code == 0);
    REQUIRE(run_program({"stress", "--fast", "--jobs", "1", "--only", "still_water", "--out", out}).code ==
            0);
    std::ifstream in(out + "/summary.json");
    const auto rows = nlohmann::json::parse(in).at("stress");
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("case") == "courant");
    CHECK(rows[0].at("survived") == false);
    CHECK_THAT(rows[0].at("note").get<std::string>(),
               Contains("became unstable at t = ") && Contains("not required"));
    CHECK(std::filesystem::file_size(out + "/stress/courant-3.png") > 1000);
    CHECK(rows[1].at("case") == "still_water");
    CHECK(rows[1].at("survived") == true);
    CHECK(std::filesystem::exists(out + "/index.html"));
}

TEST_CASE("stress names the cases there are when asked for another", "[faults]") {
    const ScratchFolder folder;
    const Outcome outcome = run_program({"stress", "--only", "kraken", "--out", folder / "out"});
    CHECK(outcome.code == 2);
    CHECK(outcome.one_line());
    CHECK_THAT(outcome.err, Contains("unknown case 'kraken', expected some of density_ratio"));
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}
