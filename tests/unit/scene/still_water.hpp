// SPDX-License-Identifier: BSD-3-Clause
// A basin of still water with one fixed body.
#pragma once

#include <fmt/format.h>

#include <string>

namespace wetdeck::samples {

/// All as in a scene file: lists of numbers in brackets, [m] and [m/s].
struct StillWater {
    std::string tank, water, surface, sound_speed, body_position, body_outline;
};

/// Water alone under 9.81 m/s^2 with the body, then `more`.
inline std::string still_water(const StillWater& still, const std::string& more = "") {
    return fmt::format(R"toml(schema = 1
name = "still"
title = "Still water"
purpose = "to test"
source = "none"
gravity = [0.0, -9.81]
default_variant = "water"
[tank]
size = {}
[water]
density = 1000.0
sound_speed = {}
exponent = 7.0
boxes = [{}]
[initial]
pressure = "hydrostatic"
surface = {}
[model]
air = false
[run]
end_time = 0.05
sample_interval = 0.01
[variants.water]
[body]
position = {}
outline = {}
free = []
{}
)toml",
                       still.tank, still.sound_speed, still.water, still.surface, still.body_position,
                       still.body_outline, more);
}

}  // namespace wetdeck::samples
