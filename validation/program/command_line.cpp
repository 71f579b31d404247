// SPDX-License-Identifier: BSD-3-Clause
#include "validation/program/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "validation/metrics/ablation.hpp"

namespace wetdeck {
namespace {

CLI::Option* add_count(CLI::App* command, const char* name, int& value, const char* description) {
    return command->add_option(name, value, description)->check(CLI::Range(1, 4096))->type_name("N");
}

CLI::Option* add_out(CLI::App* command, Options& options, const char* description) {
    return command->add_option("--out", options.out, description)->type_name("DIR");
}

void add_scene(CLI::App* command, Options& options) {
    command
        ->add_option("scene", options.scene, "name from `wetdeck list`, or path of a scene file of your own")
        ->required()
        ->type_name("");
}

void add_directory(CLI::App* command, Options& options, const char* description) {
    command->add_option("directory", options.out, description)->required()->type_name("");
}

void add_json(CLI::App* command, Options& options) {
    command->add_flag("--json", options.json, "JSON on stdout, for scripts");
}

void add_only(CLI::App* command, std::vector<std::string>& names, const char* description) {
    command->add_option("--only", names, description)->delimiter(',')->type_name("NAME,...");
}

void add_checkpoint_interval(CLI::App* command, Options& options) {
    command
        ->add_option("--checkpoint-interval", options.checkpoint_interval,
                     "wall seconds between checkpoints; further apart where they would cost more than 1 %; "
                     "0: as often as can be")
        ->check(CLI::Range(0.0, 1e9))
        ->type_name("SECONDS")
        ->capture_default_str();
}

void add_quiet(CLI::App* command, Options& options) {
    command->add_flag("-q,--quiet", options.quiet, "no progress, results and errors only");
}

void add_verbose(CLI::App* command, Options& options) {
    command->add_flag("-v,--verbose", options.verbose, "also where the time went and what set the step");
}

/// Variant, spacing and end of one run.
void add_run_choice(CLI::App* command, Options& options, const char* default_spacing) {
    command->add_option("--variant", options.variant, "variant of the scene (its default)")
        ->type_name("NAME");
    command
        ->add_option("--dx", options.particle_spacing,
                     fmt::format("particle spacing [m] ({})", default_spacing))
        ->type_name("M");
    command->add_option("--until", options.until, "stop time [s] (the scene's)")->type_name("S");
}

void add_suite(CLI::App& app, Options& options) {
    SuiteOptions& o = options.suite;
    CLI::App* suite = app.add_subcommand(
        "suite", "run every scene, spacing and variant of a tier, compare, write the report");
    suite->add_option("--tier", o.tier, "quick, standard or paper")->type_name("TIER")->capture_default_str();
    add_only(suite, o.scenes, "scenes to run, names or paths, separated by commas");
    add_out(suite, options, "directory of the results (results/TIER)");
    add_count(suite, "--jobs", o.jobs, "runs at a time (one per core)");
    add_count(suite, "--threads", o.threads, "threads of each run (the cores shared out)");
    suite->add_flag("--plan", options.plan, "print the rows with their cost and state, run nothing");
    suite->add_option("--row", o.row, "run this row of the plan alone, without a report")->type_name("N");
    suite
        ->add_option("--executor", options.executor,
                     "local, or slurm: submit what is left to do as a job array")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->type_name("NAME")
        ->capture_default_str();
    suite->add_option("--partition", options.slurm.partition, "slurm: partition (the cluster's default)")
        ->type_name("NAME");
    suite->add_option("--concurrent", options.slurm.concurrent, "slurm: jobs at a time (no limit)")
        ->check(CLI::Range(1, 100000))
        ->type_name("N");
    suite->add_flag("--fresh", o.fresh, "run again what is finished");
    add_checkpoint_interval(suite, options);
    suite->add_flag("--json", options.json, "with --plan: JSON on stdout, for scripts");
    add_quiet(suite, options);
}

void add_run(CLI::App& app, Options& options) {
    CLI::App* run = app.add_subcommand("run", "one run of a scene");
    add_scene(run, options);
    add_run_choice(run, options, "the finest of the quick tier");
    run->add_option("--set", options.overrides, "overrides a key of the scene file, may be given many times")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
    add_out(run, options, "run directory (results/runs/...)");
    add_count(run, "--threads", options.threads, "threads (all)");
    run->add_flag("--replace", options.replace, "replace the run that the directory holds");
    run->footer(
        "A directory that holds the same run, interrupted, is gone on with from its last checkpoint.");
    CLI::App* resume = app.add_subcommand(
        "resume", "go on with an interrupted run from its last checkpoint; ends with the same bits");
    add_directory(resume, options, "run directory");
    add_count(resume, "--threads", options.threads, "threads (all)");
    for (CLI::App* command : {run, resume}) {
        add_checkpoint_interval(command, options);
        add_json(command, options);
        add_quiet(command, options);
        add_verbose(command, options);
    }
}

void add_studies(CLI::App& app, Options& options) {
    CLI::App* verify =
        app.add_subcommand("verify", "problems with exact solutions: error and observed order");
    add_only(verify, options.verify.problems, "problems to run, separated by commas");
    add_out(verify, options, "directory of the results (results/verification)");
    verify->add_flag("--fast", options.verify.fast, "coarse resolutions of the quick problems only");

    CLI::App* stress = app.add_subcommand(
        "stress", "hard cases: what the default scheme, the paper's and none of the dissipation survive");
    add_only(stress, options.stress.cases, "cases to run, separated by commas");
    add_out(stress, options, "directory of the results (results/stress)");
    add_count(stress, "--jobs", options.stress.jobs, "runs at a time (one per core)");
    stress->add_flag("--fast", options.stress.fast,
                     "the quick settings with the default scheme alone, no search for limits");

    CLI::App* ablate = app.add_subcommand(
        "ablate", "leave out one ingredient of a scene's model at a time: what it buys and costs");
    add_scene(ablate, options);
    add_run_choice(ablate, options, "the coarsest of the quick tier");
    add_out(ablate, options, "directory of the results (results/quick)");
    add_count(ablate, "--jobs", options.suite.jobs, "runs at a time (one per core)");
    ablate->add_flag("--fresh", options.suite.fresh, "run again what is finished");
    add_quiet(ablate, options);
    ablate->footer(std::string("Verdict: ") + ablation_rule + ".");

    CLI::App* bench = app.add_subcommand(
        "bench", "speed of the solver by stage and threads, and its share of what this machine could do");
    add_count(bench, "--threads", options.bench.threads, "largest number of threads (all)");
    bench->add_option("--dx", options.bench.particle_spacing, "particle spacing of the dam break [m]")
        ->check(CLI::Range(1e-6, 1e3))
        ->type_name("M")
        ->capture_default_str();
    bench->add_option("--repeats", options.bench.repeats, "of each measurement")
        ->check(CLI::Range(1, 100000))
        ->type_name("N")
        ->capture_default_str();
    bench
        ->add_option_function<std::string>(
            "--json",
            [&options](const std::string& file) {
                options.json = true;
                options.json_file = file;
            },
            "JSON to this file, or instead of the table")
        ->expected(0, 1)
        ->type_name("[FILE]");
}

void add_reports(CLI::App& app, Options& options) {
    CLI::App* report = app.add_subcommand("report", "write the report again from the stored runs alone");
    add_directory(report, options, "directory of a suite or a run");
    report
        ->add_option("--publish", options.publish,
                     "also write small tables and figures to this folder, in one named after the tier")
        ->type_name("DIR");

    CLI::App* baseline = app.add_subcommand(
        "baseline", "keep what the runs of a directory gave, or compare with what was kept");
    baseline->add_option("action", options.action, "write or compare")
        ->required()
        ->check(CLI::IsMember({"write", "compare"}))
        ->type_name("");
    add_directory(baseline, options, "directory of a suite or a run");
    baseline->add_option("--file", options.baseline, "the baseline, a JSON file")
        ->required()
        ->type_name("FILE");
    baseline->add_flag("--replace", options.replace, "replace the baseline that is there");
    baseline->add_flag("--json", options.json, "with compare: JSON on stdout, for scripts");

    CLI::App* list =
        app.add_subcommand("list", "scenes and their variants, problems with exact solutions, hard cases");
    add_json(list, options);
    CLI::App* describe = app.add_subcommand("describe", "set-up, references and cost of one scene");
    add_scene(describe, options);
    add_json(describe, options);
    CLI::App* check =
        app.add_subcommand("check", "validate a scene file (.toml) or a reference curve (.csv)");
    check->add_option("file", options.scene, "path")->required()->type_name("");
    add_json(check, options);
}

std::unique_ptr<CLI::App> command_line(Options& options) {
    auto app = std::make_unique<CLI::App>(
        "wetdeck: two-phase SPH of bodies that slam into water, checked against experiments and exact "
        "solutions",
        "wetdeck");
    app->require_subcommand(0, 1);
    app->add_flag("--version", options.version, "version, commit, compiler, instruction set, threads");
    app->add_flag("--json", options.json, "with --version: JSON on stdout, for scripts");
    app->footer(
        "Exit codes: 0 done and within tolerance, 1 outside a stated tolerance, 2 bad usage or input,\n"
        "3 a run became unstable, 4 the environment failed (disk full, no permission),\n"
        "130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM.\n"
        "run, resume, suite and ablate stop cleanly: each run writes a checkpoint and says how to go on\n"
        "(`wetdeck resume RUN_DIR`, or the same command again). A second signal ends the program at once;\n"
        "then, as after kill -9 or a power cut, the last periodic checkpoint counts.");
    add_suite(*app, options);
    add_run(*app, options);
    add_studies(*app, options);
    add_reports(*app, options);
    return app;
}

CommandInfo describe(const CLI::App& command) {
    CommandInfo info{command.get_name(), command.get_description(), command.get_footer(), {}};
    for (const CLI::Option* option : command.get_options()) {
        const bool positional = option->get_positional();
        std::string name = positional ? option->get_name(true) : "--" + option->get_lnames().front();
        if (!option->get_snames().empty()) name = "-" + option->get_snames().front() + ", " + name;
        std::string description = option->get_description();
        if (const std::string preset = option->get_default_str(); !preset.empty())
            description += fmt::format(" ({})", preset);
        const bool takes_value = option->get_items_expected_max() > 0;
        const std::string value = option->get_type_name();  // its range behind a colon
        info.options.push_back(
            {name, takes_value ? value.substr(0, value.find(':')) : "", description, positional});
    }
    std::stable_partition(info.options.begin(), info.options.end(),
                          [](const OptionInfo& option) { return option.positional; });
    return info;
}

}  // namespace

ParsedCommandLine parse_command_line(int argc, char** argv) {
    ParsedCommandLine parsed;
    const auto app = command_line(parsed.options);
    try {
        app->parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        parsed.exit_code = app->exit(help);
    } catch (const CLI::ParseError& error) {
        complain(fmt::format("{}; see wetdeck --help", error.what()));
        parsed.exit_code = 2;
    }
    for (const CLI::App* command : app->get_subcommands()) parsed.options.command = command->get_name();
    return parsed;
}

std::string help_text() {
    Options options;
    return command_line(options)->help();
}

std::vector<CommandInfo> command_list() {
    Options options;
    const auto app = command_line(options);
    std::vector<CommandInfo> list = {describe(*app)};
    list.front().name.clear();
    for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; }))
        list.push_back(describe(*command));
    for (CommandInfo& command : list)
        if (command.footer == app->get_footer()) command.footer.clear();  // handed down to all
    return list;
}

void complain(std::string message) {
    std::replace_if(
        message.begin(), message.end(),
        [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
    fmt::print(stderr, "wetdeck: {}\n", message);
}

}  // namespace wetdeck
