// SPDX-License-Identifier: BSD-3-Clause
// A benchmark as a table to read and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "validation/benchmark/benchmark.hpp"
#include "validation/store/provenance.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

/// On a quiet machine the process gets a larger share of its processors.
constexpr double quiet_share = 0.95;

json measured_json(const Measured& m) {
    return {{"median", m.median}, {"mad", m.deviation}};
}

json share_json(const PassShare& share) {
    return {{"arithmetic", share.arithmetic}, {"traffic", share.traffic}, {"limit", share.limit()}};
}

json case_json(const BenchmarkCase& c) {
    json stages = json::object();
    for (const auto& [name, rate] : c.stages) stages[name] = measured_json(rate);
    return {
        {"variant", c.variant},
        {"phases", c.phases},
        {"threads", c.threads},
        {"fluid_particles", c.particles},
        {"particle_steps_per_s", measured_json(c.rate)},
        {"particle_steps_per_core_s", measured_json(c.core_rate)},
        {"processor_share", c.processor_share},
        {"stages_particle_steps_per_s", stages},
        {"neighbours_per_particle", c.neighbours},
        {"listed_per_cluster", c.listed},
        {"steps_per_list_build", c.steps_per_build},
        {"bytes_per_particle", c.bytes_per_particle},
        {"instructions_per_particle_step", c.instructions ? json(*c.instructions) : json()},
        {"limits",
         {{"density_neighbours_per_s", c.arithmetic.density},
          {"momentum_neighbours_per_s", c.arithmetic.momentum},
          {"triad_bytes_per_s", c.triad},
          {"triad_memory_bytes_per_s", c.memory_triad}}},
        {"share_of_limit",
         {{"density", share_json(c.density)}, {"momentum", share_json(c.momentum)}, {"step", c.step_share}}}};
}

/// In millions per second; the deviation as a share of the median.
std::string rate_text(const Measured& rate) {
    if (rate.median <= 0) return "-";
    return fmt::format("{:.4g} ±{:.0f}%", rate.median / 1e6, 100 * rate.deviation / rate.median);
}

/// A text of one column per case, the label in front.
template <class Cell>
std::string line(const std::string& label, const Benchmark& benchmark, const Cell& cell) {
    std::string out = fmt::format("{:<34}", label);
    for (const BenchmarkCase& c : benchmark.cases) out += fmt::format("{:>20}", cell(c));
    return out + "\n";
}

std::string precision_name(const Benchmark& benchmark) {
    return benchmark.precision == Precision::mixed ? "mixed" : "double";
}

}  // namespace

std::string benchmark_table(const Benchmark& benchmark) {
    const auto number = [](double value) { return fmt::format("{:.3g}", value); };
    const auto share = [](const PassShare& s) {
        return fmt::format("{:.2f} ({:.2f}, {:.2f})", s.limit(), s.arithmetic, s.traffic);
    };
    std::string out = fmt::format(
        "dam_break at {} m from the middle of its run, {}, {} precision; {} repeats of {} steps, median ± "
        "median absolute "
        "deviation\n",
        benchmark.particle_spacing, benchmark.instruction_set, precision_name(benchmark), benchmark.repeats,
        benchmark.steps);
    out += line("", benchmark, [](const BenchmarkCase& c) { return c.variant; });
    out += line("threads", benchmark, [](const BenchmarkCase& c) { return std::to_string(c.threads); });
    out += line("fluid particles", benchmark,
                [](const BenchmarkCase& c) { return std::to_string(c.particles); });
    out += line("M particle-steps/s: whole step", benchmark,
                [](const BenchmarkCase& c) { return rate_text(c.rate); });
    out += line("  per processor second", benchmark,
                [](const BenchmarkCase& c) { return rate_text(c.core_rate); });
    out += line("  share of its processors", benchmark,
                [&](const BenchmarkCase& c) { return number(c.processor_share); });
    const std::size_t stages = benchmark.cases.front().stages.size();
    for (std::size_t k = 0; k < stages; ++k) {
        out += line("  " + benchmark.cases.front().stages[k].first, benchmark,
                    [k](const BenchmarkCase& c) { return rate_text(c.stages[k].second); });
    }
    out += line("neighbours per particle", benchmark,
                [&](const BenchmarkCase& c) { return number(c.neighbours); });
    out +=
        line("  listed for its cluster", benchmark, [&](const BenchmarkCase& c) { return number(c.listed); });
    out += line("steps per list build", benchmark,
                [&](const BenchmarkCase& c) { return number(c.steps_per_build); });
    out += line("bytes per particle", benchmark,
                [&](const BenchmarkCase& c) { return number(c.bytes_per_particle); });
    out += line("instructions per particle-step", benchmark, [](const BenchmarkCase& c) {
        return c.instructions ? fmt::format("{:.0f}", *c.instructions) : "-";
    });
    out += line("arithmetic limit, M listed/s", benchmark, [](const BenchmarkCase& c) {
        return fmt::format("{:.0f}, {:.0f}", c.arithmetic.density / 1e6, c.arithmetic.momentum / 1e6);
    });
    out += line("triad, GB/s (in main memory)", benchmark, [](const BenchmarkCase& c) {
        return fmt::format("{:.3g} ({:.3g})", c.triad / 1e9, c.memory_triad / 1e9);
    });
    out += line("share of the limit: density", benchmark,
                [&](const BenchmarkCase& c) { return share(c.density); });
    out += line("  momentum", benchmark, [&](const BenchmarkCase& c) { return share(c.momentum); });
    out += line("  whole step", benchmark,
                [](const BenchmarkCase& c) { return fmt::format("{:.2f}", c.step_share); });
    out +=
        "Share of the limit: the larger of (arithmetic, memory). Arithmetic: time of the same pass with all "
        "neighbours in\n"
        "the first-level cache, over the time taken; its limit is given for density, momentum. Memory: time "
        "to "
        "read and write\n"
        "states, list and results once at the bandwidth of the triad, over the time taken. Whole step: both "
        "passes at their\n"
        "limits, over the whole step. Instructions are those of one thread, where the machine counts them.\n";
    const bool busy = std::any_of(benchmark.cases.begin(), benchmark.cases.end(),
                                  [](const BenchmarkCase& c) { return c.processor_share < quiet_share; });
    if (busy)
        out +=
            "Other processes used the processors: rates of stages and shares of limits are too low; the "
            "rate per processor second is valid.\n";
    return out;
}

json benchmark_json(const Benchmark& benchmark) {
    int threads = 1;
    json cases = json::array();
    for (const BenchmarkCase& c : benchmark.cases) {
        cases.push_back(case_json(c));
        threads = std::max(threads, c.threads);
    }
    std::map<std::string, std::string> machine;
    collect_provenance(benchmark.instruction_set, static_cast<unsigned>(threads)).add_to(machine);
    return {{"schema", 1},
            {"scene", "dam_break"},
            {"dx", benchmark.particle_spacing},
            {"repeats", benchmark.repeats},
            {"precision", precision_name(benchmark)},
            {"steps_per_repeat", benchmark.steps},
            {"machine", machine},
            {"cases", std::move(cases)}};
}

}  // namespace wetdeck
