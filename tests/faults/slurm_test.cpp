// SPDX-License-Identifier: BSD-3-Clause
// A suite through a real slurmctld and slurmd on this machine, with a key, ports and folders of their own.
// Where Slurm is not installed, or the test is not root, it ends with a warning.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"
#include "validation/execute/slurm.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;
using std::chrono::seconds;

namespace {

/// A daemon in the foreground; ends with this scope.
class Daemon {
  public:
    Daemon(const std::string& command, const std::filesystem::path& log) : process_(::fork()) {
        if (process_ != 0) return;
        const std::string line = "exec " + command + " >" + log.string() + " 2>&1";
        ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
        ::_exit(127);
    }
    ~Daemon() {
        ::kill(process_, SIGTERM);
        ::waitpid(process_, nullptr, 0);
    }
    Daemon(const Daemon&) = delete;
    Daemon& operator=(const Daemon&) = delete;

  private:
    pid_t process_;
};

int shell(const std::string& command) {
    return std::system(("{ " + command + "; } >/dev/null 2>&1").c_str());
}

std::string host() {
    char name[256] = "";
    ::gethostname(name, sizeof name - 1);
    return std::string(name).substr(0, std::string(name).find('.'));
}

void write_configuration(const ScratchFolder& folder) {
    const std::string at = std::filesystem::path(folder).string();
    const int port = 20000 + ::getpid() % 20000 * 2;
    for (const char* name : {"state", "spool"}) std::filesystem::create_directory(folder / name);
    samples::put_bytes(
        folder / "slurm.conf",
        "ClusterName=test\nSlurmctldHost=" + host() + "(127.0.0.1)\nSlurmUser=root\nSlurmdUser=root\n" +
            "SlurmctldPort=" + std::to_string(port) + "\nSlurmdPort=" + std::to_string(port + 1) +
            "\nAuthType=auth/munge\nAuthInfo=socket=" + at + "/munge.socket\nCryptoType=crypto/munge\n" +
            "MpiDefault=none\nJobAcctGatherType=jobacct_gather/none\n" +
            "AccountingStorageType=accounting_storage/none\nStateSaveLocation=" + at +
            "/state\nSlurmdSpoolDir=" + at + "/spool\nSlurmctldPidFile=" + at +
            "/slurmctld.pid\nSlurmdPidFile=" + at + "/slurmd.pid\nProctrackType=proctrack/linuxproc\n" +
            "TaskPlugin=task/none\nSelectType=select/cons_tres\nSelectTypeParameters=CR_Core\n" +
            "ReturnToService=2\nNodeName=" + host() + " NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\n" +
            "PartitionName=main Nodes=" + host() + " Default=YES MaxTime=INFINITE State=UP\n");
}

}  // namespace

TEST_CASE("short rows share an array task, long ones have their own, in order", "[faults]") {
    const std::vector<std::vector<std::size_t>> expected = {{0}, {1}, {2, 3, 4}, {5}};
    REQUIRE(grouped({4000, 180, 100, 50, 30, 1}) == expected);
    REQUIRE(grouped({}).empty());
}

TEST_CASE("the plan of a suite lists its rows, and one row can be run alone", "[faults]") {
    const ScratchFolder folder;
    const std::vector<std::string> suite = {"suite", "--only", put_scene(folder), "--out", folder / "out"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), suite.begin(), suite.end());
        return run_program(more);
    };
    REQUIRE_THAT(with({"--plan"}).out, Contains("to do  ") && Contains("single-phase dx 0.04"));
    REQUIRE_FALSE(std::filesystem::exists(folder / "out"));
    REQUIRE(with({"--row", "1"}).code == 0);
    REQUIRE(std::filesystem::exists(folder / "out/runs/small/single-phase/dx0.04/run.h5"));
    REQUIRE_FALSE(std::filesystem::exists(folder / "out/runs/small/single-phase/dx0.02"));
    REQUIRE_THAT(with({"--plan"}).out, Contains("done  ") && Contains("to do  "));
    const Outcome outcome = with({"--row", "2"});
    REQUIRE(outcome.code == 2);
    REQUIRE_THAT(outcome.err, Contains("--row is 2, expected one of 0 to 1"));
}

TEST_CASE("a suite goes through Slurm, and again without what is done", "[faults]") {
    if (::geteuid() != 0 || shell("command -v slurmctld && command -v slurmd && command -v munged") != 0) {
        WARN("not tested: needs root, slurmctld, slurmd and munged (apt-get install slurm-wlm munge)");
        return;
    }
    const ScratchFolder cluster, folder;
    const std::string at = std::filesystem::path(cluster).string();
    write_configuration(cluster);
    ::setenv("SLURM_CONF", (cluster / "slurm.conf").c_str(), 1);
    samples::put_bytes(cluster / "key", std::string(128, 'k'));
    ::chmod((cluster / "key").c_str(), 0400);
    const Daemon munged("munged -F --force --key-file=" + at + "/key --socket=" + at +
                            "/munge.socket --pid-file=" + at + "/munged.pid --log-file=" + at +
                            "/munged.log --seed-file=" + at + "/seed",
                        cluster / "munged.out");
    REQUIRE(samples::Program::true_within(seconds(10),
                                          [&] { return std::filesystem::exists(cluster / "munge.socket"); }));
    const Daemon controller("slurmctld -D -f " + at + "/slurm.conf", cluster / "slurmctld.out");
    const Daemon node("slurmd -D -f " + at + "/slurm.conf", cluster / "slurmd.out");
    INFO(samples::bytes_of(cluster / "slurmctld.out") << samples::bytes_of(cluster / "slurmd.out"));
    REQUIRE(samples::Program::true_within(seconds(30),
                                          [] { return shell("sinfo -h -t idle | grep -q idle") == 0; }));

    const std::vector<std::string> command = {"suite", "--only",       put_scene(folder),
                                              "--out", folder / "out", "--executor",
                                              "slurm", "--partition",  "main"};
    const auto report = folder / "out/summary.json";
    const auto submit = [&] {
        const Outcome outcome = run_program(command);
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return outcome.out;
    };
    REQUIRE_THAT(submit(), Contains("2 of 2 runs submitted in 1 tasks of job "));
    const Outcome twice = run_program(command);
    if (!std::filesystem::exists(report)) {
        REQUIRE(twice.code == 4);
        REQUIRE_THAT(twice.err, Contains("jobs of this suite are still at work"));
    }
    REQUIRE(samples::Program::true_within(seconds(60), [&] { return std::filesystem::exists(report); }));
    REQUIRE(nlohmann::json::parse(samples::bytes_of(report)).at("runs").size() == 2);
    REQUIRE(
        samples::Program::true_within(seconds(30), [] { return shell("test -z \"$(squeue -h)\"") == 0; }));
    REQUIRE_THAT(submit(), Contains("0 of 2 runs submitted in 0 tasks, the report as job "));
    REQUIRE(
        samples::Program::true_within(seconds(30), [] { return shell("test -z \"$(squeue -h)\"") == 0; }));
}
