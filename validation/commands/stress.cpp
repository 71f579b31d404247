// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <thread>

#include "solver/core/errors.hpp"
#include "validation/metrics/stored_tables.hpp"
#include "validation/scene/schemes.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/stress/bisect.hpp"
#include "validation/stress/cases.hpp"

namespace wetdeck {
namespace {

using namespace stress;
namespace fs = std::filesystem;

/// One row of the table, and how to find it.
struct Task {
    StressRow row;
    bool judged = false;  ///< the default scheme on a sensible setting
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
    } catch (const InputError& refusal) {  // by the scheme: it has no answer for this setting
        row.note = std::string("refused: ") + refusal.what();
        return;
    }
    row.survived = outcome->survived();
    row.note = outcome->note();
    if (!setting.beyond.empty()) row.note += " [not asked for: " + setting.beyond + "]";
    if (!outcome->death) return;
    const std::vector<unsigned char> picture = picture_of(*outcome->death);
    row.picture = (fs::path("stress") / file_name(row)).string();
    atomic_write(directory / row.picture, {reinterpret_cast<const char*>(picture.data()), picture.size()});
}

void run_search(StressRow& row, const Search& search) {
    std::string death;
    const Limit limit = find_limit(search.from, search.to, search.ratio, [&](double value) {
        const Outcome outcome = run_trial(search.build(value));
        if (outcome.death) death = outcome.note();
        return outcome.survived();
    });
    const auto margin = [&](double value) { return std::max(value / search.from, search.from / value); };
    row.survived = limit.alive.has_value();
    if (!limit.alive) {
        row.note = fmt::format("dies at {:g}, where it is used: {}", search.from, death);
    } else if (!limit.dead) {
        row.note =
            fmt::format("in use {:g}, survives to the end of the search at {:.3g}: margin above {:.3g}",
                        search.from, *limit.alive, margin(*limit.alive));
    } else {
        row.note = fmt::format("in use {:g}, survives {:.3g}, not {:.3g}: margin {:.3g}; {}", search.from,
                               *limit.alive, *limit.dead, margin(*limit.alive), death);
    }
}

std::vector<Task> tasks_of(const std::vector<Case>& cases, const StressOptions& options) {
    std::vector<Task> tasks;
    std::vector<Scheme> schemes = scheme_names();
    schemes.insert(schemes.begin(), default_scheme);
    for (const Case& member : cases) {
        for (const Setting& setting : member.settings) {
            for (const Scheme& scheme : schemes) {
                if (options.fast && (!setting.quick || !scheme.empty())) continue;
                const bool standard = scheme.empty();
                tasks.push_back({{member.name, setting.name + (standard ? "" : ", " + scheme), false, "", ""},
                                 standard && setting.beyond.empty(),
                                 [&setting, scheme, &options](StressRow& row) {
                                     run_setting(row, setting, scheme, options.directory);
                                 }});
            }
        }
        if (options.fast) continue;
        for (const Search& search : member.searches)
            tasks.push_back(
                {{member.name, fmt::format("limit of {}: {}", search.name, search.quantity), false, "", ""},
                 true,
                 [&search](StressRow& row) { run_search(row, search); }});
    }
    return tasks;
}

/// Rows of cases that were not run as the file holds them, then those that are done.
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

/// Each on one thread, several at a time, those that decide first. What is done is kept if the rest is
/// stopped.
void run_all(std::vector<Task>& tasks, const StressOptions& options, int jobs) {
    std::vector<Task*> order;
    for (Task& task : tasks) order.push_back(&task);
    std::stable_partition(order.begin(), order.end(), [](const Task* task) { return task->judged; });
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t k = next++; k < order.size(); k = next++) {
            Task& task = *order[k];
            try {
                const auto start = std::chrono::steady_clock::now();
                task.run(task.row);
                const double seconds =
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                const std::scoped_lock lock(mutex);
                task.done = true;
                store(options.directory, tasks);
                fmt::print("{} {:20} {:44} {:6.1f} s  {}\n", task.row.survived ? "  " : "X ",
                           task.row.stress_case, task.row.setting, seconds, task.row.note);
                std::fflush(stdout);
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

}  // namespace

bool run_stress(const StressOptions& options) {
    const std::vector<Case> cases = cases_named(options.cases);
    std::vector<Task> tasks = tasks_of(cases, options);
    if (tasks.empty()) throw InputError("--fast leaves none of these cases: they have no quick setting");
    read_stress(options.directory);  // rather now than when all has run
    make_directories(options.directory / "stress");
    run_all(
        tasks, options,
        options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
    const auto judged =
        std::count_if(tasks.begin(), tasks.end(), [](const Task& task) { return task.judged; });
    const auto alive = std::count_if(tasks.begin(), tasks.end(),
                                     [](const Task& task) { return task.judged && task.row.survived; });
    fmt::print("the default scheme survived {} of {} sensible settings\n", alive, judged);
    return alive == judged;
}

}  // namespace wetdeck
