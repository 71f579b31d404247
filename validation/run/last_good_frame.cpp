// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/last_good_frame.hpp"

#include <algorithm>
#include <bit>

#include "validation/run/field_frame.hpp"

namespace wetdeck {

std::uint64_t inspection_interval(const Simulation& simulation, std::uint64_t steps, std::uint64_t least) {
    const auto substeps = static_cast<std::uint64_t>(simulation.substeps());
    return std::max(least, steps / std::bit_ceil(substeps));
}

bool LastGoodFrame::due(std::uint64_t steps) const {
    return steps % steps_between_ == 0 || (steps < steps_between_ && std::has_single_bit(steps));
}

bool LastGoodFrame::update(const Simulation& simulation, const std::string& provenance) {
    if (!due(simulation.steps())) return false;
    frame_ = frame_of(simulation, provenance);
    return true;
}

}  // namespace wetdeck
