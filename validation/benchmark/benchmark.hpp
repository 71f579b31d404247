// SPDX-License-Identifier: BSD-3-Clause
// How fast the solver is on this machine, and how near to what the machine could do: the dam break, with one
// phase and with two, from a state in the middle of its run.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/core/execution.hpp"
#include "validation/benchmark/machine_limit.hpp"
#include "validation/benchmark/spread.hpp"

namespace wetdeck {

struct BenchmarkOptions {
    int threads = 0;                 ///< largest number of threads, 0: all
    double particle_spacing = 0.02;  ///< [m]
    int repeats = 7;
    Precision precision = Precision::double_precision;
};

/// A pass against what the machine could do.
struct PassShare {
    double arithmetic = 0;  ///< time at the arithmetic limit over time taken
    double traffic = 0;     ///< time to move what must be moved, at the triad's bandwidth, over time taken
    double limit() const { return std::max(arithmetic, traffic); }
};

struct BenchmarkCase {
    std::string variant;
    int phases = 1;
    int threads = 1;
    std::size_t particles = 0;   ///< of fluid
    Measured rate;               ///< particle-steps/s of whole steps, wall time
    Measured core_rate;          ///< particle-steps per processor second: what a busy machine leaves alone
    double processor_share = 0;  ///< processor time over wall time and threads; below 1: others were at work
    std::vector<std::pair<std::string, Measured>> stages;  ///< particle-steps/s; 0 where there is no work
    double neighbours = 0;          ///< within the kernel's support, of a fluid particle: fluid and walls
    double listed = 0;              ///< neighbours in the list of its cluster
    double steps_per_build = 0;     ///< of the neighbour list
    double bytes_per_particle = 0;  ///< particles and lists
    ArithmeticLimit arithmetic;
    double triad = 0;         ///< [B/s] over as much memory as the simulation has
    double memory_triad = 0;  ///< [B/s] over more than caches hold
    PassShare density, momentum;
    std::optional<double> instructions;  ///< of a particle-step; one thread, where the machine counts them
    double step_share = 0;               ///< both passes at their limits over the whole step
};

struct Benchmark {
    double particle_spacing = 0;
    int repeats = 0, steps = 0;  ///< of each repeat
    std::string instruction_set;
    Precision precision = Precision::double_precision;
    std::vector<BenchmarkCase> cases;
};

/// Throws InputError for a spacing that does not fit the scene, or at which it becomes unstable.
Benchmark run_benchmark(const BenchmarkOptions& options);

std::string benchmark_table(const Benchmark& benchmark);
nlohmann::json benchmark_json(const Benchmark& benchmark);

}  // namespace wetdeck
