// SPDX-License-Identifier: BSD-3-Clause
// How thick a skin the neighbour list should have.
//
// A thick skin makes each sum over pairs dearer, a thin one is soon used up. Let a sum cost C without a skin
// and C (1 + a s) with one of s smoothing lengths, and a list b C; a list that serves k s steps then costs
// b C / (k s) a step. Both together are least at
//
//     s = sqrt(b / (a k)).
//
// k follows from the steps that the last few lists have served: it is counted, not timed, so that results
// depend neither on the machine nor on what else it does.
#pragma once

#include <algorithm>
#include <cmath>

namespace wetdeck {

/// The skin of the list in use, and what the next one should be, in smoothing lengths.
struct SkinChoice {
    static constexpr double least = 0.1, largest = 1, first = 0.3;
    /// b / a, measured (docs/decisions.md).
    static constexpr double cost_ratio = 10;
    /// Weight of a list in the choice over that of the one after it.
    static constexpr double memory = 0.5;

    double skin = first;
    double served = 0;          ///< steps that the list in use has served
    double steps = 0, sum = 0;  ///< steps that the lists before it have served, and their skins, weighted

    /// Whether this can be a choice: one from a file may not be.
    bool is_sound() const {
        const auto is_count = [](double value) { return value >= 0 && std::isfinite(value); };
        return skin >= least && skin <= largest && is_count(served) && is_count(steps) && is_count(sum);
    }

    /// Chooses the skin of the next list; the one in use ends here.
    void end_of_list() {
        steps = memory * steps + served;
        sum = memory * sum + skin;
        served = 0;
        if (steps > 0) skin = std::clamp(std::sqrt(cost_ratio * sum / steps), least, largest);
    }
};

}  // namespace wetdeck
