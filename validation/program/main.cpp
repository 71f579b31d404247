// SPDX-License-Identifier: BSD-3-Clause
// The command line. Exit codes: 0 done and within tolerance; 1 outside a stated tolerance; 2 bad usage or
// input; 3 a run became unstable; 4 the environment failed; 130, 143 stopped by SIGINT, SIGTERM.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "solver/pair_loop/pair_loop.hpp"
#include "validation/benchmark/benchmark.hpp"
#include "validation/execute/ablate.hpp"
#include "validation/execute/assemble.hpp"
#include "validation/execute/baseline.hpp"
#include "validation/execute/publish.hpp"
#include "validation/execute/report_command.hpp"
#include "validation/execute/run.hpp"
#include "validation/execute/slurm.hpp"
#include "validation/execute/stop_signal.hpp"
#include "validation/execute/stress.hpp"
#include "validation/execute/suite.hpp"
#include "validation/execute/verify.hpp"
#include "validation/metrics/ablation.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/program/describe.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/provenance.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

constexpr int exit_done = 0, exit_outside = 1, exit_usage = 2, exit_unstable = 3, exit_environment = 4;

struct Options {
    // run
    std::string scene;
    std::string variant;
    double particle_spacing = 0;
    std::vector<std::string> overrides;
    double until = 0;
    int threads = 0;
    bool replace = false;
    double checkpoint_interval = RunOptions{}.checkpoint_interval;
    // suite
    SuiteOptions suite;
    bool plan = false;
    std::string executor = "local";
    SlurmOptions slurm;
    // bench
    BenchmarkOptions bench;
    std::string json_file;
    // verify
    VerifyOptions verify;
    // stress
    StressOptions stress;
    // report, baseline
    std::string publish, action, baseline;
    // all
    std::string out;
    bool json = false, quiet = false;
};

void print_outcome(const RunRecord& record, const fs::path& directory) {
    const RunCost& cost = record.cost;
    fmt::print("{} {} dx {}: {}{}\n", record.scene, record.variant, record.particle_spacing,
               to_string(record.status), record.stop_reason.empty() ? "" : " " + record.stop_reason);
    fmt::print(
        "  {} fluid particles, {} steps in {:.2f} s: {:.2f} M particle-steps/s, {:.0f} bytes per particle\n",
        record.fluid_particles, cost.steps, cost.wall_s, cost.particle_steps / cost.wall_s / 1e6,
        record.parameters.at("bytes_per_particle"));
    fmt::print("  results in {}\n", directory.string());
}

int finish_run(const Scene& scene, RunOptions run, const Options& options) {
    run.threads = options.threads;
    run.checkpoint_interval = options.checkpoint_interval;
    Progress progress(fmt::format("{} {} dx {}", scene.name(), scene.variant, run.particle_spacing),
                      options.quiet);
    const RunRecord record = run_scene(scene, run, progress);
    print_outcome(record, run.directory);
    return record.status == RunStatus::ok ? exit_done : exit_unstable;
}

int run_command(const Options& options) {
    const fs::path path = find_scene(options.scene);
    const std::optional<std::string> variant =
        options.variant.empty() ? std::nullopt : std::optional<std::string>(options.variant);
    const Scene scene = read_scene(path, variant, options.overrides);
    RunOptions run;
    run.particle_spacing = options.particle_spacing;
    if (run.particle_spacing == 0) {
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
    if (holds_finished_run(options.out)) {
        const RunRecord record = read_run(run_file(options.out));
        fmt::print("the run had ended before, nothing is left to be done\n");
        print_outcome(record, options.out);
        return record.status == RunStatus::ok ? exit_done : exit_unstable;
    }
    const auto [scene, run] = interrupted_run(options.out);
    return finish_run(scene, run, options);
}

int suite_command(Options& options) {
    SuiteOptions& suite = options.suite;
    suite.checkpoint_interval = options.checkpoint_interval;
    suite.directory = options.out.empty() ? fs::path("results") / suite.tier : fs::path(options.out);
    if (options.plan) return print_plan(suite), exit_done;
    if (suite.row) return run_suite(suite);
    std::vector<std::string> planned;
    for (const SuiteRow& row : suite_rows(suite))
        planned.push_back(fs::relative(row.directory, suite.directory).string());
    write_suite_plan(suite.directory, suite.tier, planned);
    if (options.executor == "slurm") return submit_suite(suite, options.slurm), exit_done;
    const int worst = run_suite(suite);
    const Summary summary = make_report(suite.directory);
    fmt::print("report: {}\n", (suite.directory / "index.html").string());
    if (worst != 0) return worst;
    return within_tolerance(summary) ? exit_done : exit_outside;
}

int verify_command(Options& options) {
    VerifyOptions& verify = options.verify;
    verify.directory = options.out.empty() ? fs::path("results") / "verification" : fs::path(options.out);
    const std::vector<VerificationProblem> results = run_verification(verify);
    make_report(verify.directory);
    fmt::print("report: {}\n", (verify.directory / "index.html").string());
    if (any_unstable(results)) return exit_unstable;
    return all_within(results) ? exit_done : exit_outside;
}

int ablate_command(Options& options) {
    options.suite.directory =
        options.out.empty() ? fs::path("results") / options.suite.tier : fs::path(options.out);
    options.suite.checkpoint_interval = options.checkpoint_interval;
    AblateOptions ablate;
    ablate.scene = options.scene;
    if (!options.variant.empty()) ablate.variant = options.variant;
    ablate.particle_spacing = options.particle_spacing;
    if (options.until != 0) ablate.until = options.until;
    const bool stable = run_ablation(ablate, options.suite);
    fmt::print("report: {}\n", (options.suite.directory / "index.html").string());
    return stable ? exit_done : exit_unstable;
}

int bench_command(const Options& options, bool as_json) {
    const Benchmark benchmark = run_benchmark(options.bench);
    const std::string text = benchmark_json(benchmark).dump(1) + "\n";
    if (!options.json_file.empty()) atomic_write(options.json_file, text);
    fmt::print("{}", as_json && options.json_file.empty() ? text : benchmark_table(benchmark));
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
    fmt::print("report: {}\n", (fs::path(options.out) / "index.html").string());
    if (!options.publish.empty()) publish(summary, options.out, options.publish);
    return within_tolerance(summary) ? exit_done : exit_outside;
}

int baseline_command(const Options& options) {
    if (options.action == "write") {
        write_baseline(options.out, options.baseline, options.replace);
        return exit_done;
    }
    const std::vector<std::string> deviations = compare_with_baseline(options.out, options.baseline);
    for (const std::string& line : deviations) fmt::print("{}\n", line);
    fmt::print("{} deviations from {}\n", deviations.size(), options.baseline);
    return deviations.empty() ? exit_done : exit_outside;
}

/// A scene file in every variant, or a reference curve.
int check_command(const std::string& file) {
    if (fs::path(file).extension() == ".csv") {
        const Reference reference = load_reference(file);
        fmt::print("{}: {} reference, {} columns, no error found\n", file, reference.kind,
                   reference.columns.size());
        return exit_done;
    }
    const Scene scene = read_scene(file);
    for (const VariantInfo& variant : scene.variants) {
        const Scene varied = read_scene(file, variant.name);
        for (const auto& [tier, variants] : varied.tiers) {
            const auto spacings = variants.find(variant.name);
            if (spacings == variants.end()) continue;
            for (const double dx : spacings->second) check_spacing(varied, dx);
        }
    }
    fmt::print("{}: scene '{}' with {} variants, no error found\n", file, scene.name(),
               scene.variants.size());
    return exit_done;
}

int version_command() {
    const Model model;
    const Provenance p =
        collect_provenance(pair_loops(model).instruction_set, static_cast<unsigned>(omp_get_max_threads()));
    fmt::print("wetdeck {}\ncommit {}\ncompiler {} ({})\ninstruction set {}\nthreads {}\n", p.program_version,
               p.commit, p.compiler, p.build_type, p.simd, p.threads);
    return exit_done;
}

int dispatch(int argc, char** argv) {
    Options options;
    CLI::App app{
        "wetdeck: two-phase SPH of bodies that slam into water, checked against experiments and exact "
        "solutions"};
    app.require_subcommand(0, 1);
    bool version = false;
    app.add_flag("--version", version, "version, commit, compiler, instruction set, threads");
    app.footer(
        "Exit codes: 0 done and within tolerance, 1 outside a stated tolerance, 2 bad usage or input,\n"
        "3 a run became unstable, 4 the environment failed (disk full, no permission),\n"
        "130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM.\n"
        "run, resume, suite and ablate stop cleanly: each run writes a checkpoint and says how to go on "
        "(`wetdeck "
        "resume\n"
        "RUN_DIR`, or the same command again). A second signal ends the program at once; then, as "
        "after\n"
        "kill -9 or a power cut, the last periodic checkpoint counts.");

    CLI::App* suite = app.add_subcommand(
        "suite", "run every scene, spacing and variant of a tier, compare, write the report");
    suite->add_option("--tier", options.suite.tier, "quick, standard or paper")->capture_default_str();
    suite->add_option("--only", options.suite.scenes, "scenes to run, separated by commas")->delimiter(',');
    suite->add_option("--out", options.out, "directory of the results (results/TIER)");
    suite->add_option("--jobs", options.suite.jobs, "runs at a time (one per core)")
        ->check(CLI::Range(1, 4096));
    suite->add_option("--threads", options.suite.threads, "threads of each run (the cores shared out)")
        ->check(CLI::Range(1, 4096));
    suite->add_flag("--plan", options.plan, "print the rows with their cost and state, run nothing");
    suite->add_option("--row", options.suite.row, "run this row of the plan alone, without a report");
    suite
        ->add_option("--executor", options.executor,
                     "local, or slurm: submit what is left to do as a job array")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->capture_default_str();
    suite->add_option("--partition", options.slurm.partition, "slurm: partition (the cluster's default)");
    suite->add_option("--concurrent", options.slurm.concurrent, "slurm: jobs at a time (no limit)")
        ->check(CLI::Range(1, 100000));
    suite->add_flag("--fresh", options.suite.fresh, "run again what is finished");

    CLI::App* run = app.add_subcommand("run", "one run of a scene");
    run->add_option("scene", options.scene, "name from `wetdeck list`, or path of a scene file")->required();
    run->add_option("--variant", options.variant, "variant of the scene (its default)");
    run->add_option("--dx", options.particle_spacing, "particle spacing [m] (the finest of the quick tier)");
    run->add_option("--set", options.overrides, "KEY=VALUE: overrides a key of the scene file")
        ->allow_extra_args(false);
    run->add_option("--until", options.until, "stop time [s] (the scene's)");
    run->add_option("--out", options.out, "run directory (results/runs/...)");
    run->add_option("--threads", options.threads, "threads (all)")->check(CLI::Range(1, 4096));
    run->add_flag("--replace", options.replace, "replace the run that the directory holds");
    run->add_flag("--quiet", options.quiet, "no progress");
    run->footer(
        "A directory that holds the same run, interrupted, is gone on with from its last checkpoint.");

    CLI::App* resume = app.add_subcommand(
        "resume", "go on with an interrupted run from its last checkpoint; ends with the same bits");
    resume->add_option("directory", options.out, "run directory")->required();
    resume->add_option("--threads", options.threads, "threads (all)")->check(CLI::Range(1, 4096));
    resume->add_flag("--quiet", options.quiet, "no progress");
    for (CLI::App* command : {run, resume, suite})
        command
            ->add_option("--checkpoint-interval", options.checkpoint_interval,
                         "wall seconds between checkpoints; further apart where they would cost more than 1 "
                         "%; 0: as often as can be")
            ->check(CLI::Range(0.0, 1e9))
            ->capture_default_str();

    CLI::App* ablate = app.add_subcommand(
        "ablate", "leave out one ingredient of a scene's model at a time: what it buys and costs");
    ablate->add_option("scene", options.scene, "name or path")->required();
    ablate->add_option("--variant", options.variant, "variant of the scene (its default)");
    ablate->add_option("--dx", options.particle_spacing,
                       "particle spacing [m] (the coarsest of the quick tier)");
    ablate->add_option("--until", options.until, "stop time [s] (the scene's)");
    ablate->add_option("--out", options.out, "directory of the results (results/quick)");
    ablate->add_option("--jobs", options.suite.jobs, "runs at a time (one per core)")
        ->check(CLI::Range(1, 4096));
    ablate->add_flag("--fresh", options.suite.fresh, "run again what is finished");
    ablate->footer(std::string("Verdict: ") + ablation_rule + ".");

    CLI::App* bench = app.add_subcommand(
        "bench", "speed of the solver by stage and threads, and its share of what this machine could do");
    bench->add_option("--threads", options.bench.threads, "largest number of threads (all)")
        ->check(CLI::Range(1, 4096));
    bench->add_option("--dx", options.bench.particle_spacing, "particle spacing of the dam break [m]")
        ->check(CLI::Range(1e-6, 1e3))
        ->capture_default_str();
    bench->add_option("--repeats", options.bench.repeats, "of each measurement")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    CLI::Option* bench_json =
        bench->add_option("--json", options.json_file, "JSON to this file, or instead of the table")
            ->expected(0, 1);

    CLI::App* verify =
        app.add_subcommand("verify", "problems with exact solutions: error and observed order");
    verify->add_option("--only", options.verify.problems, "problems to run, separated by commas")
        ->delimiter(',');
    verify->add_option("--out", options.out, "directory of the results (results/verification)");
    verify->add_flag("--fast", options.verify.fast, "coarse resolutions of the quick problems only");

    CLI::App* stress = app.add_subcommand(
        "stress", "hard cases: what the default scheme, the paper's and none of the dissipation survive");
    stress->add_option("--only", options.stress.cases, "cases to run, separated by commas")->delimiter(',');
    stress->add_option("--out", options.out, "directory of the results (results/stress)");
    stress->add_option("--jobs", options.stress.jobs, "runs at a time (one per core)")
        ->check(CLI::Range(1, 4096));
    stress->add_flag("--fast", options.stress.fast,
                     "the quick settings with the default scheme alone, no search for limits");

    CLI::App* report = app.add_subcommand("report", "write the report again from the stored runs alone");
    report->add_option("directory", options.out, "directory of a suite or a run")->required();

    report->add_option("--publish", options.publish,
                       "also write small tables and figures to this folder, in one named after the tier");

    CLI::App* baseline = app.add_subcommand(
        "baseline", "keep what the runs of a directory gave, or compare with what was kept");
    baseline->add_option("action", options.action, "write or compare")
        ->required()
        ->check(CLI::IsMember({"write", "compare"}));
    baseline->add_option("directory", options.out, "directory of a suite or a run")->required();
    baseline->add_option("--file", options.baseline, "the baseline, a JSON file")->required();
    baseline->add_flag("--replace", options.replace, "replace the baseline that is there");

    CLI::App* list =
        app.add_subcommand("list", "scenes and their variants, problems with exact solutions, hard cases");
    list->add_flag("--json", options.json, "as JSON");
    CLI::App* describe = app.add_subcommand("describe", "set-up, references and cost of one scene");
    describe->add_option("scene", options.scene, "name or path")->required();
    CLI::App* check =
        app.add_subcommand("check", "validate a scene file (.toml) or a reference curve (.csv)");
    check->add_option("file", options.scene, "path")->required();

    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "wetdeck: {}; see wetdeck --help\n", error.what());
        return exit_usage;
    }
    if (version) return version_command();
    if (*run || *resume || *suite || *ablate) catch_stop_signals();
    if (*suite) return suite_command(options);
    if (*run) return run_command(options);
    if (*resume) return resume_command(options);
    if (*verify) return verify_command(options);
    if (*ablate) return ablate_command(options);
    if (*bench) return bench_command(options, bench_json->count() > 0);
    if (*stress) return stress_command(options);
    if (*report) return report_command(options);
    if (*baseline) return baseline_command(options);
    if (*list) return print_list(options.json), exit_done;
    if (*describe) return print_description(options.scene), exit_done;
    if (*check) return check_command(options.scene);
    std::cout << app.help();
    return exit_done;
}

}  // namespace
}  // namespace wetdeck

int main(int argc, char** argv) {
    using namespace wetdeck;
    try {
        return dispatch(argc, argv);
    } catch (const Interrupted& stop) {
        fmt::print(stderr, "wetdeck: {}\n", stop.what());
        return stop.exit_code();
    } catch (const InputError& error) {
        fmt::print(stderr, "wetdeck: {}\n", error.what());
        return exit_usage;
    } catch (const EnvironmentError& error) {
        fmt::print(stderr, "wetdeck: {}\n", error.what());
        return exit_environment;
    } catch (const std::exception& error) {
        fmt::print(stderr, "wetdeck: {}\n", error.what());
        return exit_environment;
    }
}
