// SPDX-License-Identifier: BSD-3-Clause
// A suite through a real slurmctld and slurmd on this machine, with a key, ports and folders of their own.
// Where Slurm is not installed, or the test is not root, it ends with a warning.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"
#include "validation/jobs/slurm.hpp"
#include "validation/store/checkpoint.hpp"

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
    Daemon(std::string command, std::filesystem::path log)
        : command_(std::move(command)), log_(std::move(log)) {
        start();
    }
    ~Daemon() { end(SIGTERM); }
    Daemon(const Daemon&) = delete;
    Daemon& operator=(const Daemon&) = delete;

    void start() {
        process_ = ::fork();
        if (process_ != 0) return;
        const std::string line = "exec " + command_ + " >>" + log_.string() + " 2>&1";
        ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
        ::_exit(127);
    }
    /// It alone: what it had started goes on.
    void end(int signal) {
        if (process_ <= 0) return;
        ::kill(process_, signal);
        ::waitpid(process_, nullptr, 0);
        process_ = -1;
    }

    pid_t process() const { return process_; }

  private:
    std::string command_;
    std::filesystem::path log_;
    pid_t process_ = -1;
};

std::vector<pid_t> children_of(pid_t process) {
    const std::string at = "/proc/" + std::to_string(process) + "/task/" + std::to_string(process);
    std::ifstream in(at + "/children");
    return {std::istream_iterator<pid_t>(in), {}};
}

/// With all that it started, children first.
void kill_tree(pid_t process) {
    for (const pid_t child : children_of(process)) kill_tree(child);
    ::kill(process, SIGKILL);
}

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

bool slurm_is_here() {
    if (::geteuid() == 0 && shell("command -v slurmctld && command -v slurmd && command -v munged") == 0)
        return true;
    WARN("not tested: needs root and the packages slurm-wlm and munge");
    return false;
}

/// A cluster of this machine alone, and a suite of one scene sent to it.
class SlurmCluster {
  public:
    /// @param scene  name or path
    explicit SlurmCluster(std::string scene)
        : at_(std::filesystem::path(cluster_).string()),
          configured_(configure()),
          munged_("munged -F --force --key-file=" + at_ + "/key --socket=" + at_ +
                      "/munge.socket --pid-file=" + at_ + "/munged.pid --log-file=" + at_ +
                      "/munged.log --seed-file=" + at_ + "/seed",
                  cluster_ / "munged.out"),
          key_served_(within(10, [&] { return std::filesystem::exists(cluster_ / "munge.socket"); })),
          controller("slurmctld -D -f " + at_ + "/slurm.conf", cluster_ / "slurmctld.out"),
          node("slurmd -D -f " + at_ + "/slurm.conf", cluster_ / "slurmd.out"),
          scene_(std::move(scene)) {
        INFO(samples::bytes_of(cluster_ / "slurmctld.out") << samples::bytes_of(cluster_ / "slurmd.out"));
        REQUIRE(key_served_);
        REQUIRE(within(30, [] { return shell("sinfo -h -t idle | grep -q idle") == 0; }));
    }

    template <class Condition>
    static bool within(int patience, const Condition& condition) {
        return samples::Program::true_within(seconds(patience), condition);
    }
    std::vector<std::string> command(const char* executor) const {
        std::vector<std::string> all = {"suite",
                                        "--only",
                                        scene_,
                                        "--out",
                                        work_ / executor,
                                        "--threads",
                                        "1",
                                        "--checkpoint-interval",
                                        "0",
                                        "--executor",
                                        executor};
        if (executor == std::string("slurm")) all.insert(all.end(), {"--partition", "main"});
        return all;
    }
    /// The node and all its jobs die at once, as by a power cut. The jobs' keepers are orphans, which have
    /// become children of this test.
    void cut_power() {
        node.end(SIGKILL);
        for (const pid_t child : children_of(::getpid()))
            if (child != munged_.process() && child != controller.process()) kill_tree(child);
    }
    std::filesystem::path file(const std::string& name) const { return work_ / name; }
    std::string submit() const {
        const Outcome outcome = run_program(command("slurm"));
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return outcome.out;
    }
    void wait_for_end(int patience) const {
        const bool ended =
            within(patience, [&] { return std::filesystem::exists(file("slurm/summary.json")); });
        INFO(samples::bytes_of(cluster_ / "slurmctld.out") << samples::bytes_of(cluster_ / "slurmd.out"));
        REQUIRE(ended);
        REQUIRE(within(30, [] { return shell("squeue -h && test -z \"$(squeue -h)\"") == 0; }));
    }

  private:
    bool configure() {
        write_configuration(cluster_);
        ::setenv("SLURM_CONF", (cluster_ / "slurm.conf").c_str(), 1);
        samples::put_bytes(cluster_ / "key", std::string(128, 'k'));
        return ::chmod((cluster_ / "key").c_str(), 0400) == 0;
    }

    ScratchFolder cluster_, work_;
    std::string at_;
    bool configured_;
    Daemon munged_;
    bool key_served_;

  public:
    Daemon controller, node;

  private:
    std::string scene_;
};

/// A summary without what may differ between two runs of the same bits: times and memory.
nlohmann::json without_cost(nlohmann::json value) {
    if (value.is_object()) {
        for (const char* key :
             {"wall_s", "core_s", "particle_steps_per_s", "peak_rss_mb", "start_time", "pareto"})
            value.erase(key);
    }
    if (value.is_structured())
        for (auto& member : value) member = without_cost(member);
    return value;
}

nlohmann::json summary_in(const std::filesystem::path& file) {
    return without_cost(nlohmann::json::parse(samples::bytes_of(file)));
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

TEST_CASE("a suite goes through Slurm to the same results, and again without what is done", "[faults]") {
    if (!slurm_is_here()) return;
    const ScratchFolder folder;
    const bool thorough =
        std::getenv("WETDECK_LONG_TESTS") != nullptr;  // a scene that comes with the program
    const SlurmCluster cluster(thorough ? "wedge_yettou" : put_scene(folder));
    std::vector<std::string> plan = cluster.command("slurm");
    plan.insert(plan.end(), {"--plan", "--json"});
    const std::size_t rows = nlohmann::json::parse(run_program(plan).out).at("rows").size();
    const std::string all = std::to_string(rows) + " of " + std::to_string(rows);
    REQUIRE_THAT(cluster.submit(), Contains(all + " runs submitted in 1 tasks of job "));
    const Outcome twice = run_program(cluster.command("slurm"));
    if (!std::filesystem::exists(cluster.file("slurm/summary.json"))) {
        REQUIRE(twice.code == 4);
        REQUIRE_THAT(twice.err, Contains("jobs of this suite are still queued or running"));
    }
    cluster.wait_for_end(thorough ? 600 : 60);
    REQUIRE(run_program(cluster.command("local")).code <= 1);  // within tolerance or not
    const nlohmann::json summary = summary_in(cluster.file("slurm/summary.json"));
    REQUIRE(summary.at("runs").size() >= 2);
    REQUIRE(summary.dump(1) == summary_in(cluster.file("local/summary.json")).dump(1));
    REQUIRE_THAT(cluster.submit(),
                 Contains("0 of " + std::to_string(rows) + " runs submitted in 0 tasks, the report as job "));
    cluster.wait_for_end(30);
}

TEST_CASE("a node that dies in the middle and a controller that is restarted lose nothing", "[faults]") {
    if (!slurm_is_here()) return;
    // some seconds of work in one run
    const ScratchFolder folder;
    SlurmCluster cluster(
        put_scene(folder, samples::replaced(samples::with("end_time = 0.2", "end_time = 2.0"),
                                            "single-phase = [0.02, 0.04]", "two-phase = [0.02]")));
    const auto run = cluster.file("slurm/runs/small/two-phase/dx0.02");
    const auto at_work = [&] {  // else the work was too short to be met in
        return !list_checkpoints(run).empty() && !std::filesystem::exists(run / "run.h5");
    };
    const std::string said = cluster.submit();
    REQUIRE(SlurmCluster::within(60, at_work));
    SECTION("the daemons alone: the job goes on without them") {
        cluster.node.end(SIGKILL);
        // as for an update: what a controller was told in the last seconds before a crash it forgets
        cluster.controller.end(SIGTERM);
        REQUIRE(at_work());
        cluster.controller.start();
        cluster.node.start();
    }
    SECTION("the node with its job: it is started again and goes on from its checkpoint") {
        cluster.cut_power();
        REQUIRE(at_work());
        // what the controller concludes by itself when the node has been silent for SlurmdTimeout
        REQUIRE(shell("scontrol update NodeName=" + host() + " State=DOWN Reason=silent") == 0);
        cluster.node.start();
        // Slurm would wait for two minutes
        const std::string job = said.substr(said.find("of job ") + 7);
        const std::string now = "scontrol update JobId=" + job.substr(0, job.find(',')) + "_0 StartTime=now";
        REQUIRE(SlurmCluster::within(20, [&] { return shell(now) == 0; }));
        cluster.wait_for_end(150);
        REQUIRE_THAT(samples::bytes_of(run / "run.log"), Contains("continuing from t = "));
    }
    cluster.wait_for_end(150);
    REQUIRE(run_program(cluster.command("local")).code == 0);
    REQUIRE(summary_in(cluster.file("slurm/summary.json")).dump(1) ==
            summary_in(cluster.file("local/summary.json")).dump(1));
}
