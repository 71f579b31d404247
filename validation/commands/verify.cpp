// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/metrics/verification_json.hpp"
#include "validation/run/progress.hpp"
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

/// In place of an earlier result of the same problem, in the order of the list of problems.
void keep(VerificationProblem result, std::vector<VerificationProblem>& results) {
    std::erase_if(results, [&](const VerificationProblem& r) { return r.name == result.name; });
    results.push_back(std::move(result));
    const auto place = [](const VerificationProblem& r) {
        const std::vector<verification::Problem>& all = verification::all_problems();
        return std::find_if(all.begin(), all.end(),
                            [&](const verification::Problem& p) { return p.name == r.name; }) -
               all.begin();
    };
    std::stable_sort(results.begin(), results.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
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
    std::mutex one_at_a_time;
    std::exception_ptr trouble;  // none may leave a parallel loop
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t n = 0; n < chosen.size(); ++n) {  // each problem takes one thread
        try {
            VerificationProblem result = solve(chosen[n], options.fast ? Effort::quick : Effort::full);
            const std::lock_guard lock(one_at_a_time);
            print_problem(result);
            keep(std::move(result), results);
            atomic_write(file, verification_json(results).dump(1) + "\n");
        } catch (...) {
            const std::lock_guard lock(one_at_a_time);
            trouble = std::current_exception();
        }
    }
    if (trouble) std::rethrow_exception(trouble);
    return results;
}

}  // namespace wetdeck
