// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck bench`: the speed of the solver on this machine.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "validation/benchmark/benchmark.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

struct BenchOptions {
    BenchmarkOptions benchmark;
    std::optional<std::string> json;  ///< file; empty: stdout, in place of the table
};

int bench(const BenchOptions& options) {
    const Benchmark benchmark = run_benchmark(options.benchmark);
    const std::string text = benchmark_json(benchmark).dump(1) + "\n";
    const bool to_file = options.json && !options.json->empty();
    if (to_file) atomic_write(*options.json, text);
    fmt::print("{}", options.json && !to_file ? text : benchmark_table(benchmark));
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
    command
        .add_option("--precision", options->benchmark.precision, "of the sums over pairs: double or mixed")
        ->transform(CLI::CheckedTransformer(std::map<std::string, Precision>{
            {"double", Precision::double_precision}, {"mixed", Precision::mixed}}))
        ->type_name("P")
        ->default_str("double");
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
