// SPDX-License-Identifier: BSD-3-Clause
#include "validation/benchmark/against.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "solver/core/errors.hpp"
#include "validation/store/child_process.hpp"
#include "validation/store/run_store.hpp"
#include "validation/store/temporary_folder.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

constexpr double end = 0.5;  // of the runs [s]: the front is on its way

std::string last_line_of(const std::string& text) {
    const std::size_t line = text.find_last_of('\n');
    return line == std::string::npos ? text : text.substr(line + 1);
}

/// What a program runs with: its own data, as many threads as asked for.
std::string command_of(const fs::path& program, bool other, int threads) {
    std::string command = "env";
    if (other) command += " -u WETDECK_DATA";
    if (threads > 0) command += fmt::format(" OMP_NUM_THREADS={}", threads);
    return command + " " + shell_quoted(program.string());
}

/// The cost of one run.
RunCost cost_of_run(const std::string& command, const std::string& variant, double particle_spacing,
                    const fs::path& folder) {
    const ShellResult result =
        run_in_shell(fmt::format("{} run dam_break --variant {} --dx {} --until {} --out {}", command,
                                 variant, particle_spacing, end, shell_quoted(folder.string())));
    // values outside their tolerance are no failure of the run
    if (result.status > 1)
        throw InputError(fmt::format("{}: run of dam_break, {}, ended with status {}: {}", command, variant,
                                     result.status, last_line_of(result.output)));
    const RunCost cost = read_run(folder / "run.h5").cost;
    fs::remove_all(folder);
    if (!(cost.wall_s > 0 && cost.particle_steps > 0))
        throw InputError(fmt::format("{}: its run.h5 holds no cost", command));
    return cost;
}

double rate(const RunCost& cost) {
    return cost.particle_steps / cost.wall_s;
}

}  // namespace

Comparison compare_builds(const AgainstOptions& options) {
    Comparison comparison{options, {}, {}};
    std::error_code error;
    if (!fs::is_regular_file(options.program, error))
        throw InputError(fmt::format("--against {}: no such program", options.program.string()));
    const fs::path ours = fs::read_symlink("/proc/self/exe");
    const std::string our_command = command_of(ours, false, options.threads);
    const std::string their_command = command_of(fs::absolute(options.program), true, options.threads);
    const ShellResult version = run_in_shell(their_command + " --version");
    if (!version.succeeded())
        throw InputError(fmt::format("--against {}: --version ended with status {}: {}",
                                     options.program.string(), version.status, last_line_of(version.output)));
    comparison.version = version.output.substr(0, version.output.find('\n'));
    const TemporaryFolder workplace;
    for (const char* const variant : {"two-phase", "single-phase"}) {
        std::vector<double> ratios, wall_ratios, our_rates, their_rates;
        for (int pair = 0; pair < options.repeats; ++pair) {
            const auto run = [&](bool other) {
                return cost_of_run(other ? their_command : our_command, variant, options.particle_spacing,
                                   workplace.path() / (other ? "theirs" : "ours"));
            };
            const bool other_first = pair % 2 == 1;
            RunCost first = run(other_first), second = run(!other_first);
            if (other_first) std::swap(first, second);
            ratios.push_back(rate(first) / rate(second));
            wall_ratios.push_back(second.wall_s / first.wall_s);
            our_rates.push_back(rate(first));
            their_rates.push_back(rate(second));
        }
        comparison.variants.push_back(
            {variant, measured(ratios), measured(wall_ratios), median_of(our_rates), median_of(their_rates)});
    }
    return comparison;
}

std::string comparison_table(const Comparison& comparison) {
    const AgainstOptions& options = comparison.options;
    std::string text = fmt::format(
        "dam break at {} m to {} s, {} pairs of runs in turn, against {} ({})\n"
        "{:14} {:>16} {:>16} {:>10} {:>10} {:>18}\n",
        options.particle_spacing, end, options.repeats, options.program.string(), comparison.version,
        "variant", "ours [steps/s]", "theirs [steps/s]", "ratio", "+-", "ratio of wall time");
    for (const PairedRuns& runs : comparison.variants)
        text +=
            fmt::format("{:14} {:>16.3g} {:>16.3g} {:>10.3f} {:>10.3f} {:>18.3f}\n", runs.variant, runs.ours,
                        runs.theirs, runs.ratio.median, runs.ratio.deviation, runs.wall_ratio.median);
    return text +
           "ratio: median over the pairs of particle-steps per second, ours over theirs; +- its median "
           "absolute deviation\n";
}

nlohmann::json comparison_json(const Comparison& comparison) {
    nlohmann::json all = {{"against", comparison.options.program.string()},
                          {"version", comparison.version},
                          {"dx", comparison.options.particle_spacing},
                          {"repeats", comparison.options.repeats},
                          {"threads", comparison.options.threads}};
    for (const PairedRuns& runs : comparison.variants) {
        all["ratio"][runs.variant] = runs.ratio.median;
        all["deviation"][runs.variant] = runs.ratio.deviation;
        all["wall_ratio"][runs.variant] = runs.wall_ratio.median;
    }
    return all;
}

}  // namespace wetdeck
