// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

/// For the shell: in single quotes, whatever it holds.
std::string in_quotes(const std::string& text) {
    std::string result = "'";
    for (const char letter : text) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return result + "'";
}

struct Answer {
    int status = 0;
    std::string text;  ///< of stdout and stderr, without the last line's end
};

Answer ask(const std::string& command) {
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw EnvironmentError("cannot start a shell for: " + command);
    Answer answer;
    std::array<char, 512> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) answer.text += buffer.data();
    answer.status = ::pclose(pipe);
    while (answer.text.ends_with('\n')) answer.text.pop_back();
    return answer;
}

/// The number of the job that a submission names.
std::string submit(const std::string& arguments) {
    const Answer answer = ask("sbatch --parsable " + arguments);
    const std::string job = answer.text.substr(0, answer.text.find(';'));
    const bool number = !job.empty() && job.find_first_not_of("0123456789") == std::string::npos;
    if (answer.status != 0 || !number)
        throw EnvironmentError("Slurm does not take the job: " +
                               answer.text.substr(0, answer.text.find('\n')));
    return job;
}

/// The jobs of the last submission that Slurm still knows.
std::string still_at_work(const fs::path& file) {
    std::ifstream in(file);
    std::string jobs;
    if (!std::getline(in, jobs) || jobs.find_first_not_of("0123456789,") != std::string::npos) return "";
    const Answer answer = ask("squeue -h -o %i -j " + jobs);
    return answer.status == 0 ? answer.text : "";  // Slurm forgets jobs that have ended: an error, too
}

std::string suite_command(const SuiteOptions& options) {
    std::string command =
        fmt::format("{} suite --tier {} --out {} --threads {} --checkpoint-interval {}",
                    in_quotes(fs::read_symlink("/proc/self/exe").string()), in_quotes(options.tier),
                    in_quotes(fs::absolute(options.directory).string()), std::max(1, options.threads),
                    options.checkpoint_interval);
    std::string scenes;
    for (const std::string& scene : options.scenes) {
        const bool file = fs::exists(scene);
        scenes += (scenes.empty() ? "" : ",") + (file ? fs::absolute(scene).string() : scene);
    }
    if (!scenes.empty()) command += " --only " + in_quotes(scenes);
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
    if (ask("command -v sbatch").status != 0)
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
    const std::string partition = slurm.partition.empty() ? "" : "-p " + in_quotes(slurm.partition) + " ";
    const auto output = [&](const char* name) { return "-o " + in_quotes((folder / name).string()) + " "; };
    std::string dependency, jobs;
    if (!tasks.empty()) {
        const std::string limit = slurm.concurrent > 0 ? fmt::format("%{}", slurm.concurrent) : "";
        jobs = submit(fmt::format("-J wetdeck --array=0-{}{} -c {} {}{}{}", tasks.size() - 1, limit,
                                  std::max(1, options.threads), partition, output("task_%a.log"),
                                  in_quotes((folder / "task.sh").string())));
        dependency = "--dependency=afterany:" + jobs + " ";
    }
    const std::string report =
        fmt::format("{} report {}", in_quotes(fs::read_symlink("/proc/self/exe").string()),
                    in_quotes(fs::absolute(options.directory).string()));
    const std::string collector = submit("-J wetdeck-report " + dependency + partition +
                                         output("report.log") + "--wrap " + in_quotes(report));
    atomic_write(folder / "jobs", (jobs.empty() ? "" : jobs + ",") + collector + "\n");
    fmt::print("{} of {} runs submitted in {} tasks{}, the report as job {}\n", numbers.size(), rows.size(),
               tasks.size(), jobs.empty() ? "" : " of job " + jobs, collector);
}

}  // namespace wetdeck
