// SPDX-License-Identifier: BSD-3-Clause
// verification.json keeps all that the report shows, and says what is wrong with a file that is none.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/metrics/verification_json.hpp"

using namespace wetdeck;

namespace {

std::vector<VerificationProblem> read_back(const std::string& text) {
    const samples::ScratchFolder folder;
    std::ofstream(folder / "verification.json") << text;
    return read_verification(folder / "verification.json");
}

}  // namespace

TEST_CASE("Results of problems are read back as they were written", "[verification]") {
    VerificationProblem problem;
    problem.name = "pulse";
    problem.notes = {"a note"};
    problem.rows.push_back({{"speed", "error of it", "dx / L", 0.1, Window{0.5, 1.5}, "theory", "misses"},
                            {0.1, 0.05},
                            {0.02, 0.01},
                            {},
                            false});
    judge(problem.rows[0]);
    problem.figures.push_back({"curve", "x", "m", "y", "-", {{0, 1}, {2, 3}}, {{"fine", {{0}, {1}}}}});
    const auto read = read_back(verification_json({problem}).dump());
    REQUIRE(read.size() == 1);
    CHECK(verification_json(read) == verification_json({problem}));
    CHECK(read[0].rows[0].order.value() == Approx(1));
    CHECK(read[0].rows[0].within);
    const auto entry = verification_list(read).at(0);
    CHECK(entry.at("problem") == "pulse");
    CHECK(entry.at("expected_order") == 1.0);
    CHECK(entry.at("within") == true);
}

TEST_CASE("An error that is not a number is null in the file and outside its bound", "[verification]") {
    VerificationProblem problem;
    problem.rows.push_back({{"speed", "", "", 0.1, {}, ""}, {0.1}, {std::nan("")}, {}, true});
    judge(problem.rows[0]);
    const auto read = read_back(verification_json({problem}).dump());
    CHECK(verification_list(read).at(0).at("error").at(0).is_null());
    CHECK_FALSE(read[0].rows[0].within);
}

TEST_CASE("A file that holds no results is refused; none at all is no results", "[verification]") {
    CHECK_THROWS_AS(read_back("{\"name\": 3"), DataError);
    const samples::ScratchFolder empty;
    CHECK(read_verification(empty / "verification.json").empty());
}
