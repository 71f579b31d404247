// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/flow_flags.hpp"

#include <fmt/format.h>

#include "validation/metrics/energy_budget.hpp"

namespace wetdeck {

std::vector<std::string> flow_flags(const RunRecord& record) {
    std::vector<std::string> flags;
    const double density_error = largest_value(record, "density_error_max").value_or(0);
    if (density_error > largest_sound_density_error)
        flags.push_back(
            fmt::format("the water's density is off by up to {:.2g} %, more than {:.2g} %: the sound "
                        "speed is too low for the speeds, or the spacing too coarse for the impacts",
                        100 * density_error, 100 * largest_sound_density_error));
    const double outside = largest_value(record, "particles_outside").value_or(0);
    if (outside > 0)
        flags.push_back(fmt::format("{:.0f} fluid particles are beyond the tank's faces", outside));
    return flags;
}

}  // namespace wetdeck
