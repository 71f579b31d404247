// SPDX-License-Identifier: BSD-3-Clause
// Wall seconds of a scope, added to a total.
#pragma once

#include <chrono>

namespace wetdeck {

/// Adds the wall seconds from its making to its end to a total.
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
