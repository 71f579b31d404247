// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck stress`: hard cases, which of them survive and where the limits of stability lie.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <thread>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/metrics/stored_tables.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/scene/schemes.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/stress/bisect.hpp"
#include "validation/stress/cases.hpp"

namespace wetdeck {
namespace {

using namespace stress;
namespace fs = std::filesystem;

struct StressOptions {
    std::vector<std::string> cases;  ///< all if empty
    std::string directory;
    bool fast = false;  ///< the quick settings with the default scheme, no limits
    int jobs = 0;       ///< runs at a time; 0: one per core
};

/// One row of the table, and the function that fills it.
struct Task {
    StressRow row;
    bool required = false;  ///< to survive: the default scheme on a sensible setting
    std::function<void(StressRow&)> run;
    bool done = false;
};

std::string file_name(const StressRow& row) {
    std::string name = row.stress_case + "-" + row.setting;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return name + ".png";
}

void run_setting(StressRow& row, const Setting& setting, const Scheme& scheme, const fs::path& directory) {
    std::optional<Outcome> outcome;
    try {
        outcome = run_trial(setting.build(scheme));
    } catch (const InputError& refusal) {  // the scheme cannot run this setting
        row.note = std::string("refused: ") + refusal.what();
        return;
    }
    row.survived = outcome->survived();
    row.note = outcome->note();
    if (!setting.beyond.empty()) row.note += " [not required: " + setting.beyond + "]";
    if (!outcome->failure) return;
    const std::vector<unsigned char> picture = picture_of(*outcome->failure);
    row.picture = (fs::path("stress") / file_name(row)).string();
    atomic_write(directory / row.picture, {reinterpret_cast<const char*>(picture.data()), picture.size()});
}

void run_search(StressRow& row, const Search& search) {
    std::string instability;
    const Limit limit = find_limit(search.from, search.to, search.ratio, [&](double value) {
        const Outcome outcome = run_trial(search.build(value));
        if (outcome.failure) instability = outcome.note();
        return outcome.survived();
    });
    const auto margin = [&](double value) { return std::max(value / search.from, search.from / value); };
    row.survived = limit.stable.has_value();
    if (!limit.stable) {
        row.note = fmt::format("unstable at {:g}, the value in use: {}", search.from, instability);
    } else if (!limit.unstable) {
        row.note =
            fmt::format("in use {:g}, stable up to the end of the search at {:.3g}: margin above {:.3g}",
                        search.from, *limit.stable, margin(*limit.stable));
    } else {
        row.note = fmt::format("in use {:g}, stable at {:.3g}, not at {:.3g}: margin {:.3g}; {}", search.from,
                               *limit.stable, *limit.unstable, margin(*limit.stable), instability);
    }
}

std::vector<Task> tasks_of(const std::vector<Case>& cases, bool fast, const fs::path& directory) {
    std::vector<Task> tasks;
    std::vector<Scheme> schemes = scheme_names();
    schemes.insert(schemes.begin(), default_scheme);
    for (const Case& member : cases) {
        for (const Setting& setting : member.settings) {
            for (const Scheme& scheme : schemes) {
                if (fast && (!setting.quick || !scheme.empty())) continue;
                const bool standard = scheme.empty();
                tasks.push_back({{member.name, setting.name + (standard ? "" : ", " + scheme), false, "", ""},
                                 standard && setting.beyond.empty(),
                                 [&setting, scheme, &directory](StressRow& row) {
                                     run_setting(row, setting, scheme, directory);
                                 }});
            }
        }
        if (fast) continue;
        for (const Search& search : member.searches)
            tasks.push_back(
                {{member.name, fmt::format("limit of {}: {}", search.name, search.quantity), false, "", ""},
                 true,
                 [&search](StressRow& row) { run_search(row, search); }});
    }
    return tasks;
}

/// Rows of other cases stay as the file holds them, followed by the rows that are done.
void store(const fs::path& directory, const std::vector<Task>& tasks) {
    std::vector<StressRow> rows = read_stress(directory);
    std::erase_if(rows, [&](const StressRow& row) {
        return std::any_of(tasks.begin(), tasks.end(),
                           [&](const Task& task) { return task.row.stress_case == row.stress_case; });
    });
    for (const Task& task : tasks)
        if (task.done) rows.push_back(task.row);
    write_stress(directory, rows);
}

void print_row(const StressRow& row, double seconds) {
    fmt::print("{} {:20} {:44} {:6.1f} s  {}\n", row.survived ? "  " : "X ", row.stress_case, row.setting,
               seconds, row.note);
    std::fflush(stdout);
}

/// Runs each task on one thread and `jobs` at a time, the required ones first. Results are stored as they
/// come, so that they are kept if the rest is stopped.
void run_all(std::vector<Task>& tasks, const fs::path& directory, int jobs) {
    std::vector<Task*> order;
    for (Task& task : tasks) order.push_back(&task);
    std::stable_partition(order.begin(), order.end(), [](const Task* task) { return task->required; });
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t k = next++; k < order.size(); k = next++) {
            Task& task = *order[k];
            try {
                const auto start = std::chrono::steady_clock::now();
                task.run(task.row);
                const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
                const std::scoped_lock lock(mutex);
                task.done = true;
                store(directory, tasks);
                print_row(task.row, time.count());
            } catch (...) {
                const std::scoped_lock lock(mutex);
                if (!failure) failure = std::current_exception();
                next = order.size();
            }
        }
    };
    std::vector<std::thread> workers;
    for (int k = 1; k < jobs; ++k) workers.emplace_back(work);
    work();
    for (std::thread& worker : workers) worker.join();
    if (failure) std::rethrow_exception(failure);
}

/// Prints a table, writes DIR/stress.json and a picture of each instability to DIR/stress/. Returns whether
/// the default scheme survived every sensible setting.
bool run_cases(const StressOptions& options, const fs::path& directory) {
    const std::vector<Case> cases = cases_named(options.cases);
    std::vector<Task> tasks = tasks_of(cases, options.fast, directory);
    if (tasks.empty()) throw InputError("--fast leaves none of these cases: they have no quick setting");
    read_stress(directory);  // a damaged file is refused now rather than after all runs
    make_directories(directory / "stress");
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    run_all(tasks, directory, options.jobs > 0 ? options.jobs : cores);
    const auto required =
        std::count_if(tasks.begin(), tasks.end(), [](const Task& task) { return task.required; });
    const auto survived = std::count_if(tasks.begin(), tasks.end(),
                                        [](const Task& task) { return task.required && task.row.survived; });
    fmt::print("the default scheme survived {} of {} sensible settings\n", survived, required);
    return survived == required;
}

int stress_command(const StressOptions& options) {
    const fs::path directory =
        options.directory.empty() ? fs::path("results") / "stress" : fs::path(options.directory);
    const bool survived = run_cases(options, directory);
    make_report(directory);
    fmt::print("report: {}\n", (directory / "index.html").string());
    return survived ? exit_done : exit_outside;
}

}  // namespace

void add_stress(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<StressOptions>();
    CLI::App& command = *app.add_subcommand("stress",
                                            "hard cases with the default scheme, the scheme of Yang et al. "
                                            "(2020) and a scheme without dissipation: which "
                                            "settings survive, and where the limits of stability lie");
    add_only(command, options->cases, "cases", "CASE");
    add_out(command, options->directory, "results/stress");
    add_jobs(command, options->jobs);
    command.add_flag("--fast", options->fast,
                     "only the quick settings with the default scheme, without a search for limits");
    command.callback([options, &exit_code] { exit_code = stress_command(*options); });
}

}  // namespace wetdeck
