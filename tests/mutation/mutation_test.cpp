// SPDX-License-Identifier: BSD-3-Clause
// Tests of the verification: each deliberate breakage of the solver makes the problem that is named beside it
// fail, and each problem holds without one. The breakages are those of mutations.txt; all of them are in this
// program, a number says which is on, and mutation_cases.inc has one test case for each.
#include <catch2/catch.hpp>

#include "tests/support/samples.hpp"
#include "validation/verification/problems.hpp"

int wetdeck_mutation = 0;

using namespace wetdeck;
using namespace wetdeck::verification;

namespace {

/// Claims of a problem that do not hold although they should.
std::vector<std::string> failures(const std::string& name) {
    const samples::ChosenInstructionSet mutated("sse2");
    const VerificationProblem result = solve(problems_named({name}).front(), Effort::quick);
    std::vector<std::string> broken;
    if (!result.unstable.empty()) broken.push_back("unstable " + result.unstable);
    for (const VerificationRow& row : result.rows) {
        if (!row.within && row.claim.known_miss.empty()) broken.push_back(row.claim.quantity);
    }
    return broken;
}

void check_sound(const char* problem) {
    wetdeck_mutation = 0;
    CHECK(failures(problem) == std::vector<std::string>{});
}

void check_noticed(int mutation, const char* problem) {
    wetdeck_mutation = mutation;
    CHECK_FALSE(failures(problem).empty());
}

}  // namespace

#include "mutation_cases.inc"
static_assert(mutation_count >= 20);
