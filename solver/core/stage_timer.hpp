// SPDX-License-Identifier: BSD-3-Clause
// Wall seconds of the stages of a run.
#pragma once

#include <chrono>

namespace wetdeck {

/// Where the time of a run went [wall seconds].
struct StageTimes {
    double neighbours = 0;   ///< lists checked and built
    double density = 0;      ///< pass over the pairs for the density rates
    double momentum = 0;     ///< pass over the pairs for the accelerations
    double walls = 0;        ///< means at the walls
    double bodies = 0;       ///< loads on bodies
    double integration = 0;  ///< kicks, drifts, densities, positions of the bodies' particles
    double probes = 0;       ///< observer and stability monitor
};

/// Calls visit(name, seconds) for each stage.
template <class Times, class Visit>
void for_each_stage(Times& t, const Visit& visit) {
    visit("neighbours", t.neighbours);
    visit("density", t.density);
    visit("momentum", t.momentum);
    visit("walls", t.walls);
    visit("bodies", t.bodies);
    visit("integration", t.integration);
    visit("probes", t.probes);
}

/// Adds the wall seconds of a scope to a total.
class StageTimer {
  public:
    /// Starts now; `total` outlives it.
    explicit StageTimer(double& total) : total_(total), start_(std::chrono::steady_clock::now()) {}
    ~StageTimer() {
        total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    double& total_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace wetdeck
