// SPDX-License-Identifier: BSD-3-Clause
// What a suite submits to Slurm, with stand-ins for sbatch and squeue: runs on machines without Slurm.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;

namespace {

void put_script(const std::filesystem::path& file, const std::string& text) {
    samples::put_bytes(file, "#!/bin/sh\n" + text);
    ::chmod(file.c_str(), 0755);
}

/// An sbatch that writes its arguments down and numbers the jobs, and a squeue that lists what is in a file.
class StandIn {
  public:
    StandIn() : path_before_(::getenv("PATH")) {
        const std::string at = std::filesystem::path(folder_).string();
        put_script(folder_ / "sbatch", "echo \"$*\" >>" + at + "/calls; wc -l <" + at + "/calls\n");
        put_script(folder_ / "squeue", "cat " + at + "/queue\n");
        ::setenv("PATH", (at + ":" + path_before_).c_str(), 1);
    }
    ~StandIn() { ::setenv("PATH", path_before_.c_str(), 1); }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

    /// What sbatch prints on stderr before it submits, and what it prints on stdout instead of the number.
    void let_sbatch_say(const std::string& error, const std::string& instead = "") const {
        const std::string at = std::filesystem::path(folder_).string();
        put_script(folder_ / "sbatch",
                   "echo '" + error + "' >&2\necho \"$*\" >>" + at + "/calls\n" +
                       (instead.empty() ? "wc -l <" + at + "/calls" : "echo '" + instead + "'") + "\n");
    }
    void refuse_jobs(const std::string& error) const {
        put_script(folder_ / "sbatch", "echo '" + error + "' >&2\nexit 1\n");
    }
    void put_queue(const std::string& jobs) const { samples::put_bytes(folder_ / "queue", jobs); }
    std::string calls() const { return samples::bytes_of(folder_ / "calls"); }

  private:
    std::string path_before_;
    ScratchFolder folder_;
};

int shell(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str());
}

}  // namespace

TEST_CASE("a suite is submitted as an array whose tasks run its rows, and a job for the report", "[faults]") {
    const StandIn slurm;
    const ScratchFolder folder;
    const std::string out = folder / "out";
    const std::vector<std::string> suite = {
        "suite",     "--only", put_scene(folder), "--out", out, "--executor", "slurm", "--partition", "a 'b'",
        "--threads", "2",      "--concurrent",    "3"};
    const Outcome submitted = run_program(suite);
    INFO(submitted.err);
    REQUIRE(submitted.code == 0);
    CHECK(submitted.out == "2 of 2 runs submitted in 1 tasks of job 1, the report as job 2\n");
    CHECK_THAT(slurm.calls(), Contains("--array=0-0%3 -c 2 -p a 'b' ") &&
                                  Contains("--dependency=afterany:1 -p a 'b' ") && Contains(" report "));
    CHECK(samples::bytes_of(out + "/slurm/jobs") == "1,2\n");

    slurm.put_queue("1_0\n");
    const Outcome again = run_program(suite);
    CHECK(again.code == 4);
    CHECK(again.one_line());
    CHECK_THAT(again.err, Contains("jobs of this suite are still queued or running: 1_0"));

    slurm.put_queue("");
    REQUIRE(shell("SLURM_ARRAY_TASK_ID=0 sh " + out + "/slurm/task.sh") == 0);
    REQUIRE(run_program({"report", out}).code == 0);
    CHECK(nlohmann::json::parse(samples::bytes_of(out + "/summary.json")).at("runs").size() == 2);
    CHECK_THAT(run_program(suite).out, Contains("0 of 2 runs submitted in 0 tasks, the report as job 3"));
}

TEST_CASE("a sweep is submitted as an array, and its report is made of the runs of the tasks", "[faults]") {
    const StandIn slurm;
    const ScratchFolder folder;
    const std::string out = folder / "out";
    const std::vector<std::string> sweep = {
        "sweep", put_scene(folder), "--variant", "single-phase", "--over", "water.density=900:1000:2", "--dx",
        "0.04",  "--out",           out,         "--executor",   "slurm"};
    const Outcome submitted = run_program(sweep);
    INFO(submitted.err);
    REQUIRE(submitted.code == 0);
    CHECK(submitted.out == "2 of 2 runs submitted in 1 tasks of job 1, the report as job 2\n");
    REQUIRE(shell("SLURM_ARRAY_TASK_ID=0 sh " + out + "/slurm/task.sh") == 0);
    REQUIRE(run_program({"report", out}).code == 0);
    CHECK_THAT(samples::bytes_of(out + "/sweep.csv"),
               Contains("\n900,0.04,") && Contains("\n1000,0.04,") && !Contains("missing"));
    slurm.put_queue("");
    CHECK_THAT(run_program(sweep).out, Contains("0 of 2 runs submitted in 0 tasks"));
}

TEST_CASE("a site's message on stderr of sbatch and squeue is no number of a job", "[faults]") {
    const StandIn slurm;
    const ScratchFolder folder;
    const std::string out = folder / "out";
    const std::vector<std::string> suite = {"suite",      "--only", put_scene(folder), "--out", out,
                                            "--executor", "slurm"};
    slurm.let_sbatch_say("site: your project has 12 hours left");
    const Outcome submitted = run_program(suite);
    INFO(submitted.err);
    REQUIRE(submitted.code == 0);
    CHECK(samples::bytes_of(out + "/slurm/jobs") == "1,2\n");
    CHECK(samples::bytes_of(out + "/slurm/sbatch.log") == "site: your project has 12 hours left\n");
    CHECK_FALSE(std::filesystem::exists(out + "/slurm/submitting"));
}

TEST_CASE("a submission whose outcome is unknown keeps the next one from submitting twice", "[faults]") {
    const StandIn slurm;
    const ScratchFolder folder;
    const std::string out = folder / "out";
    const std::vector<std::string> suite = {"suite",      "--only", put_scene(folder), "--out", out,
                                            "--executor", "slurm"};
    slurm.refuse_jobs("sbatch: error: invalid partition");
    const Outcome refused = run_program(suite);
    CHECK(refused.code == 4);
    CHECK(refused.one_line());
    CHECK_THAT(refused.err, Contains("Slurm does not accept the job: sbatch: error: invalid partition"));

    slurm.let_sbatch_say("", "submitted, have a nice day");  // a refused job is no obstacle
    const Outcome unknown = run_program(suite);
    CHECK(unknown.code == 4);
    CHECK_THAT(unknown.err, Contains("in place of the number of a job, which may run all the same"));

    slurm.let_sbatch_say("");
    const Outcome again = run_program(suite);
    CHECK(again.code == 4);
    CHECK(again.one_line());
    CHECK_THAT(again.err, Contains("slurm/submitting: a submission has not come to its end"));
    std::filesystem::remove(out + "/slurm/submitting");
    CHECK(run_program(suite).code == 0);
}
