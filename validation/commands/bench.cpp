// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck bench`: the speed of the solver on this machine.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "validation/benchmark/against.hpp"
#include "validation/benchmark/benchmark.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

struct BenchOptions {
    BenchmarkOptions benchmark;
    std::string against;              ///< another build of this program; empty: none
    std::optional<std::string> json;  ///< file; empty: stdout, in place of the table
};

/// A table, or JSON in its place, or both where there is a file for it.
void print(const BenchOptions& options, const nlohmann::json& json, const std::string& table) {
    const std::string text = json.dump(1) + "\n";
    const bool to_file = options.json && !options.json->empty();
    if (to_file) atomic_write(*options.json, text);
    fmt::print("{}", options.json && !to_file ? text : table);
}

int bench(const BenchOptions& options) {
    const BenchmarkOptions& chosen = options.benchmark;
    if (!options.against.empty()) {
        const Comparison comparison =
            compare_builds({options.against, chosen.particle_spacing, chosen.repeats, chosen.threads});
        print(options, comparison_json(comparison), comparison_table(comparison));
        return exit_done;
    }
    const Benchmark benchmark = run_benchmark(chosen);
    print(options, benchmark_json(benchmark), benchmark_table(benchmark));
    return exit_done;
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<BenchOptions>();
    CLI::App& command = *app.add_subcommand(
        "bench",
        "speed of the solver by stage and number of threads, compared with the limits of this machine");
    add_threads(command, options->benchmark.threads, "largest number of threads (default: all processors)");
    command.add_option("--dx", options->benchmark.particle_spacing, "particle spacing of the dam break [m]")
        ->check(CLI::Range(1e-6, 1e3))
        ->type_name("M")
        ->capture_default_str();
    command.add_option("--repeats", options->benchmark.repeats, "number of repeats of each measurement")
        ->check(CLI::Range(1, 100000))
        ->type_name("N")
        ->capture_default_str();
    const auto set_precision = [precision = &options->benchmark.precision](const std::string& name) {
        *precision = name == "mixed" ? Precision::mixed : Precision::double_precision;
    };
    command
        .add_option_function<std::string>("--precision", set_precision,
                                          "of the sums over pairs: double or mixed (default: double)")
        ->check(CLI::IsMember({"double", "mixed"}))
        ->type_name("P");
    command
        .add_option(
            "--against", options->against,
            "instead: the speed of whole runs over that of another build of wetdeck, in pairs in turn")
        ->type_name("PROGRAM");
    const auto set_json = [json = &options->json](const std::string& file) { *json = file; };
    command
        .add_option_function<std::string>("--json", set_json,
                                          "write JSON to this file, or without a file to stdout in place of "
                                          "the table")
        ->expected(0, 1)
        ->type_name("[FILE]");
    command.callback([options, &exit_code] { exit_code = bench(*options); });
}

}  // namespace wetdeck
