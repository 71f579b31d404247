// SPDX-License-Identifier: BSD-3-Clause
// The command line. Exit codes: 0 done and within tolerance; 1 outside a stated tolerance; 2 bad usage or
// input; 3 a run became unstable; 4 the environment failed; 130, 143 stopped by SIGINT, SIGTERM.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "solver/passes/pair_passes.hpp"
#include "validation/analytic/curves.hpp"
#include "validation/commands/ablate.hpp"
#include "validation/commands/baseline.hpp"
#include "validation/commands/describe.hpp"
#include "validation/commands/publish.hpp"
#include "validation/commands/report_command.hpp"
#include "validation/commands/stress.hpp"
#include "validation/commands/verify.hpp"
#include "validation/jobs/suite.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/program/command_line.hpp"
#include "validation/program/completion.hpp"
#include "validation/program/manual.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/run.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/environment.hpp"
#include "validation/store/provenance.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

constexpr int exit_done = 0, exit_outside = 1, exit_usage = 2, exit_unstable = 3, exit_environment = 4;

void print_stages(const RunCost& cost) {
    for (const auto& [stage, seconds] : cost.stage_seconds)
        fmt::print("  {:18} {:10.2f} s  {:5.1f} %\n", stage, seconds, 100 * seconds / cost.wall_s);
    for (const auto& [criterion, steps] : cost.limiting_criterion)
        fmt::print("  {:18} set the size of {} steps\n", criterion, steps);
}

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

void print_outcome(const RunRecord& record, const Options& options, const fs::path& directory) {
    if (options.json) return fmt::print("{}\n", outcome_json(record, directory).dump(1));
    const RunCost& cost = record.cost;
    fmt::print("{} {} dx {}: {}{}\n", record.scene, record.variant, record.particle_spacing,
               to_string(record.status), record.stop_reason.empty() ? "" : " " + record.stop_reason);
    if (options.quiet) return;
    fmt::print(
        "  {} fluid particles, {} steps in {:.2f} s: {:.2f} M particle-steps/s, {:.0f} bytes per particle\n",
        record.fluid_particles, cost.steps, cost.wall_s, cost.particle_steps / cost.wall_s / 1e6,
        record.parameters.at("bytes_per_particle"));
    if (options.verbose) print_stages(cost);
    fmt::print("  results in {}\n", directory.string());
}

int finish_run(const Scene& scene, RunOptions run, const Options& options) {
    run.threads = options.threads;
    run.checkpoint_interval = options.checkpoint_interval;
    Progress progress(fmt::format("{} {} dx {}", scene.name(), scene.variant, run.particle_spacing),
                      options.quiet);
    const RunRecord record = run_scene(scene, run, progress);
    print_outcome(record, options, run.directory);
    return record.status == RunStatus::ok ? exit_done : exit_unstable;
}

/// What was asked for [m]; 0 where nothing was.
double chosen_spacing(const Options& options) {
    if (options.particle_spacing == 0.0) throw InputError("--dx is 0, expected a positive spacing [m]");
    return options.particle_spacing.value_or(0);
}

int run_command(const Options& options) {
    const fs::path path = find_scene(options.scene);
    const std::optional<std::string> variant =
        options.variant.empty() ? std::nullopt : std::optional<std::string>(options.variant);
    const Scene scene = read_scene(path, variant, options.overrides);
    RunOptions run;
    run.particle_spacing = chosen_spacing(options);
    if (!options.particle_spacing) {
        const auto tier = scene.tiers.find("quick");
        const bool listed = tier != scene.tiers.end() && tier->second.count(scene.variant) > 0;
        if (!listed) throw InputError("--dx is missing: the scene names no quick spacing for this variant");
        run.particle_spacing = tier->second.at(scene.variant).back();
    }
    if (options.until != 0) run.until = options.until;
    run.replace = options.replace;
    run.directory = options.out.empty()
                        ? run_path("results", scene.name(), scene.variant, run.particle_spacing)
                        : fs::path(options.out);
    return finish_run(scene, run, options);
}

int resume_command(const Options& options) {
    if (!fs::is_directory(options.out))
        throw InputError(
            fmt::format("{}: no such directory, expected that of an interrupted run", options.out));
    if (holds_finished_run(options.out)) {
        const RunRecord record = read_run(run_file(options.out));
        if (!options.json) fmt::print("the run had ended before, nothing is left to be done\n");
        print_outcome(record, options, options.out);
        return record.status == RunStatus::ok ? exit_done : exit_unstable;
    }
    const auto [scene, run] = interrupted_run(options.out);
    return finish_run(scene, run, options);
}

/// Says where the report lies and why the program does not end with 0.
int tell_report(const Summary& summary, const fs::path& directory) {
    fmt::print("report: {}\n", (directory / "index.html").string());
    const std::vector<std::string> outside = outside_tolerance(summary);
    if (outside.empty()) return exit_done;
    constexpr std::size_t most = 3;
    fmt::print("outside tolerance ({}; the report shows all):\n", outside.size());
    for (std::size_t k = 0; k < std::min(most, outside.size()); ++k) fmt::print("  {}\n", outside[k]);
    if (outside.size() > most) fmt::print("  and {} more\n", outside.size() - most);
    return exit_outside;
}

int suite_command(Options& options) {
    SuiteOptions& suite = options.suite;
    suite.checkpoint_interval = options.checkpoint_interval;
    suite.directory = options.out.empty() ? fs::path("results") / suite.tier : fs::path(options.out);
    suite.quiet = options.quiet;
    if (options.plan) return print_plan(suite, options.json), exit_done;
    if (suite.row) return run_suite(suite);
    std::vector<std::string> planned;
    const std::vector<SuiteRow> rows = suite_rows(suite);
    for (const SuiteRow& row : rows) planned.push_back(fs::relative(row.directory, suite.directory).string());
    write_suite_plan(suite.directory, suite.tier, planned);
    if (options.executor == "slurm") return submit_suite(suite, options.slurm), exit_done;
    const int worst = run_rows(rows, suite);
    const int judged = tell_report(make_report(suite.directory), suite.directory);
    return worst != 0 ? worst : judged;
}

int verify_command(Options& options) {
    VerifyOptions& verify = options.verify;
    verify.directory = options.out.empty() ? fs::path("results") / "verification" : fs::path(options.out);
    const std::vector<VerificationProblem> results = run_verification(verify);
    const int judged = tell_report(make_report(verify.directory), verify.directory);
    return any_unstable(results) ? exit_unstable : judged;
}

int ablate_command(Options& options) {
    options.suite.directory =
        options.out.empty() ? fs::path("results") / options.suite.tier : fs::path(options.out);
    options.suite.checkpoint_interval = options.checkpoint_interval;
    options.suite.quiet = options.quiet;
    AblateOptions ablate;
    ablate.scene = options.scene;
    if (!options.variant.empty()) ablate.variant = options.variant;
    ablate.particle_spacing = chosen_spacing(options);
    if (options.until != 0) ablate.until = options.until;
    const bool stable = run_ablation(ablate, options.suite);
    fmt::print("report: {}\n", (options.suite.directory / "index.html").string());
    return stable ? exit_done : exit_unstable;
}

int bench_command(const Options& options) {
    const Benchmark benchmark = run_benchmark(options.bench);
    const std::string text = benchmark_json(benchmark).dump(1) + "\n";
    if (!options.json_file.empty()) atomic_write(options.json_file, text);
    fmt::print("{}", options.json && options.json_file.empty() ? text : benchmark_table(benchmark));
    return exit_done;
}

int stress_command(Options& options) {
    StressOptions& stress = options.stress;
    stress.directory = options.out.empty() ? fs::path("results") / "stress" : fs::path(options.out);
    const bool survived = run_stress(stress);
    make_report(stress.directory);
    fmt::print("report: {}\n", (stress.directory / "index.html").string());
    return survived ? exit_done : exit_outside;
}

int report_command(const Options& options) {
    const Summary summary = make_report(options.out);
    const int judged = tell_report(summary, options.out);
    if (!options.publish.empty()) publish(summary, options.out, options.publish);
    return judged;
}

int baseline_command(const Options& options) {
    if (options.action == "write") {
        write_baseline(options.out, options.baseline, options.replace);
        fmt::print("baseline: {}\n", options.baseline);
        return exit_done;
    }
    const std::vector<std::string> deviations = compare_with_baseline(options.out, options.baseline);
    if (options.json) {
        const nlohmann::json all = {{"baseline", options.baseline}, {"deviations", deviations}};
        fmt::print("{}\n", all.dump(1));
        return deviations.empty() ? exit_done : exit_outside;
    }
    for (const std::string& line : deviations) fmt::print("{}\n", line);
    fmt::print("{} deviations from {}\n", deviations.size(), options.baseline);
    return deviations.empty() ? exit_done : exit_outside;
}

/// Reads the curves that a scene is compared with, and returns those that are not there. Throws DataError
/// where one is not sound or lacks a column.
std::set<std::string> missing_references(const Scene& scene) {
    ReferenceShelf shelf(reference_directory() / scene.name(), scene.analysis.folder);
    std::set<std::string> missing;
    for (const ComparisonSpec& c : scene.analysis.comparisons) {
        if (is_analytic(c.reference)) continue;  // checked when the scene was read
        if (const Reference* reference = shelf.find(c.reference)) {
            column_curve(*reference, c.x_column, c.y_column);
        } else {
            missing.insert(c.reference);
        }
    }
    return missing;
}

/// What was found in a scene file, read in every variant with its reference curves, or in a reference curve.
nlohmann::json checked(const std::string& file) {
    if (fs::path(file).extension() == ".csv") {
        const Reference reference = load_reference(file);
        return {{"kind", reference.kind}, {"columns", reference.columns.size()}};
    }
    const Scene scene = read_scene(file);
    const std::set<std::string> missing = missing_references(scene);
    std::vector<std::string> variants, doubts;
    for (const VariantInfo& variant : scene.variants) {
        variants.push_back(variant.name);
        const Scene varied = read_scene(file, variant.name);
        for (const std::string& doubt : doubtful(varied)) {
            if (std::find(doubts.begin(), doubts.end(), doubt) == doubts.end()) doubts.push_back(doubt);
        }
        for (const auto& [tier, spacings_of] : varied.tiers) {
            const auto spacings = spacings_of.find(variant.name);
            if (spacings == spacings_of.end()) continue;
            for (const double dx : spacings->second) check_row(varied, tier, dx);
        }
    }
    return {
        {"scene", scene.name()}, {"variants", variants}, {"missing_references", missing}, {"doubts", doubts}};
}

int check_command(const Options& options) {
    const std::string& file = options.scene;
    const auto print = [&](bool valid, nlohmann::json found) {
        found["file"] = file;
        found["valid"] = valid;
        fmt::print("{}\n", found.dump(1));
    };
    try {
        const nlohmann::json found = checked(file);
        if (options.json) {
            print(true, found);
        } else if (found.contains("scene")) {
            fmt::print("{}: scene '{}' with {} variants, no error found\n", file,
                       found["scene"].get<std::string>(), found["variants"].size());
            for (const auto& name : found["missing_references"])
                fmt::print(
                    "no file {}.csv beside the scene or in reference_data/: its comparison will be "
                    "left out\n",
                    name.get<std::string>());
            for (const auto& doubt : found["doubts"]) fmt::print("meant so? {}\n", doubt.get<std::string>());
        } else {
            fmt::print("{}: {} reference, {} columns, no error found\n", file,
                       found["kind"].get<std::string>(), found["columns"].get<int>());
        }
    } catch (const InputError& error) {
        if (options.json) print(false, {{"message", error.what()}});
        throw;
    }
    return exit_done;
}

Provenance provenance() {
    return collect_provenance(pair_passes(Model{}, instruction_set_from_environment()).instruction_set,
                              static_cast<unsigned>(omp_get_max_threads()));
}

int version_command(bool as_json) {
    const Provenance p = provenance();
    if (as_json) {
        const nlohmann::json all = {
            {"version", p.program_version}, {"commit", p.commit}, {"compiler", p.compiler},
            {"build_type", p.build_type},   {"simd", p.simd},     {"threads", p.threads}};
        fmt::print("{}\n", all.dump(1));
        return exit_done;
    }
    fmt::print("wetdeck {}\ncommit {}\ncompiler {} ({})\ninstruction set {}\nthreads {}\n", p.program_version,
               p.commit, p.compiler, p.build_type, p.simd, p.threads);
    return exit_done;
}

/// What the build and the shell ask for; no user does.
std::optional<int> answer_tool(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "--manual") {
        fmt::print("{}", manual_page(provenance().program_version));
    } else if (what == "--complete") {
        for (const std::string& word : completions({argv + 2, argv + argc})) fmt::print("{}\n", word);
    } else {
        return std::nullopt;
    }
    return exit_done;
}

int dispatch(int argc, char** argv) {
    if (const std::optional<int> answered = answer_tool(argc, argv)) return *answered;
    ParsedCommandLine parsed = parse_command_line(argc, argv);
    if (parsed.exit_code) return *parsed.exit_code;
    Options& options = parsed.options;
    const std::string& command = options.command;
    if (options.version) return version_command(options.json);
    if (command == "run" || command == "resume" || command == "suite" || command == "ablate")
        catch_stop_signals();
    if (command == "suite") return suite_command(options);
    if (command == "run") return run_command(options);
    if (command == "resume") return resume_command(options);
    if (command == "verify") return verify_command(options);
    if (command == "ablate") return ablate_command(options);
    if (command == "bench") return bench_command(options);
    if (command == "stress") return stress_command(options);
    if (command == "report") return report_command(options);
    if (command == "baseline") return baseline_command(options);
    if (command == "list") return print_list(options.json), exit_done;
    if (command == "describe") return print_description(options.scene, options.json), exit_done;
    if (command == "check") return check_command(options);
    fmt::print("{}", help_text());
    return exit_done;
}

}  // namespace
}  // namespace wetdeck

int main(int argc, char** argv) {
    using namespace wetdeck;
    try {
        return dispatch(argc, argv);
    } catch (const Interrupted& stop) {
        complain(stop.what());
        return stop.exit_code();
    } catch (const InputError& error) {
        complain(error.what());
        return exit_usage;
    } catch (const EnvironmentError& error) {
        complain(error.what());
        return exit_environment;
    } catch (const std::exception& error) {
        complain(error.what());
        return exit_environment;
    }
}
