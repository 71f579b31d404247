// SPDX-License-Identifier: BSD-3-Clause
// Every quick problem with an exact solution, at its coarse resolutions: each claim holds, but those of which
// the problem itself says that they do not.
#include <catch2/catch.hpp>

#include "validation/verification/problems.hpp"

using namespace wetdeck;
using namespace wetdeck::verification;

namespace {

/// Names of the problems that have a test case of their own.
std::vector<std::string>& tested() {
    static std::vector<std::string> names;
    return names;
}

struct Tested {
    explicit Tested(const char* name) { tested().emplace_back(name); }
};

void check_claims(const char* name) {
    const VerificationProblem result = solve(problems_named({name}).front(), Effort::quick);
    INFO(result.unstable);
    CHECK(result.unstable.empty());
    for (const VerificationRow& row : result.rows) {
        if (!row.claim.known_miss.empty()) continue;
        INFO(row.claim.quantity << ": error " << (row.error.empty() ? -1 : row.error.back())
                                << " at the finest, bound " << row.claim.bound << " at the coarsest, order "
                                << row.order.value_or(0));
        CHECK(row.within);
    }
}

}  // namespace

#define TEST_PROBLEM(name)                                                           \
    const Tested tested_##name(#name);                                               \
    TEST_CASE("Every claim of " #name " holds but the known misses", "[problems]") { \
        check_claims(#name);                                                         \
    }

TEST_PROBLEM(kernel_moments)
TEST_PROBLEM(riemann)
TEST_PROBLEM(acoustic_pulse)
TEST_PROBLEM(sponge_layer)
TEST_PROBLEM(graded_spacing)
TEST_PROBLEM(hydrostatic_tank)
TEST_PROBLEM(taylor_green)
TEST_PROBLEM(layered_flow)
TEST_PROBLEM(oscillating_drop)
TEST_PROBLEM(square_patch)
TEST_PROBLEM(block_impact)
TEST_PROBLEM(trapped_air_piston)
TEST_PROBLEM(ritter)
TEST_PROBLEM(released_column)
TEST_PROBLEM(free_flight)
TEST_PROBLEM(floating_body)
TEST_PROBLEM(heave_decay)
TEST_PROBLEM(roll_decay)
TEST_PROBLEM(oscillating_cylinder)
TEST_PROBLEM(moving_tank)

TEST_CASE("Every quick problem has a test case", "[problems]") {
    std::vector<std::string> quick;
    for (const Problem& problem : all_problems())
        if (problem.quick) quick.push_back(problem.name);
    CHECK_THAT(tested(), Catch::Matchers::UnorderedEquals(quick));
}

TEST_CASE("A claim of which nothing was found has not held, and what nobody claimed cannot be found",
          "[problems]") {
    Findings findings({{"known", "", "", 1, {}, ""}}, Effort::quick);
    CHECK_FALSE(findings.rows().front().within);
    CHECK_THROWS_AS(findings.record("unknown", 1, 0), std::logic_error);
    findings.record("known", 1, 0.5);
    CHECK(findings.rows().front().within);
}

TEST_CASE("A claim is judged by bound and order", "[problems]") {
    const auto judged = [](std::vector<double> error, std::optional<Window> order) {
        VerificationRow row{{"q", "", "", 1, order, ""}, {1, 0.5, 0.25}, std::move(error), {}, false};
        judge(row);
        return row;
    };
    CHECK(judged({1, 0.5, 0.25}, Window{0.9, 1.1}).within);
    CHECK(judged({1, 0.5, 0.25}, Window{0.9, 1.1}).order.value() == Approx(1));
    CHECK_FALSE(judged({1, 0.5, 0.25}, Window{1.5, 2.5}).within);  // too slow
    CHECK_FALSE(judged({1, 0.5, 0.25}, Window{0.1, 0.5}).within);  // too fast to be true
    CHECK_FALSE(judged({0.9, 0.9, 1.1}, {}).within);               // over the bound at one resolution
    CHECK_FALSE(judged({0.5, std::nan(""), 0.1}, {}).within);
    CHECK_FALSE(judged({}, {}).within);
}
