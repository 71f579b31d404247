// SPDX-License-Identifier: BSD-3-Clause
#include "validation/execute/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/execute/progress.hpp"
#include "validation/metrics/verification_json.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/verification/problems.hpp"

namespace wetdeck {
namespace {

void print_problem(const VerificationProblem& problem) {
    fmt::print("{} ({:.1f} s)\n", problem.name, problem.wall_s);
    for (const VerificationRow& row : problem.rows) {
        std::string errors;
        for (const double error : row.error) errors += fmt::format(" {:9.3g}", error);
        const std::string order = row.order && row.claim.order ? fmt::format("{:5.2f}", *row.order) : "    -";
        const std::string range =
            row.claim.order ? fmt::format("{} to {}", row.claim.order->begin, row.claim.order->end) : "none";
        fmt::print("  {} {:34} error{:40} bound {:8.3g}  order {} (expected {})\n", row.within ? "  " : "X ",
                   row.claim.quantity, errors, row.claim.bound, order, range);
    }
    if (!problem.unstable.empty()) fmt::print("  unstable {}\n", problem.unstable);
    std::fflush(stdout);
}

}  // namespace

std::vector<VerificationProblem> run_verification(const VerifyOptions& options) {
    using namespace verification;
    std::vector<Problem> chosen = problems_named(options.problems);
    if (options.fast) std::erase_if(chosen, [](const Problem& problem) { return !problem.quick; });
    if (chosen.empty()) throw InputError("--fast leaves none of these problems: they have no quick form");
    make_directories(options.directory);
    const std::filesystem::path file = options.directory / verification_file;
    std::vector<VerificationProblem> results = read_verification(file);
    for (const Problem& problem : chosen) {
        VerificationProblem result = solve(problem, options.fast ? Effort::quick : Effort::full);
        print_problem(result);
        const auto before = std::find_if(results.begin(), results.end(),
                                         [&](const VerificationProblem& r) { return r.name == result.name; });
        if (before == results.end()) {
            results.push_back(std::move(result));
        } else {
            *before = std::move(result);
        }
        atomic_write(file, verification_json(results).dump(1) + "\n");
    }
    return results;
}

}  // namespace wetdeck
