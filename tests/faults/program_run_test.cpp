// SPDX-License-Identifier: BSD-3-Clause
// Runs that end well, become unstable or meet a machine that refuses; what is on disk afterwards.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "solver/scheme_revision.hpp"
#include "tests/faults/program_support.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/store/fields.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;

namespace {

std::vector<std::string> short_run(const std::string& scene, const std::string& out) {
    return {"run", scene, "--variant", "single-phase", "--dx", "0.04", "--out", out};
}

}  // namespace

TEST_CASE("the threads of a run wait politely, however the program is started", "[faults]") {
    const ScratchFolder folder;
    samples::Program run({"run", put_scene(folder), "--dx", "0.01", "--out", folder / "run"}, folder);
    CHECK(samples::Program::true_within(std::chrono::seconds(20), [&run] {
        return run.environment().find("GOMP_SPINCOUNT=20000") != std::string::npos;
    }));
    ::setenv("OMP_WAIT_POLICY", "passive", 1);  // a choice of the user's own stays
    samples::Program other({"run", put_scene(folder), "--dx", "0.01", "--out", folder / "other"}, folder);
    ::unsetenv("OMP_WAIT_POLICY");
    CHECK(samples::Program::true_within(
        std::chrono::seconds(20), [&] { return std::filesystem::exists(folder / "other/fields.pvd"); }));
    CHECK(other.environment().find("GOMP_SPINCOUNT") == std::string::npos);
}

TEST_CASE("a short good run ends with exit code 0 and a whole store", "[faults]") {
    const ScratchFolder folder;
    const Outcome outcome = run_program({"run", "dam_break", "--variant", "single-phase", "--dx", "0.04",
                                         "--until", "0.05", "--out", folder / "run"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    REQUIRE(outcome.err.empty());
    REQUIRE_THAT(outcome.out, Contains("dam_break single-phase dx 0.04: ok\n") && Contains("results in "));
    REQUIRE_THAT(outcome.out, Contains("arrival_time ") && Contains("\nnext: wetdeck report "));
    const RunRecord record = read_run(folder / "run/run.h5");
    REQUIRE(record.status == RunStatus::ok);
    REQUIRE(record.fluid_particles == 30 * 15);
    REQUIRE(record.series.at("front").time.size() > 40);
    REQUIRE(record.series.at("front").time.front() == 0);
    REQUIRE(record.series.at("front").time.back() == Approx(0.05).epsilon(1e-9));
    REQUIRE(list_frames(folder / "run").size() == 2);  // at the start and at 0.05 s
    REQUIRE_FALSE(std::filesystem::exists(folder / "run/live.h5"));
}

TEST_CASE("a run's store tells what was run, by what, where and at what cost", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder);
    REQUIRE(run_program(short_run(scene, folder / "run")).code == 0);
    const RunRecord record = read_run(folder / "run/run.h5");
    REQUIRE(record.scene == "small");
    REQUIRE(record.variant == "single-phase");
    REQUIRE(record.particle_spacing == 0.04);
    REQUIRE(record.scene_text == samples::small_scene);
    REQUIRE(record.scene_path == scene);
    REQUIRE(record.particles > record.fluid_particles);
    for (const char* key :
         {"program_version", "commit", "compiler", "compiler_flags", "build_type", "libraries", "simd", "cpu",
          "host", "cores", "threads", "start_time", "resolved_scene"}) {
        INFO(key);
        REQUIRE_FALSE(record.provenance.at(key).empty());
    }
    REQUIRE_THAT(record.provenance.at("resolved_scene"), Contains("background_pressure = 0.0"));
    const nlohmann::json parameters = nlohmann::json::parse(record.provenance.at("parameters"));
    for (const ModelKey& row : model_keys()) {
        INFO(row.dotted());
        CHECK(parameters.contains(row.dotted()) == (row.table != "air"));  // water alone
    }
    CHECK(parameters.at("model.wall_pressure") == "shepard-water");  // a default
    CHECK(record.parameters.at("scheme_revision") == scheme_revision);
    for (const char* key :
         {"particle_spacing", "smoothing_length", "gravity_y", "water.sound_speed", "model.courant_number"}) {
        INFO(key);
        REQUIRE(record.parameters.count(key) == 1);
    }
    for (const char* name :
         {"front", "gauge", "depth", "energy_kinetic", "energy_potential", "energy_compression", "momentum_x",
          "momentum_y", "density_error_max", "particles_outside", "time_step"}) {
        INFO(name);
        REQUIRE(record.series.at(name).value.size() == record.series.at("front").time.size());
        REQUIRE_FALSE(record.series.at(name).unit.empty());
    }
    REQUIRE(record.cost.steps > 0);
    REQUIRE(record.cost.particle_steps == static_cast<double>(record.cost.steps * record.fluid_particles));
    REQUIRE(record.cost.wall_s > 0);
    REQUIRE(record.cost.peak_rss_mb > 1);
    REQUIRE(record.cost.stage_seconds.count("neighbours") == 1);
}

TEST_CASE("overrides are kept with the run", "[faults]") {
    const ScratchFolder folder;
    std::vector<std::string> arguments = short_run(put_scene(folder), folder / "run");
    arguments.insert(arguments.end(), {"--set", "run.end_time=0.01", "--set", "model.dissipation=riemann"});
    REQUIRE(run_program(arguments).code == 0);
    const RunRecord record = read_run(folder / "run/run.h5");
    REQUIRE(record.parameters.at("run.end_time") == 0.01);
    REQUIRE_THAT(record.provenance.at("resolved_scene"), Contains("dissipation = 'riemann'"));
}

TEST_CASE("a run that becomes unstable ends with exit code 3 and keeps what it has", "[faults]") {
    const ScratchFolder folder;
    const Outcome outcome = run_program(
        {"run", "dam_break", "--variant", "paper-literal", "--dx", "0.04", "--out", folder / "run"});
    REQUIRE(outcome.code == 3);
    REQUIRE_THAT(outcome.out, Contains("unstable at t = ") && Contains("particle ") && Contains(" at ("));
    const RunRecord record = read_run(folder / "run/run.h5");
    REQUIRE(record.status == RunStatus::unstable);
    REQUIRE_THAT(record.stop_reason,
                 Contains("t = ") && Contains("(step ") && Contains(" at (") && Contains("left the range"));
    REQUIRE_THAT(outcome.out, Contains(record.stop_reason));
    REQUIRE_FALSE(record.series.at("front").value.empty());
    REQUIRE(record.cost.steps > 0);
    const std::vector<FrameEntry> frames = list_frames(folder / "run");
    REQUIRE_FALSE(frames.empty());
    REQUIRE(frames.front().time == 0);
    REQUIRE(read_frame(frames.front().path).x.size() == record.particles);
}

TEST_CASE("an output below a regular file ends with exit code 4", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder);
    samples::put_bytes(folder / "file", "x");
    const Outcome run = run_program(short_run(scene, folder / "file/run"));
    REQUIRE(run.code == 4);
    REQUIRE(run.one_line());
    REQUIRE_THAT(run.err, Contains("file/run: ") && Contains("Not a directory"));
    const Outcome suite = run_program({"suite", "--only", scene, "--out", folder / "file/suite"});
    REQUIRE(suite.code == 4);
    REQUIRE(suite.one_line());
    REQUIRE(samples::bytes_of(folder / "file") == "x");
}

TEST_CASE("a full disk ends a run with exit code 4, a clear line, and no run that looks finished",
          "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(
        folder, samples::with("sample_interval = 0.002", "sample_interval = 1e-6\nframe_interval = 0.001"));
    for (const char* size :
         {"size=16k", "size=48k", "size=96k", "size=128k", "size=160k"}) {  // full at another file each
        const samples::SmallFileSystem disk(size);
        if (!disk.error().empty()) {
            WARN("not tested: no small file system can be mounted here: " << disk.error());
            return;
        }
        const Outcome outcome = run_program({"run", scene, "--dx", "0.02", "--out", disk.path() / "run"});
        INFO(size << ": " << outcome.err);
        REQUIRE(outcome.code == 4);
        REQUIRE(outcome.one_line());
        REQUIRE_THAT(outcome.err, Contains("disk full"));
        REQUIRE_FALSE(std::filesystem::exists(disk.path() / "run/run.h5"));
    }
}

TEST_CASE("a scene that new writes runs to its end and reaches its quantities", "[faults]") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "hull.csv", "0, 0\n0.25, 0.25\n0.25, 0.35\n-0.25, 0.35\n-0.25, 0.25\n");
    const std::string scene = folder / "mine.toml";
    REQUIRE(run_program({"new", folder / "hull.csv", "--speed", "3", "--mass", "60", "--record", "0.03",
                         "--out", scene})
                .code == 0);
    const Outcome outcome = run_program({"run", scene, "--dx", "0.02", "--out", folder / "run"});
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.err.find("doubt") == std::string::npos);
    for (const char* quantity : {"force_peak ", "force_peak_time ", "deceleration_peak ", "velocity_at_end ",
                                 "pressure_bottom_peak "})
        CHECK_THAT(outcome.out, Contains(quantity));
    CHECK_THAT(outcome.out, !Contains("spans") && !Contains("not reached"));
}
