// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/run_outcome.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "validation/commands/quantity_lines.hpp"
#include "validation/metrics/flow_flags.hpp"
#include "validation/metrics/time_origin.hpp"
#include "validation/run/exit_code.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

nlohmann::json outcome_json(const RunRecord& record, const fs::path& directory) {
    return {{"scene", record.scene},
            {"variant", record.variant},
            {"dx", record.particle_spacing},
            {"status", to_string(record.status)},
            {"stop_reason", record.stop_reason},
            {"particles", record.fluid_particles},
            {"steps", record.cost.steps},
            {"wall_s", record.cost.wall_s},
            {"core_s", record.cost.core_s},
            {"stage_s", record.cost.stage_seconds},
            {"directory", directory.string()}};
}

void print_stages(const RunCost& cost) {
    for (const auto& [stage, seconds] : cost.stage_seconds)
        fmt::print("  {:18} {:10.2f} s  {:5.1f} %\n", stage, seconds, 100 * seconds / cost.wall_s);
    for (const auto& [criterion, steps] : cost.limiting_criterion)
        fmt::print("  {:18} set the size of {} steps\n", criterion, steps);
}

void print_text(const RunRecord& record, const fs::path& directory, const Verbosity& verbosity) {
    const RunCost& cost = record.cost;
    fmt::print("{} {} dx {}: {}{}\n", record.scene, record.variant, record.particle_spacing,
               to_string(record.status), record.stop_reason.empty() ? "" : " " + record.stop_reason);
    for (const std::string& flag : flow_flags(record)) fmt::print(stderr, "doubt: {}\n", flag);
    if (verbosity.quiet) return;
    if (const auto note = compression_note(record)) fmt::print("  note: {}\n", *note);
    fmt::print(
        "  {} fluid particles, {} steps in {:.2f} s: {:.2f} M particle-steps/s, {:.0f} bytes per particle\n",
        record.fluid_particles, cost.steps, cost.wall_s, cost.particle_steps / cost.wall_s / 1e6,
        record.parameters.at("bytes_per_particle"));
    if (verbosity.verbose) print_stages(cost);
    fmt::print("  results in {}\n", directory.string());
}

/// What the scene asks of the run, and the command that shows it.
void print_results(const Scene& scene, const RunRecord& record, const fs::path& directory) {
    ReferenceShelf shelf(reference_directory() / scene.name(), scene.analysis.folder);
    for (const std::string& line : quantity_lines(scene.analysis, record, shelf)) fmt::print("{}\n", line);
    fmt::print("next: wetdeck report {0}   (curves and pictures, in {0}/index.html)\n", directory.string());
}

}  // namespace

int print_outcome(const RunRecord& record, const fs::path& directory, const Verbosity& verbosity) {
    if (verbosity.json) {
        fmt::print("{}\n", outcome_json(record, directory).dump(1));
    } else {
        print_text(record, directory, verbosity);
    }
    return record.status == RunStatus::ok ? exit_done : exit_unstable;
}

int run_and_print(const Scene& scene, RunOptions run, const Resources& resources,
                  const Verbosity& verbosity) {
    run.threads = resources.threads;
    run.checkpoint_interval = resources.checkpoint_interval;
    Progress progress(fmt::format("{} {} dx {}", scene.name(), scene.variant, run.particle_spacing),
                      verbosity.quiet);
    const RunRecord record = run_scene(scene, run, progress);
    const int exit_code = print_outcome(record, run.directory, verbosity);
    if (!verbosity.json && !verbosity.quiet) print_results(scene, record, run.directory);
    std::fflush(stdout);
    for (const std::string& doubt : doubtful_origins(scene.analysis, record))
        fmt::print(stderr, "doubt: {}\n", doubt);
    return exit_code;
}

}  // namespace wetdeck
