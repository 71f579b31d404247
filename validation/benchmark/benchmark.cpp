// SPDX-License-Identifier: BSD-3-Clause
#include "validation/benchmark/benchmark.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "solver/core/errors.hpp"
#include "solver/core/processor_seconds.hpp"
#include "validation/benchmark/instruction_counter.hpp"
#include "validation/run/assemble.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/environment.hpp"

namespace wetdeck {
namespace {

/// The front has reached the far wall then: water in a thin layer, in bulk and against walls.
constexpr double mid_run = 0.3;  // of the end time
constexpr int steps_per_repeat = 64;
/// More than a last-level cache holds.
constexpr std::size_t memory_probe_bytes = 384'000'000;

constexpr std::array<std::pair<const char*, double StageTimes::*>, 6> timed_stages{
    {{"density", &StageTimes::density},
     {"momentum", &StageTimes::momentum},
     {"walls", &StageTimes::walls},
     {"bodies", &StageTimes::bodies},
     {"neighbours", &StageTimes::neighbours},
     {"integration", &StageTimes::integration}}};

/// 1, 2, 4, ... and the largest.
std::vector<int> thread_counts(int largest) {
    std::vector<int> counts;
    for (int threads = 1; threads < largest; threads *= 2) counts.push_back(threads);
    counts.push_back(largest);
    return counts;
}

Simulation::State state_in_mid_run(const Scene& scene, const BenchmarkOptions& options, int threads) {
    Simulation simulation = assemble(scene, options.particle_spacing, threads);
    const auto instability = simulation.run(mid_run * scene.end_time, [](const Simulation&) {});
    if (instability)
        throw InputError(fmt::format("the dam break becomes unstable at a spacing of {} m: {}",
                                     options.particle_spacing, instability->describe()));
    return simulation.state();
}

/// Neighbours within the support of a fluid particle, itself not counted.
double mean_neighbours(const Simulation& simulation) {
    const double reach = simulation.kernel().support_radius();
    const FluidParticles& fluid = simulation.fluid();
    const WallParticles& walls = simulation.walls();
    double found = 0;
    for (const Cluster& cluster : simulation.neighbours().clusters()) {
        const NeighbourBlocks& blocks = simulation.neighbours().blocks();
        for (std::uint32_t lane = 0; lane < cluster.count; ++lane) {
            const Vec2 here = fluid.state[cluster.first + lane].position();
            for (std::size_t phase = 0; phase < phase_count; ++phase)
                for (const std::uint32_t j : fluid_neighbours(blocks, cluster, phase))
                    found += (here - fluid.state[j].position()).norm() < reach ? 1 : 0;
            for (const std::uint32_t j : wall_neighbours(blocks, cluster))
                found += (here - Vec2(walls.state[j].x, walls.state[j].y)).norm() < reach ? 1 : 0;
        }
    }
    return found / static_cast<double>(fluid.size()) - 1;
}

/// What one pass over the pairs must read and write at least: states of fluid and walls once, the list, its
/// own result.
double pass_bytes(const Simulation& simulation, std::size_t results) {
    const auto particles = static_cast<double>(simulation.fluid().size());
    const auto walls = static_cast<double>(simulation.walls().size());
    const bool mixed = simulation.execution().precision == Precision::mixed;
    return particles * static_cast<double>((mixed ? sizeof(MixedState) : sizeof(FluidState)) +
                                           results * sizeof(double)) +
           walls * static_cast<double>(sizeof(WallState) + sizeof(WallMean)) +
           static_cast<double>(sizeof(std::uint32_t)) * listed_neighbours(simulation);
}

BenchmarkCase measure(const Scene& scene, const Simulation::State& start, const BenchmarkOptions& options,
                      int threads) {
    Simulation simulation = assemble(scene, options.particle_spacing, threads);
    simulation.restore(start);
    BenchmarkCase result;
    result.variant = scene.variant;
    result.phases = scene.air ? 2 : 1;
    result.threads = threads;
    result.particles = simulation.fluid().size();
    result.neighbours = mean_neighbours(simulation);
    result.bytes_per_particle = simulation.bytes_per_particle();
    result.arithmetic = arithmetic_limit(simulation, threads);
    const auto particles = static_cast<double>(result.particles);
    result.triad = triad_bandwidth(static_cast<std::size_t>(result.bytes_per_particle * particles), threads);
    result.memory_triad = triad_bandwidth(memory_probe_bytes, threads);
    const double listed = listed_neighbours(simulation);
    result.listed = listed / static_cast<double>(simulation.neighbours().clusters().size());

    const double work = particles * steps_per_repeat;
    std::vector<double> rates, core_rates, processor_shares, density_seconds, momentum_seconds, step_seconds;
    std::array<std::vector<double>, timed_stages.size()> stage_rates;
    double builds = 0;
    const InstructionCounter counter;
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        simulation.restore(start);
        const StageTimes before = simulation.stage_times();
        const std::uint64_t builds_before = simulation.list_builds();
        const double processor_before = processor_seconds();
        const std::optional<std::uint64_t> executed = counter.count();
        const auto begin = std::chrono::steady_clock::now();
        for (int step = 0; step < steps_per_repeat; ++step) {
            if (const auto instability = simulation.step(scene.end_time))
                throw InputError(fmt::format("the dam break becomes unstable: {}", instability->describe()));
        }
        const auto end = std::chrono::steady_clock::now();
        const double processor = processor_seconds() - processor_before;
        if (const auto now = counter.count(); threads == 1 && now && executed)
            result.instructions = static_cast<double>(*now - *executed) / work;
        const StageTimes after = simulation.stage_times();
        const double seconds = std::chrono::duration<double>(end - begin).count();
        // the machine's own pace changes with what else runs: the limit is sought beside every repeat
        const ArithmeticLimit beside = arithmetic_limit(simulation, threads);
        result.arithmetic.density = std::max(result.arithmetic.density, beside.density);
        result.arithmetic.momentum = std::max(result.arithmetic.momentum, beside.momentum);
        rates.push_back(work / seconds);
        core_rates.push_back(work / processor);
        processor_shares.push_back(processor / (seconds * threads));
        step_seconds.push_back(seconds / steps_per_repeat);
        density_seconds.push_back((after.density - before.density) / steps_per_repeat);
        momentum_seconds.push_back((after.momentum - before.momentum) / steps_per_repeat);
        for (std::size_t k = 0; k < timed_stages.size(); ++k) {
            const double spent = after.*timed_stages[k].second - before.*timed_stages[k].second;
            stage_rates[k].push_back(spent > 0 ? work / spent : 0);
        }
        builds = static_cast<double>(simulation.list_builds() - builds_before);
    }
    result.rate = measured(rates);
    result.core_rate = measured(core_rates);
    result.processor_share = median_of(processor_shares);
    for (std::size_t k = 0; k < timed_stages.size(); ++k)
        result.stages.emplace_back(timed_stages[k].first, measured(stage_rates[k]));
    // a list that outlives the repeat is reused at least that long
    result.steps_per_build = steps_per_repeat / std::max(1.0, builds);

    const double density = median_of(density_seconds), momentum = median_of(momentum_seconds);
    const double density_bytes = pass_bytes(simulation, 1), momentum_bytes = pass_bytes(simulation, 2);
    result.density = {listed / result.arithmetic.density / density, density_bytes / result.triad / density};
    result.momentum = {listed / result.arithmetic.momentum / momentum,
                       momentum_bytes / result.triad / momentum};
    result.step_share =
        (result.density.limit() * density + result.momentum.limit() * momentum) / median_of(step_seconds);
    return result;
}

}  // namespace

Benchmark run_benchmark(const BenchmarkOptions& options) {
    const int largest = options.threads > 0 ? options.threads : omp_get_max_threads();
    Benchmark benchmark;
    benchmark.particle_spacing = options.particle_spacing;
    benchmark.repeats = options.repeats;
    benchmark.steps = steps_per_repeat;
    for (const char* variant : {"single-phase", "two-phase"}) {
        Scene scene = read_scene(find_scene("dam_break"), variant);
        scene.execution.precision = benchmark.precision = options.precision;
        scene.execution.fewer_when_busy = false;
        scene.model.air_substeps = 1;  // every particle in every step: what the loops reach
        benchmark.instruction_set =
            pair_passes(scene.model, instruction_set_from_environment()).instruction_set;
        const Simulation::State start = state_in_mid_run(scene, options, largest);
        for (const int threads : thread_counts(largest))
            benchmark.cases.push_back(measure(scene, start, options, threads));
    }
    return benchmark;
}

}  // namespace wetdeck
