// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck verify`: problems with exact solutions.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/report.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/metrics/verification_json.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/verification/problems.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
    std::vector<std::string> problems;  ///< all if empty
    std::string directory;
    bool fast = false;  ///< the quick problems alone, at their coarse resolutions
};

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

/// Replaces an earlier result of the same problem; the order is that of the list of problems.
void keep(VerificationProblem result, std::vector<VerificationProblem>& results) {
    std::erase_if(results, [&](const VerificationProblem& r) { return r.name == result.name; });
    results.push_back(std::move(result));
    const auto position = [](const VerificationProblem& r) {
        const std::vector<verification::Problem>& all = verification::all_problems();
        return std::find_if(all.begin(), all.end(),
                            [&](const verification::Problem& p) { return p.name == r.name; }) -
               all.begin();
    };
    std::stable_sort(results.begin(), results.end(),
                     [&](const auto& a, const auto& b) { return position(a) < position(b); });
}

/// Runs the problems, prints a table for each and writes DIR/verification.json, which keeps the results of
/// other problems that it holds.
std::vector<VerificationProblem> run_problems(const VerifyOptions& options, const fs::path& directory) {
    using namespace verification;
    std::vector<Problem> chosen = problems_named(options.problems);
    if (options.fast) std::erase_if(chosen, [](const Problem& problem) { return !problem.quick; });
    if (chosen.empty()) throw InputError("--fast leaves none of these problems: they have no quick form");
    make_directories(directory);
    const fs::path file = directory / verification_file;
    std::vector<VerificationProblem> results = read_verification(file);
    std::mutex one_at_a_time;
    std::exception_ptr failure;  // no exception may leave a parallel loop
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
            failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
    return results;
}

int verify(const VerifyOptions& options) {
    const fs::path directory =
        options.directory.empty() ? fs::path("results") / "verification" : fs::path(options.directory);
    const std::vector<VerificationProblem> results = run_problems(options, directory);
    const int verdict = print_verdict(make_report(directory), directory);
    return any_unstable(results) ? exit_unstable : verdict;
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App& command =
        *app.add_subcommand("verify", "problems with exact solutions: errors and observed orders");
    add_only(command, options->problems, "problems", "PROBLEM");
    add_out(command, options->directory, "results/verification");
    command.add_flag("--fast", options->fast, "only the quick problems, at their coarse resolutions");
    command.callback([options, &exit_code] { exit_code = verify(*options); });
}

}  // namespace wetdeck
