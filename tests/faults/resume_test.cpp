// SPDX-License-Identifier: BSD-3-Clause
// Runs that are interrupted, by signals, kill -9, full disks and damaged checkpoints, and go on to the same
// bits. With WETDECK_LONG_TESTS=1 in the environment the kill test makes 50 attempts.
#include <sched.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>
#include <random>

#include "tests/faults/program_support.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::Program;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;
using std::chrono::seconds;

namespace {

/// About a second of work, with frames on the way.
std::string put_long_scene(const ScratchFolder& folder) {
    return put_scene(folder, samples::replaced(samples::with("end_time = 0.2", "end_time = 0.6"),
                                               "frames = [0.05, 0.1]", "frame_interval = 0.1"));
}

/// The same, and a block that falls into the water and on the floor.
std::string put_long_scene_with_body(const ScratchFolder& folder) {
    const std::string scene = samples::bytes_of(put_long_scene(folder));
    samples::put_bytes(folder / "body.toml", samples::replaced(scene, "[model]\n", R"toml([body]
outline = [[-0.08, -0.06], [0.08, -0.06], [0.08, 0.06], [-0.08, 0.06]]
position = [0.2, 0.3]
free = ["x", "y", "rotation"]
velocity_y = -1.0
mass = 15.0
inertia = 0.05

[contact]
restitution = 0.5

[model]
)toml"));
    return folder / "body.toml";
}

std::vector<std::string> run_into(const std::string& scene, const std::filesystem::path& directory) {
    return {"run",
            scene,
            "--variant",
            "two-phase",
            "--dx",
            "0.02",
            "--threads",
            "1",
            "--out",
            directory,
            "--checkpoint-interval",
            "0"};
}

/// All that two records have in common but cost in time and memory, dates and threads.
bool same_but_cost(RunRecord a, RunRecord b) {
    for (RunRecord* record : {&a, &b}) {
        record->cost.wall_s = record->cost.core_s = record->cost.peak_rss_mb = 0;
        record->cost.stage_seconds.clear();
        record->parameters.erase("bytes_per_particle");
        for (const char* key : {"start_time", "threads", "cores"}) record->provenance.erase(key);
    }
    return samples::same(a, b);
}

/// Every field file of one run against that of the other, byte by byte.
bool same_fields(const std::filesystem::path& a, const std::filesystem::path& b) {
    bool equal = samples::bytes_of(a / "fields.pvd") == samples::bytes_of(b / "fields.pvd");
    for (const std::string& name : samples::names_in(a / "fields"))
        equal = equal && samples::bytes_of(a / "fields" / name) == samples::bytes_of(b / "fields" / name);
    return equal && samples::names_in(a / "fields").size() == samples::names_in(b / "fields").size();
}

void require_same_run(const std::filesystem::path& a, const std::filesystem::path& b) {
    REQUIRE(same_but_cost(read_run(a / "run.h5"), read_run(b / "run.h5")));
    REQUIRE(same_fields(a, b));
    const std::vector<std::filesystem::path> kept = list_checkpoints(b);
    REQUIRE(kept.size() == 1);  // the one before the last step, for a later end
    REQUIRE(read_checkpoint(kept.front()).step + 1 == read_run(b / "run.h5").cost.steps);
}

std::filesystem::path newest_file(const std::filesystem::path& directory) {
    const std::vector<std::filesystem::path> files = list_checkpoints(directory);
    return files.empty() ? std::filesystem::path() : files.front();
}

/// Starts a run and waits until it has stored itself behind what is there, some hundred steps after the
/// start.
std::unique_ptr<Program> started(const std::vector<std::string>& arguments,
                                 const std::filesystem::path& directory, const ScratchFolder& logs) {
    const std::filesystem::path before =
        std::max(newest_file(directory), directory / "checkpoint_000000000500.h5");
    auto program = std::make_unique<Program>(arguments, logs);
    REQUIRE(Program::true_within(seconds(30), [&] {
        return list_checkpoints(directory).size() == 2 && newest_file(directory) > before;
    }));
    return program;
}

/// A run that was killed with two checkpoints on disk.
void leave_interrupted(const std::string& scene, const std::filesystem::path& directory) {
    const ScratchFolder logs;
    started(run_into(scene, directory), directory, logs)->kill_all();
    REQUIRE_FALSE(std::filesystem::exists(directory / "run.h5"));
}

}  // namespace

TEST_CASE("SIGTERM and SIGINT stop a run with a checkpoint, from which it ends with the same bits",
          "[faults]") {
    const ScratchFolder folder, logs;
    const std::string scene = put_long_scene(folder);
    REQUIRE(run_program(run_into(scene, folder / "whole")).code == 0);
    const auto parted = folder / "parted";
    std::vector<std::string> arguments = run_into(scene, parted);
    for (const auto& [signal, code] : {std::pair{SIGTERM, 143}, std::pair{SIGINT, 130}}) {
        const auto program = started(arguments, parted, logs);
        program->send(signal);
        REQUIRE(program->wait() == code);
        const Outcome stopped{code, program->out(), program->err()};
        REQUIRE(stopped.one_line());
        REQUIRE_THAT(stopped.err, Contains("continue with: wetdeck resume " + parted.string()));
        REQUIRE_FALSE(std::filesystem::exists(parted / "run.h5"));
        arguments = {"resume", parted, "--threads", "2", "--checkpoint-interval", "0"};
    }
    const Outcome last = run_program({"resume", parted, "--threads", "2"});
    INFO(last.err);
    REQUIRE(last.code == 0);
    REQUIRE_THAT(last.out, Contains("continuing from t = "));
    require_same_run(folder / "whole", parted);
    const Outcome again = run_program({"resume", parted});
    REQUIRE(again.code == 0);
    REQUIRE_THAT(again.out, Contains("the run has finished already"));
}

TEST_CASE("runs killed at random moments end with the same bits", "[faults]") {
    const int attempts = std::getenv("WETDECK_LONG_TESTS") != nullptr ? 50 : 5;
    const ScratchFolder folder, logs;
    const std::string scenes[] = {put_long_scene(folder), put_long_scene_with_body(folder)};
    const std::filesystem::path whole[] = {folder / "whole", folder / "whole_with_body"};
    std::chrono::duration<double> duration[2];
    for (const int n : {0, 1}) {
        const auto start = std::chrono::steady_clock::now();
        REQUIRE(run_program(run_into(scenes[n], whole[n])).code == 0);
        duration[n] = std::chrono::steady_clock::now() - start;
    }
    std::mt19937_64 random(1);
    int resumed = 0, finished = 0;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const int n = attempt % 2;
        const auto killed = folder / ("killed_" + std::to_string(attempt));
        {
            Program program(run_into(scenes[n], killed), logs);
            std::this_thread::sleep_for(duration[n] * std::uniform_real_distribution<>(0.02, 1)(random));
            program.kill_all();
        }
        // the same command starts it again where the kill came before the first checkpoint
        const Outcome outcome = run_program(run_into(scenes[n], killed));
        if (outcome.code == 2) {
            REQUIRE_THAT(outcome.err, Contains("holds a finished run"));
            ++finished;
        } else {
            INFO(outcome.err);
            REQUIRE(outcome.code == 0);
            resumed += outcome.out.find("continuing from") != std::string::npos;
        }
        require_same_run(whole[n], killed);
        std::filesystem::remove_all(killed);
    }
    WARN(attempts << " kills, " << resumed << " runs continued from a checkpoint, " << finished
                  << " finished before, the rest begun again");
    REQUIRE(resumed > 0);
}

TEST_CASE("a run goes on from the checkpoint before a truncated one, and says so where all are truncated",
          "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_long_scene(folder);
    const auto run = folder / "run";
    leave_interrupted(scene, run);
    const std::vector<std::filesystem::path> files = list_checkpoints(run);
    const std::uint64_t older = read_checkpoint(files.at(1)).step;
    std::filesystem::resize_file(files.at(0), std::filesystem::file_size(files.at(0)) / 2);
    SECTION("one") {
        const Outcome outcome = run_program({"resume", run});
        REQUIRE(outcome.code == 0);
        REQUIRE_THAT(outcome.out, Contains("step " + std::to_string(older) + "\n"));
        REQUIRE(run_program(run_into(scene, folder / "whole")).code == 0);
        require_same_run(folder / "whole", run);
    }
    SECTION("all") {
        std::filesystem::resize_file(files.at(1), 100);
        for (const std::vector<std::string>& command :
             {std::vector<std::string>{"resume", run}, run_into(scene, run)}) {
            const Outcome outcome = run_program(command);
            REQUIRE(outcome.code == 2);
            REQUIRE(outcome.one_line());
            REQUIRE_THAT(outcome.err, Contains("no checkpoint can be read") && Contains("--replace"));
        }
        REQUIRE(list_checkpoints(run) == files);
    }
}

TEST_CASE("what cannot be resumed is refused in one line", "[faults]") {
    const ScratchFolder folder, logs;
    const std::string scene = put_long_scene(folder);
    const auto run = folder / "run";
    const auto expect_refusal = [&](int code, const std::string& message) {
        const Outcome outcome = run_program({"resume", run});
        INFO(outcome.err);
        REQUIRE(outcome.code == code);
        REQUIRE(outcome.one_line());
        REQUIRE_THAT(outcome.err, Contains(message));
    };
    expect_refusal(2, "no such directory");
    std::filesystem::create_directory(run);
    expect_refusal(2, "holds no checkpoint to continue from");
    {
        const auto program = started(run_into(scene, run), run, logs);
        program->send(SIGSTOP);
        expect_refusal(4, "another process is working in this directory");
    }
    std::filesystem::remove(run / "fields/frame_000000.vtp");
    expect_refusal(2, "field files written before the checkpoint are there");
    REQUIRE(list_checkpoints(run).size() >= 2);  // three if it was stopped before it removed the oldest
    samples::put_bytes(run / "identity", "another\n");
    expect_refusal(2, "belongs to another run");
}

TEST_CASE("a run goes on with the same bits on fewer cores", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_long_scene(folder);
    leave_interrupted(scene, folder / "run");
    REQUIRE(run_program(run_into(scene, folder / "whole")).code == 0);
    cpu_set_t before, one;
    REQUIRE(::sched_getaffinity(0, sizeof before, &before) == 0);
    CPU_ZERO(&one);
    for (std::size_t cpu = 0; CPU_COUNT(&one) == 0; ++cpu)
        if (CPU_ISSET(cpu, &before)) CPU_SET(cpu, &one);
    REQUIRE(::sched_setaffinity(0, sizeof one, &one) == 0);
    const Outcome outcome = run_program({"resume", folder / "run"});  // all threads there are: one
    REQUIRE(::sched_setaffinity(0, sizeof before, &before) == 0);
    REQUIRE(outcome.code == 0);
    REQUIRE(read_run(folder / "run/run.h5").provenance.at("threads") == "1");
    require_same_run(folder / "whole", folder / "run");
}

TEST_CASE("a run whose disk becomes full goes on when there is room again", "[faults]") {
    const ScratchFolder folder, logs;
    const std::string scene = put_long_scene(folder);
    const samples::SmallFileSystem disk("size=10m");
    if (!disk.error().empty()) {
        WARN("not tested: no small file system can be mounted here: " << disk.error());
        return;
    }
    const auto run = disk.path() / "run";
    const auto program = started(run_into(scene, run), run, logs);
    {
        std::ofstream filler(disk.path() / "filler");
        while (filler << std::string(4096, 'x') << std::flush) {
        }
    }
    REQUIRE(program->wait() == 4);
    REQUIRE_THAT(program->err(),
                 Contains("disk full") && Contains("continue with: wetdeck resume " + run.string()));
    REQUIRE_FALSE(std::filesystem::exists(run / "run.h5"));
    disk.grow("size=20m");
    const Outcome outcome = run_program({"resume", run});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    REQUIRE(run_program(run_into(scene, folder / "whole")).code == 0);
    require_same_run(folder / "whole", run);
}

TEST_CASE("a run that has ended goes on to a later end with the same bits", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_long_scene_with_body(folder);
    const auto run_until = [&](const char* end, const char* name) {
        std::vector<std::string> arguments = run_into(scene, folder / name);
        arguments.insert(arguments.end(), {"--until", end});
        return run_program(arguments).code;
    };
    const auto parted = folder / "parted";
    const auto resumed_to = [&](const char* end) {
        return run_program({"resume", parted, "--until", end, "--threads", "2"});
    };
    REQUIRE(run_until("0.0513", "parted") == 0);
    SECTION("within the scene's time, in two parts") {
        REQUIRE(run_until("0.2", "whole") == 0);
        REQUIRE(resumed_to("0.12345").code == 0);
        const Outcome last = resumed_to("0.2");
        INFO(last.err);
        REQUIRE(last.code == 0);
        REQUIRE_THAT(last.out, Contains("continuing from t = 0.123"));
        require_same_run(folder / "whole", parted);
    }
    SECTION("to the end of the scene and beyond") {
        REQUIRE(run_program(run_into(scene, folder / "scene")).code == 0);
        REQUIRE(resumed_to("0.6").code == 0);
        require_same_run(folder / "scene", parted);
        REQUIRE(run_until("0.65", "beyond") == 0);
        REQUIRE(resumed_to("0.65").code == 0);
        require_same_run(folder / "beyond", parted);
    }
    SECTION("not to an earlier end, and to the same one without a step") {
        const auto before = samples::bytes_of(parted / "run.h5");
        const Outcome earlier = resumed_to("0.05");
        REQUIRE(earlier.code == 2);
        REQUIRE(earlier.one_line());
        REQUIRE_THAT(earlier.err, Contains("--until is 0.05 s") && Contains("0.0513 s"));
        REQUIRE_THAT(resumed_to("0.0513").out, Contains("the run has finished already"));
        REQUIRE(samples::bytes_of(parted / "run.h5") == before);
    }
    SECTION("not without its checkpoint") {
        std::filesystem::remove(list_checkpoints(parted).front());
        const Outcome refused = resumed_to("0.2");
        REQUIRE(refused.code == 2);
        REQUIRE_THAT(refused.err, Contains("holds no checkpoint to continue from"));
        REQUIRE(std::filesystem::exists(parted / "run.h5"));
    }
}
