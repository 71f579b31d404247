// SPDX-License-Identifier: BSD-3-Clause
// A run between its steps: what was asked for, where it stands, when it is stored next.
#pragma once

#include <chrono>
#include <filesystem>

#include "solver/simulation.hpp"
#include "validation/run/run.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/fields.hpp"

namespace wetdeck {

/// What was asked for, into a checkpoint and back: the scene as it was read then, variant, overrides, spacing
/// and end.
void save_request(Checkpoint& checkpoint, const Scene& scene, const RunOptions& options);
Scene scene_in(const Checkpoint& checkpoint);
RunOptions options_in(const Checkpoint& checkpoint);

void save_simulation(Checkpoint& checkpoint, const Simulation& simulation);
void restore_simulation(const Checkpoint& checkpoint, Simulation& simulation);

/// Fields kept for the case that the run becomes unstable.
void save_frame(Checkpoint& checkpoint, const FieldFrame& frame);
FieldFrame frame_in(const Checkpoint& checkpoint);

/// When the next checkpoint is due: at once, then each `interval` wall seconds, further apart where that
/// would cost more than a hundredth of the time. An interval of 0 asks for one at every chance.
class CheckpointClock {
  public:
    explicit CheckpointClock(double interval) : interval_(interval), next_(Clock::now()) {}

    bool due() const { return Clock::now() >= next_; }
    /// A checkpoint has been written (or read), which took so long [s].
    void restart(double cost);

  private:
    using Clock = std::chrono::steady_clock;
    double interval_;
    Clock::time_point next_;
};

}  // namespace wetdeck
