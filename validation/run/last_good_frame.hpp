// SPDX-License-Identifier: BSD-3-Clause
// The newest sound state of a simulation, for the case that it becomes unstable in one of the next steps.
#pragma once

#include <cstdint>

#include "solver/simulation.hpp"
#include "validation/store/fields.hpp"

namespace wetdeck {

/// The interval of `steps` steps between two inspections of a simulation, shortened where the air takes
/// several steps in one of the water, as such steps are longer; at least `least`.
std::uint64_t inspection_interval(const Simulation& simulation, std::uint64_t steps, std::uint64_t least = 1);

class LastGoodFrame {
  public:
    /// @param steps_between  number of steps between two frames; at the start after 1, 2, 4, 8, ... steps
    explicit LastGoodFrame(std::uint64_t steps_between) : steps_between_(steps_between) {}

    /// Whether a frame is due at this number of steps.
    bool due(std::uint64_t steps) const;
    /// Keeps the present state if a frame is due; says whether it did.
    bool update(const Simulation& simulation, const std::string& provenance);

    void set(FieldFrame frame) { frame_ = std::move(frame); }
    const FieldFrame& frame() const { return frame_; }

  private:
    std::uint64_t steps_between_;
    FieldFrame frame_;
};

}  // namespace wetdeck
