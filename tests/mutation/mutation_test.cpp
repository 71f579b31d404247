// SPDX-License-Identifier: BSD-3-Clause
// Tests of the verification: each deliberate breakage of the solver makes the problem that is named beside it
// fail. The breakages are those of mutations.txt; all of them are in this program, and a number says which is
// on.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>

#include "validation/verification/problems.hpp"

int wetdeck_mutation = 0;

using namespace wetdeck;
using namespace wetdeck::verification;

namespace {

struct Mutation {
    int number;
    const char* name;
    const char* problem;
};
constexpr Mutation mutations[] = {
#include "mutation_table.inc"
};

/// What of a problem does not hold although it should.
std::vector<std::string> failures(const std::string& name) {
    const VerificationProblem result = solve(problems_named({name}).front(), Effort::quick);
    std::vector<std::string> broken;
    if (!result.unstable.empty()) broken.push_back("unstable " + result.unstable);
    for (const VerificationRow& row : result.rows) {
        if (!row.within && row.claim.known_miss.empty()) broken.push_back(row.claim.quantity);
    }
    return broken;
}

}  // namespace

TEST_CASE("Each deliberate breakage of the solver fails its problem with an exact solution", "[mutation]") {
    REQUIRE(std::size(mutations) >= 10);
    setenv("WETDECK_SIMD", "sse2", 1);  // the mutated pair loops
    std::map<std::string, bool> sound;  // nothing fails where nothing is broken
    for (const Mutation& mutation : mutations) {
        wetdeck_mutation = 0;
        if (sound.emplace(mutation.problem, true).second) {
            INFO(mutation.problem << " without a mutation");
            CHECK(failures(mutation.problem) == std::vector<std::string>{});
        }
        wetdeck_mutation = mutation.number;
        INFO("mutation: " << mutation.name << ", problem: " << mutation.problem);
        const std::vector<std::string> broken = failures(mutation.problem);
        CHECK_FALSE(broken.empty());
        if (!broken.empty()) UNSCOPED_INFO(broken.front());
    }
    wetdeck_mutation = 0;
}
