// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/child_process.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

/// A file that stands while a suite is submitted. It stays where a job may have been submitted whose number
/// is not written down: nobody can then know whether jobs work in these folders.
class SubmissionMark {
  public:
    /// Throws EnvironmentError where another submission has left its own.
    explicit SubmissionMark(fs::path file) : file_(std::move(file)) {
        std::FILE* made = std::fopen(file_.c_str(), "wx");
        if (!made)
            throw EnvironmentError(
                fmt::format("{}: {}; where no other submission of this suite is under way, cancel its jobs "
                            "(squeue -n wetdeck) and remove the file",
                            file_.string(),
                            errno == EEXIST ? "a submission has not come to its end" : system_reason(errno)));
        std::fclose(made);
    }
    ~SubmissionMark() {
        std::error_code ignored;
        if (!in_doubt_) fs::remove(file_, ignored);
    }
    SubmissionMark(const SubmissionMark&) = delete;
    SubmissionMark& operator=(const SubmissionMark&) = delete;
    void set_in_doubt(bool value) { in_doubt_ = value; }

  private:
    fs::path file_;
    bool in_doubt_ = false;
};

/// What sbatch says beside the number is kept in sbatch.log: sites print messages there.
/// @return the number of the job
std::string submit(const std::string& arguments, const fs::path& folder, SubmissionMark& mark) {
    const fs::path log = folder / "sbatch.log";
    mark.set_in_doubt(true);
    const ShellResult result =
        run_in_shell("sbatch --parsable " + arguments + " 2>" + shell_quoted(log.string()));
    if (!result.succeeded()) {
        mark.set_in_doubt(false);
        std::string reason;
        std::ifstream said(log);
        std::getline(said >> std::ws, reason);
        throw EnvironmentError("Slurm does not accept the job: " +
                               (reason.empty() ? first_line(result.output) : reason));
    }
    const std::string job = result.output.substr(0, result.output.find(';'));
    if (job.empty() || job.find_first_not_of("0123456789") != std::string::npos)
        throw EnvironmentError(fmt::format(
            "sbatch printed '{}' in place of the number of a job, which may run all the same; see {}",
            first_line(result.output), log.string()));
    return job;
}

/// The jobs of the last submission that Slurm still lists as queued or running.
std::string jobs_left(const fs::path& file) {
    std::ifstream in(file);
    std::string jobs;
    if (!std::getline(in, jobs) || jobs.find_first_not_of("0123456789,") != std::string::npos) return "";
    const ShellResult result = run_in_shell("squeue -h -o %i -j " + jobs + " 2>/dev/null");
    return result.succeeded() ? result.output : "";  // for jobs that ended long ago squeue reports an error
}

std::string this_program() {
    return shell_quoted(fs::read_symlink("/proc/self/exe").string());
}

/// The rows that are not done: their numbers in the plan and their costs.
struct RowsLeft {
    std::vector<std::size_t> numbers;
    std::vector<double> costs;
};

RowsLeft rows_left(const std::vector<SuiteRow>& rows, bool fresh) {
    RowsLeft left;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        if (!fresh && finished(rows[n])) continue;
        left.numbers.push_back(n);
        left.costs.push_back(rows[n].estimated_core_seconds);
    }
    return left;
}

/// The script of every array task: it runs the rows of its own number and ends with the worst exit code.
std::string task_script(const std::vector<std::vector<std::size_t>>& tasks,
                        const std::vector<std::size_t>& numbers, const std::string& command) {
    std::string script = "#!/bin/sh\ncase $SLURM_ARRAY_TASK_ID in\n";
    for (std::size_t task = 0; task < tasks.size(); ++task) {
        script += fmt::format("{}) rows='", task);
        for (const std::size_t n : tasks[task]) script += fmt::format("{} ", numbers[n]);
        script += "';;\n";
    }
    return script + "esac\nworst=0\nfor row in $rows; do\n    " + command +
           " --row $row || worst=$?\ndone\nexit $worst\n";
}

}  // namespace

std::vector<std::vector<std::size_t>> grouped(const std::vector<double>& core_seconds) {
    constexpr double worth_a_task = 180;  // against some seconds that Slurm needs to start one
    std::vector<std::vector<std::size_t>> tasks;
    double in_last = worth_a_task;
    for (std::size_t n = 0; n < core_seconds.size(); ++n) {
        if (in_last + core_seconds[n] > worth_a_task) {
            tasks.emplace_back();
            in_last = 0;
        }
        tasks.back().push_back(n);
        in_last += core_seconds[n];
    }
    return tasks;
}

std::string suite_arguments(const PlanOptions& plan, const RowOptions& row) {
    std::string command =
        fmt::format("suite --tier {} --out {} --threads {} --checkpoint-interval {}", shell_quoted(plan.tier),
                    shell_quoted(fs::absolute(plan.directory).string()), std::max(1, row.threads),
                    row.checkpoint_interval);
    std::string scenes;
    for (const std::string& scene : plan.scenes) {
        const bool file = fs::exists(scene);
        scenes += (scenes.empty() ? "" : ",") + (file ? fs::absolute(scene).string() : scene);
    }
    if (!scenes.empty()) command += " --only " + shell_quoted(scenes);
    command += fmt::format(" --fields {}", name_of(row.fields));
    if (plan.replicates) command += fmt::format(" --replicates {}", *plan.replicates);
    if (row.fresh) command += " --fresh";
    return command;
}

void submit_rows(const std::vector<SuiteRow>& rows, const fs::path& directory, const std::string& arguments,
                 const SlurmOptions& options) {
    const fs::path folder = fs::absolute(directory) / "slurm";
    if (!program_found("sbatch"))
        throw EnvironmentError(
            "--executor slurm: there is no sbatch on this machine; without the option the suite runs here");
    make_directories(folder);
    SubmissionMark mark(folder / "submitting");
    if (const std::string jobs = jobs_left(folder / "jobs"); !jobs.empty())
        throw EnvironmentError(fmt::format("{}: jobs of this suite are still queued or running: {}",
                                           folder.string(), first_line(jobs)));
    const RowsLeft left = rows_left(rows, options.row.fresh);
    const auto tasks = grouped(left.costs);
    atomic_write(folder / "task.sh", task_script(tasks, left.numbers, this_program() + " " + arguments));

    const std::string partition =
        options.partition.empty() ? "" : "-p " + shell_quoted(options.partition) + " ";
    const auto output = [&](const char* name) {
        return "-o " + shell_quoted((folder / name).string()) + " ";
    };
    std::string dependency, jobs;
    if (!tasks.empty()) {
        const std::string limit = options.concurrent > 0 ? fmt::format("%{}", options.concurrent) : "";
        jobs = submit(fmt::format("-J wetdeck --array=0-{}{} -c {} {}{}{}", tasks.size() - 1, limit,
                                  std::max(1, options.row.threads), partition, output("task_%a.log"),
                                  shell_quoted((folder / "task.sh").string())),
                      folder, mark);
        atomic_write(folder / "jobs", jobs + "\n");
        mark.set_in_doubt(false);
        dependency = "--dependency=afterany:" + jobs + " ";
    }
    const std::string report =
        fmt::format("{} report {}", this_program(), shell_quoted(fs::absolute(directory).string()));
    const std::string report_job = submit("-J wetdeck-report " + dependency + partition +
                                              output("report.log") + "--wrap " + shell_quoted(report),
                                          folder, mark);
    atomic_write(folder / "jobs", (jobs.empty() ? "" : jobs + ",") + report_job + "\n");
    mark.set_in_doubt(false);
    fmt::print("{} of {} runs submitted in {} tasks{}, the report as job {}\n", left.numbers.size(),
               rows.size(), tasks.size(), jobs.empty() ? "" : " of job " + jobs, report_job);
}

}  // namespace wetdeck
