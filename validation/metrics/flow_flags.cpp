// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/flow_flags.hpp"

#include <fmt/format.h>

#include <cmath>

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
    const double coarsest = largest_value(record, "coarsest_at_bodies").value_or(1);
    if (coarsest > largest_spacing_at_bodies)
        flags.push_back(fmt::format(
            "particles with {:.2g} times the finest spacing have touched a body: its loads are those of that "
            "spacing; widen the box of [resolution], or let spacings grow more slowly",
            coarsest));
    return flags;
}

std::optional<std::string> compression_note(const RunRecord& record) {
    const double change = largest_value(record, "density_error_max").value_or(0);
    const auto speed = record.parameters.find("water.sound_speed");
    if (change <= largest_intended_compression || speed == record.parameters.end()) return std::nullopt;
    const double times = change / largest_intended_compression;
    return fmt::format(
        "the water's density changes by up to {:.2g} %, so that peaks depend on its sound speed, {:.4g} m/s: "
        "with {:.3g} m/s the same pressures change it by {:.2g} %, with {:.3g} m/s those of a flat impact; "
        "run "
        "again with twice the sound speed to see what the peaks gain",
        100 * change, speed->second, speed->second * std::sqrt(times), 100 * largest_intended_compression,
        speed->second * times);
}

}  // namespace wetdeck
