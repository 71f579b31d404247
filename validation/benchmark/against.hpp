// SPDX-License-Identifier: BSD-3-Clause
// The speed of this program over that of another build of it, as ratios of runs in turn: a machine that is
// busy or slows down disturbs both.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "validation/benchmark/spread.hpp"

namespace wetdeck {

struct AgainstOptions {
    std::filesystem::path program;   ///< the other build
    double particle_spacing = 0.02;  ///< of the dam break [m]
    int repeats = 7;                 ///< pairs of runs
    int threads = 0;                 ///< 0: all
};

/// One variant of the dam break, run in pairs.
struct PairedRuns {
    std::string variant;
    Measured ratio;       ///< particle-steps per second of the runs, ours over theirs
    Measured wall_ratio;  ///< wall time of the runs, theirs over ours: another count of steps does not enter
    double ours = 0, theirs = 0;  ///< medians [particle-steps/s]
};

struct Comparison {
    AgainstOptions options;
    std::string version;  ///< of the other build, as it says itself
    std::vector<PairedRuns> variants;
};

/// Runs the scene dam_break of each program, with its own data, as whole runs with probes and files over the
/// first half second; the one that begins changes from pair to pair. Throws InputError where the other
/// program cannot be run or writes no run that can be read.
Comparison compare_builds(const AgainstOptions& options);

std::string comparison_table(const Comparison& comparison);
/// {"ratio": {"two-phase": r, "single-phase": r}, ...}
nlohmann::json comparison_json(const Comparison& comparison);

}  // namespace wetdeck
