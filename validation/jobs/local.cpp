// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/local.hpp"

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

#include "validation/run/exit_code.hpp"
#include "validation/run/progress.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The command line of this program that runs one row.
std::vector<std::string> arguments_of(const SuiteRow& row, const RowOptions& options) {
    std::vector<std::string> arguments = {"wetdeck",
                                          "run",
                                          row.scene,
                                          "--variant",
                                          row.variant,
                                          "--dx",
                                          fmt::format("{}", row.particle_spacing),
                                          "--threads",
                                          std::to_string(options.threads),
                                          "--out",
                                          row.directory.string(),
                                          "--checkpoint-interval",
                                          fmt::format("{}", options.checkpoint_interval)};
    arguments.emplace_back("--fields");
    arguments.emplace_back(name_of(fields_of(row, options)));
    if (options.fresh || !interrupted(row)) arguments.emplace_back("--replace");
    if (row.until) {
        arguments.emplace_back("--until");
        arguments.push_back(fmt::format("{}", *row.until));
    }
    for (const std::string& assignment : row.overrides) {
        arguments.emplace_back("--set");
        arguments.push_back(assignment);
    }
    return arguments;
}

/// In the child process: becomes the run.
[[noreturn]] void become_run(pid_t parent, const char* log, const sigset_t& mask, char* const* argv) {
    // a run must not outlive its suite: the next one would find the directory locked
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(exit_environment);
    // Ctrl-C reaches the whole group; the suite alone answers and passes SIGTERM on
    signal(SIGINT, SIG_IGN);
    signal(SIGTERM, SIG_DFL);
    sigprocmask(SIG_SETMASK, &mask, nullptr);
    const int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
    const int out = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (in < 0 || out < 0) _exit(exit_environment);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    execv("/proc/self/exe", argv);
    _exit(exit_environment);
}

/// Starts this program again for one row, with its output in a file of the run's directory.
pid_t start(const SuiteRow& row, const RowOptions& options) {
    make_directories(row.directory);
    const std::string log = (row.directory / "run.log").string();
    std::vector<std::string> arguments = arguments_of(row, options);
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
    if (child == 0) become_run(parent, log.c_str(), before, argv.data());
    sigprocmask(SIG_SETMASK, &before, nullptr);
    if (child < 0) throw environment_error(log, "start a run", errno);
    return child;
}

/// What the end of one row means for the suite.
int judge(const SuiteRow& row, int status) {
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : exit_environment;
    if (code == exit_unstable) {
        fmt::print("  {}: became unstable{}, see run.log in {}\n", row_name(row),
                   row.expected_unstable ? " as expected" : "", row.directory.string());
        return row.expected_unstable ? 0 : exit_unstable;
    }
    if (code != 0)
        fmt::print("  {}: failed with code {}, see {}\n", row_name(row), code,
                   (row.directory / "run.log").string());
    return code;
}

class Pool {
  public:
    Pool(const std::vector<SuiteRow>& rows, const LocalOptions& options)
        : options_(options), cores_(omp_get_num_procs()), progress_("suite", options.quiet) {
        if (options_.jobs == 0) options_.jobs = cores_;
        if (options_.row.threads == 0) options_.row.threads = std::max(1, cores_ / options_.jobs);
        for (const SuiteRow& row : rows) {
            if (!options.row.fresh && finished(row)) {
                print(fmt::format("  {}: finished before, reused\n", row_name(row)));
            } else {
                waiting_.push_back(row);
            }
        }
        total_ = estimated_core_seconds(waiting_);
        double bytes = 0;
        for (const SuiteRow& row : waiting_) bytes += estimated_bytes(row, options_.row);
        print(fmt::format("{} runs to do, about {} on {} cores and {:.2g} GB on the disk\n", waiting_.size(),
                          duration_text(total_ / cores_), cores_, 1e-9 * bytes));
    }

    int run() {
        while (rows_left() || !running_.empty()) {
            if (stop_signal() != 0 && !stopping_) stop_runs();
            while (rows_left() && running_.size() < static_cast<std::size_t>(options_.jobs)) {
                const SuiteRow& row = waiting_[next_++];
                running_.emplace(start(row, options_.row), Running{row, Clock::now()});
            }
            int status = 0;
            const pid_t child = waitpid(-1, &status, WNOHANG);
            if (child > 0) {
                collect(child, status);
                continue;
            }
            usleep(100'000);
            progress_.update(share_done(), fmt::format("{} of {} runs", ended_, waiting_.size()));
        }
        if (const int signal = stop_signal(); signal != 0)
            throw Interrupted(signal, fmt::format(" with {} of {} runs done; the same command continues",
                                                  ended_, waiting_.size()));
        return worst_;
    }

  private:
    struct Running {
        SuiteRow row;
        Clock::time_point since;
    };

    void print(const std::string& line) const {
        if (options_.quiet) return;
        fmt::print("{}", line);
        std::fflush(stdout);
    }

    bool rows_left() const { return next_ < waiting_.size() && stop_signal() == 0; }

    void stop_runs() {
        for (const auto& [child, run] : running_) kill(child, SIGTERM);
        stopping_ = true;
    }

    void collect(pid_t child, int status) {
        const SuiteRow row = running_.at(child).row;
        running_.erase(child);
        const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
        if (stopping_ && code == 128 + SIGTERM) return;
        worst_ = std::max(worst_, judge(row, status));
        done_ += row.estimated_core_seconds;
        ++ended_;
        if (code == 0) print(fmt::format("  {}: done ({} of {})\n", row_name(row), ended_, waiting_.size()));
    }

    /// By the estimates; a run that is still going counts by its time, but never as done.
    double share_done() const {
        double sum = done_;
        for (const auto& [child, run] : running_) {
            const std::chrono::duration<double> elapsed = Clock::now() - run.since;
            sum += std::min(0.95 * run.row.estimated_core_seconds, options_.row.threads * elapsed.count());
        }
        return total_ > 0 ? sum / total_ : 0;
    }

    LocalOptions options_;
    int cores_;
    Progress progress_;
    std::vector<SuiteRow> waiting_;
    std::map<pid_t, Running> running_;
    double total_ = 0, done_ = 0;  ///< estimated core seconds
    std::size_t next_ = 0, ended_ = 0;
    int worst_ = 0;
    bool stopping_ = false;
};

}  // namespace

int run_rows(const std::vector<SuiteRow>& rows, const LocalOptions& options) {
    return Pool(rows, options).run();
}

}  // namespace wetdeck
