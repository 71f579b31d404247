// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/child_process.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

/// The number of the job that a submission names.
std::string submit(const std::string& arguments) {
    const ShellResult answer = run_in_shell("sbatch --parsable " + arguments);
    const std::string job = answer.output.substr(0, answer.output.find(';'));
    const bool number = !job.empty() && job.find_first_not_of("0123456789") == std::string::npos;
    if (!answer.succeeded() || !number)
        throw EnvironmentError("Slurm does not take the job: " +
                               answer.output.substr(0, answer.output.find('\n')));
    return job;
}

/// The jobs of the last submission that Slurm still knows.
std::string still_at_work(const fs::path& file) {
    std::ifstream in(file);
    std::string jobs;
    if (!std::getline(in, jobs) || jobs.find_first_not_of("0123456789,") != std::string::npos) return "";
    const ShellResult answer = run_in_shell("squeue -h -o %i -j " + jobs);
    return answer.succeeded() ? answer.output : "";  // Slurm forgets jobs that have ended: an error, too
}

std::string suite_command(const SuiteOptions& options) {
    std::string command =
        fmt::format("{} suite --tier {} --out {} --threads {} --checkpoint-interval {}",
                    shell_quoted(fs::read_symlink("/proc/self/exe").string()), shell_quoted(options.tier),
                    shell_quoted(fs::absolute(options.directory).string()), std::max(1, options.threads),
                    options.checkpoint_interval);
    std::string scenes;
    for (const std::string& scene : options.scenes) {
        const bool file = fs::exists(scene);
        scenes += (scenes.empty() ? "" : ",") + (file ? fs::absolute(scene).string() : scene);
    }
    if (!scenes.empty()) command += " --only " + shell_quoted(scenes);
    if (options.fresh) command += " --fresh";
    return command;
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

void submit_suite(const SuiteOptions& options, const SlurmOptions& slurm) {
    const fs::path folder = fs::absolute(options.directory) / "slurm";
    if (!program_found("sbatch"))
        throw EnvironmentError(
            "--executor slurm: there is no sbatch on this machine; leave the option away to "
            "run here");
    if (const std::string jobs = still_at_work(folder / "jobs"); !jobs.empty())
        throw EnvironmentError(fmt::format("{}: jobs of this suite are still at work: {}", folder.string(),
                                           jobs.substr(0, jobs.find('\n'))));
    std::vector<std::size_t> numbers;
    std::vector<double> costs;
    const std::vector<SuiteRow> rows = suite_rows(options);
    for (std::size_t n = 0; n < rows.size(); ++n) {
        if (!options.fresh && finished(rows[n])) continue;
        numbers.push_back(n);
        costs.push_back(rows[n].estimated_core_seconds);
    }
    const auto tasks = grouped(costs);
    make_directories(folder);
    std::string script = "#!/bin/sh\ncase $SLURM_ARRAY_TASK_ID in\n";
    for (std::size_t task = 0; task < tasks.size(); ++task) {
        script += fmt::format("{}) rows='", task);
        for (const std::size_t n : tasks[task]) script += fmt::format("{} ", numbers[n]);
        script += "';;\n";
    }
    script += "esac\nworst=0\nfor row in $rows; do\n    " + suite_command(options) +
              " --row $row || worst=$?\ndone\nexit $worst\n";
    atomic_write(folder / "task.sh", script);
    const std::string partition = slurm.partition.empty() ? "" : "-p " + shell_quoted(slurm.partition) + " ";
    const auto output = [&](const char* name) {
        return "-o " + shell_quoted((folder / name).string()) + " ";
    };
    std::string dependency, jobs;
    if (!tasks.empty()) {
        const std::string limit = slurm.concurrent > 0 ? fmt::format("%{}", slurm.concurrent) : "";
        jobs = submit(fmt::format("-J wetdeck --array=0-{}{} -c {} {}{}{}", tasks.size() - 1, limit,
                                  std::max(1, options.threads), partition, output("task_%a.log"),
                                  shell_quoted((folder / "task.sh").string())));
        dependency = "--dependency=afterany:" + jobs + " ";
    }
    const std::string report =
        fmt::format("{} report {}", shell_quoted(fs::read_symlink("/proc/self/exe").string()),
                    shell_quoted(fs::absolute(options.directory).string()));
    const std::string collector = submit("-J wetdeck-report " + dependency + partition +
                                         output("report.log") + "--wrap " + shell_quoted(report));
    atomic_write(folder / "jobs", (jobs.empty() ? "" : jobs + ",") + collector + "\n");
    fmt::print("{} of {} runs submitted in {} tasks{}, the report as job {}\n", numbers.size(), rows.size(),
               tasks.size(), jobs.empty() ? "" : " of job " + jobs, collector);
}

}  // namespace wetdeck
