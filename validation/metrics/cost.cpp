// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/cost.hpp"

#include <algorithm>

namespace wetdeck {

std::optional<double> particle_rate(const RunCost& cost) {
    return cost.wall_s > 0 ? std::optional(cost.particle_steps / cost.wall_s) : std::nullopt;
}

std::map<std::string, double> stage_shares(const RunCost& cost) {
    double total = 0;
    for (const auto& stage : cost.stage_seconds) total += stage.second;
    std::map<std::string, double> shares;
    if (total <= 0) return shares;
    for (const auto& [name, seconds] : cost.stage_seconds) shares[name] = seconds / total;
    return shares;
}

std::vector<std::pair<std::string, double>> limiting_shares(const RunCost& cost) {
    double total = 0;
    for (const auto& entry : cost.limiting_criterion) total += static_cast<double>(entry.second);
    std::vector<std::pair<std::string, double>> shares;
    for (const auto& [name, steps] : cost.limiting_criterion) {
        if (steps > 0) shares.emplace_back(name, static_cast<double>(steps) / total);
    }
    std::stable_sort(shares.begin(), shares.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    return shares;
}

double particle_steps(const SourceRun& run) {
    return run.particles * run.steps;
}

}  // namespace wetdeck
