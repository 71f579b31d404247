// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/suite.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <omp.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/progress.hpp"
#include "validation/run/run.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_directory.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

constexpr int exit_unstable = 3, exit_environment = 4;

std::string identity_of(const SuiteRow& row) {
    const Scene scene = read_scene(find_scene(row.scene), row.variant, row.overrides);
    RunOptions options;
    options.particle_spacing = row.particle_spacing;
    options.until = row.until;
    return identity_of(scene, options);
}

/// Starts this program again for one row, with its output in a file of the run's directory.
pid_t start(const SuiteRow& row, int threads, const SuiteOptions& options) {
    make_directories(row.directory);
    const std::string log = (row.directory / "run.log").string();
    const std::string spacing = fmt::format("{}", row.particle_spacing);
    const std::string thread_text = std::to_string(threads);
    const std::string directory = row.directory.string();
    const std::string interval = fmt::format("{}", options.checkpoint_interval);
    std::vector<std::string> arguments = {"wetdeck",   "run",   row.scene, "--variant",
                                          row.variant, "--dx",  spacing,   "--threads",
                                          thread_text, "--out", directory, "--checkpoint-interval",
                                          interval};
    if (options.fresh || !interrupted(row)) arguments.emplace_back("--replace");
    if (row.until) {
        arguments.emplace_back("--until");
        arguments.push_back(fmt::format("{}", *row.until));
    }
    for (const std::string& assignment : row.overrides) {
        arguments.emplace_back("--set");
        arguments.push_back(assignment);
    }
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t parent = getpid();
    // A signal that comes before the run can answer it must wait for it.
    sigset_t term, before;
    sigemptyset(&term);
    sigaddset(&term, SIGTERM);
    sigprocmask(SIG_BLOCK, &term, &before);
    const pid_t child = fork();
    if (child != 0) sigprocmask(SIG_SETMASK, &before, nullptr);
    if (child < 0) throw environment_error(log, "start a run", errno);
    if (child == 0) {
        // a run must not outlive its suite: the next one would find the directory locked
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (getppid() != parent) _exit(exit_environment);
        // Ctrl-C reaches the whole group; the suite alone answers and passes SIGTERM on
        signal(SIGINT, SIG_IGN);
        signal(SIGTERM, SIG_DFL);
        sigprocmask(SIG_SETMASK, &before, nullptr);
        const int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
        const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
        if (in < 0 || out < 0) _exit(exit_environment);
        dup2(in, STDIN_FILENO);
        dup2(out, STDOUT_FILENO);
        dup2(out, STDERR_FILENO);
        execv("/proc/self/exe", argv.data());
        _exit(exit_environment);
    }
    return child;
}

/// What one finished child means for the suite.
int judge(const SuiteRow& row, int status) {
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : exit_environment;
    if (code == exit_unstable) {
        fmt::print("  {}: became unstable, see run.log in {}\n", row_name(row), row.directory.string());
        return row.expected_unstable ? 0 : exit_unstable;
    }
    if (code != 0)
        fmt::print("  {}: failed with code {}, see {}\n", row_name(row), code,
                   (row.directory / "run.log").string());
    return code;
}

void add_sensitivity_rows(std::vector<SuiteRow>& rows, const SuiteOptions& options, const std::string& name,
                          const Scene& scene, const std::vector<double>& spacings) {
    if (spacings.empty()) return;
    const double dx = spacings[spacings.size() / 2];
    for (const SensitivitySpec& spec : scene.analysis.sensitivities) {
        for (const double value : {spec.low, spec.high}) {
            const std::string assignment = fmt::format("{}={}", spec.key, value);
            const Scene varied = read_scene(find_scene(name), scene.variant, {assignment});
            rows.push_back({name,
                            scene.variant,
                            dx,
                            estimate_cost(varied, dx).core_seconds,
                            {assignment},
                            sensitivity_path(options.directory, scene.name(), assignment)});
        }
    }
}

/// The rows to look at: all, or the one that was asked for.
std::vector<SuiteRow> chosen_rows(const SuiteOptions& options) {
    const std::vector<SuiteRow> rows = suite_rows(options);
    if (!options.row) return rows;
    if (*options.row >= rows.size())
        throw InputError(
            fmt::format("--row is {}, expected one of 0 to {}, see --plan", *options.row, rows.size() - 1));
    return {rows[*options.row]};
}

}  // namespace

fs::path sensitivity_path(const fs::path& directory, const std::string& scene,
                          const std::string& assignment) {
    return directory / "sensitivity" / scene / assignment;
}

bool finished(const SuiteRow& row) {
    return holds_finished_run(row.directory) && identity_in(row.directory) == identity_of(row);
}

bool interrupted(const SuiteRow& row) {
    if (holds_finished_run(row.directory) || identity_in(row.directory) != identity_of(row)) return false;
    try {
        return newest_checkpoint(row.directory).has_value();
    } catch (const DataError&) {  // all are damaged
        return false;
    }
}

std::string row_name(const SuiteRow& row) {
    const std::string name = fmt::format("{} {} dx {}", row.scene, row.variant, row.particle_spacing);
    if (row.overrides.empty()) return name;
    return name + " " +
           (row.overrides.size() == 1 ? row.overrides.front() : row.directory.filename().string());
}

void print_plan(const SuiteOptions& options, bool as_json) {
    double total = 0;
    nlohmann::json plan = nlohmann::json::array();
    if (!as_json) fmt::print("{:>4}  {:>10}  {:>11}  {}\n", "row", "core s", "state", "run");
    for (const SuiteRow& row : suite_rows(options)) {
        const char* state = finished(row) ? "done" : interrupted(row) ? "interrupted" : "to do";
        if (!finished(row)) total += row.estimated_core_seconds;
        plan.push_back({{"row", plan.size()},
                        {"scene", row.scene},
                        {"variant", row.variant},
                        {"dx", row.particle_spacing},
                        {"overrides", row.overrides},
                        {"core_s", row.estimated_core_seconds},
                        {"state", state},
                        {"directory", row.directory.string()}});
        if (as_json) continue;
        fmt::print("{:>4}  {:>10.4g}  {:>11}  {}\n", plan.size() - 1, row.estimated_core_seconds, state,
                   row_name(row));
    }
    if (as_json) {
        const nlohmann::json all = {{"tier", options.tier}, {"core_s_left", total}, {"rows", plan}};
        return fmt::print("{}\n", all.dump(1));
    }
    fmt::print("about {} of one core are left to be done\n", duration_text(total));
}

fs::path run_path(const fs::path& directory, const std::string& scene, const std::string& variant,
                  double particle_spacing) {
    return directory / "runs" / scene / variant / fmt::format("dx{}", particle_spacing);
}

std::vector<SuiteRow> suite_rows(const SuiteOptions& options) {
    std::vector<SuiteRow> rows;
    for (const std::string& name : options.scenes.empty() ? scene_names() : options.scenes) {
        const fs::path path = find_scene(name);
        const Scene scene = read_scene(path);
        const auto tier = scene.tiers.find(options.tier);
        if (tier == scene.tiers.end()) {
            throw InputError(fmt::format("{}: no tier '{}', expected quick, standard or paper", path.string(),
                                         options.tier));
        }
        for (const auto& [variant, spacings] : tier->second) {
            const Scene varied = read_scene(path, variant);
            for (const double dx : spacings) {
                check_row(varied, options.tier, dx);
                rows.push_back({name,
                                variant,
                                dx,
                                estimate_cost(varied, dx).core_seconds,
                                {},
                                run_path(options.directory, scene.name(), variant, dx),
                                {},
                                varied.analysis.expected_unstable});
            }
        }
        const auto spacings = tier->second.find(scene.variant);
        if (spacings != tier->second.end())
            add_sensitivity_rows(rows, options, name, scene, spacings->second);
    }
    std::stable_sort(rows.begin(), rows.end(), [](const SuiteRow& a, const SuiteRow& b) {
        return a.estimated_core_seconds > b.estimated_core_seconds;
    });
    return rows;
}

int run_suite(const SuiteOptions& options) {
    return run_rows(chosen_rows(options), options);
}

int run_rows(const std::vector<SuiteRow>& rows, const SuiteOptions& options) {
    const auto say = [&](const std::string& line) {
        if (options.quiet) return;
        fmt::print("{}", line);
        std::fflush(stdout);
    };
    std::vector<SuiteRow> waiting;
    for (const SuiteRow& row : rows) {
        if (!options.fresh && finished(row)) {
            say(fmt::format("  {}: finished before, reused\n", row_name(row)));
        } else {
            waiting.push_back(row);
        }
    }
    double total = 0, done = 0;
    for (const SuiteRow& row : waiting) total += row.estimated_core_seconds;
    const int cores = omp_get_num_procs();
    const int jobs = options.jobs > 0 ? options.jobs : cores;
    const int threads = options.threads > 0 ? options.threads : std::max(1, cores / jobs);
    say(fmt::format("{} runs to do, about {} on {} cores\n", waiting.size(), duration_text(total / cores),
                    cores));

    Progress progress("suite", options.quiet);
    using Clock = std::chrono::steady_clock;
    struct Running {
        SuiteRow row;
        Clock::time_point since;
    };
    std::map<pid_t, Running> running;
    // what runs has done as much as its time would, but is not done before it ends
    const auto share_done = [&] {
        double sum = done;
        for (const auto& [child, run] : running) {
            const std::chrono::duration<double> elapsed = Clock::now() - run.since;
            sum += std::min(0.95 * run.row.estimated_core_seconds, threads * elapsed.count());
        }
        return total > 0 ? sum / total : 0;
    };
    int worst = 0;
    std::size_t next = 0, ended = 0;
    bool told = false;  // the runs, to stop
    while ((next < waiting.size() && stop_signal() == 0) || !running.empty()) {
        if (stop_signal() != 0 && !told) {
            for (const auto& [child, run] : running) kill(child, SIGTERM);
            told = true;
        }
        while (next < waiting.size() && stop_signal() == 0 &&
               running.size() < static_cast<std::size_t>(jobs)) {
            const SuiteRow& row = waiting[next++];
            running.emplace(start(row, threads, options), Running{row, Clock::now()});
        }
        int status = 0;
        const pid_t child = waitpid(-1, &status, WNOHANG);
        if (child <= 0) {
            usleep(100'000);
            progress.update(share_done(), fmt::format("{} of {} runs", ended, waiting.size()));
            continue;
        }
        const SuiteRow row = running.at(child).row;
        running.erase(child);
        const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
        if (told && code == 128 + SIGTERM) continue;  // as it was told
        const int verdict = judge(row, status);
        worst = std::max(worst, verdict);
        done += row.estimated_core_seconds;
        ++ended;
        if (code == 0) say(fmt::format("  {}: done ({} of {})\n", row_name(row), ended, waiting.size()));
    }
    if (const int signal = stop_signal(); signal != 0)
        throw Interrupted(
            signal, fmt::format(" with {} of {} runs done; the same command goes on", ended, waiting.size()));
    return worst;
}

}  // namespace wetdeck
