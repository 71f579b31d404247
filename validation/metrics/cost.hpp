// SPDX-License-Identifier: BSD-3-Clause
// What a run cost, in numbers that compare between runs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "validation/metrics/specification.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// Particle-steps per wall second; empty if no time was taken.
std::optional<double> particle_rate(const RunCost& cost);

/// Wall time of each stage over that of all stages; empty if no stage took any.
std::map<std::string, double> stage_shares(const RunCost& cost);

/// Share of the steps whose size each criterion set, the most frequent first; criteria that set none are left
/// out.
std::vector<std::pair<std::string, double>> limiting_shares(const RunCost& cost);

/// Particles times steps of the computation in the scene's source.
double particle_steps(const SourceRun& run);

}  // namespace wetdeck
