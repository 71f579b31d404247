// SPDX-License-Identifier: BSD-3-Clause
#include "solver/core/team.hpp"

#include <algorithm>

#include "solver/core/processor_seconds.hpp"

namespace wetdeck {

void Team::adapt() {
    constexpr double least_work = 0.05, longest_patience = 64;  // [s]
    constexpr double own_processor = 0.95;                      // what a thread gets of one, at least
    if (!adapts_ || wall_ < least_work) return;
    const double used = processors_ / wall_;
    if (size_ > 1 && used < own_processor * (size_ - 1)) {
        --size_;
        patience_ = on_trial_ ? std::min(2 * patience_, longest_patience) : 1;
        pause_left_ = patience_;
        on_trial_ = false;
    } else {
        on_trial_ = false;
        pause_left_ -= wall_;
        if (size_ < most_ && pause_left_ <= 0) {
            ++size_;
            on_trial_ = true;
        }
    }
    wall_ = processors_ = 0;
}

Team::Work::Work(Team& team) : team_(team) {
    if (!team_.adapts_) return;
    start_ = std::chrono::steady_clock::now();
    processors_ = processor_seconds();
}

Team::Work::~Work() {
    if (!team_.adapts_) return;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
    team_.add(wall.count(), processor_seconds() - processors_);
}

}  // namespace wetdeck
