// SPDX-License-Identifier: BSD-3-Clause
// A small scene with everything in it, and ways to spoil it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/core/errors.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck::samples {

/// A column of water in a closed tank: about 1,250 particles at 0.02 m, 50 of water at 0.04 m.
inline const std::string small_scene = R"toml(schema = 1
name = "small"
title = "A small column"
purpose = "to test"
source = "none"
gravity = [0.0, -9.81]
default_variant = "two-phase"
error_quantity = "front_mean"
limits = ["two-dimensional"]

[scales]
length = 0.2
time = 0.1428

[tank]
size = [1.0, 0.48]

[water]
density = 1000.0
sound_speed = 14.0
exponent = 7.0
boxes = [[0.0, 0.0, 0.4, 0.2]]

[air]
density = 1.0
exponent = 1.4
law = "sound-speed"
sound_speed = 70.0
boxes = [[0.4, 0.0, 1.0, 0.2], [0.0, 0.2, 1.0, 0.48]]

[initial]
pressure = "hydrostatic"
surface = 0.2

[model]
air = true
background_pressure = 500.0

[run]
end_time = 0.2
sample_interval = 0.002
frames = [0.05, 0.1]

[tiers]
quick = { single-phase = [0.02, 0.04] }
standard = { two-phase = [0.02] }

[variants.two-phase]
description = "with air"

[variants.single-phase]
description = "water alone"
model.air = false
model.background_pressure = 0.0

[[probes]]
name = "front"
type = "front"

[[probes]]
name = "gauge"
type = "wall_pressure"
centre = [1.0, 0.1]
diameter = 0.08

[[probes]]
name = "depth"
type = "water_depth"
x = 0.3
width = 0.08

[[quantities]]
name = "front_mean"
metric = "mean"
series = "front"
x_scale = "time"
y_scale = "length"
window = [0.2, 0.8]

[[compare]]
title = "front"
quantity = "front"
reference = "nobody_front"
x_column = "T"
y_column = "x"
x_scale = "time"
y_scale = "length"
window = [0.0, 1.0]
tolerance = 0.1

[[deviations]]
item = "size"
source = "large"
used = "small"
reason = "tests are quick"
)toml";

/// A text with one piece of it replaced. The piece must be there.
inline std::string replaced(std::string text, const std::string& piece, const std::string& replacement) {
    const std::size_t at = text.find(piece);
    if (at == std::string::npos) throw std::logic_error("not in the text: " + piece);
    return text.replace(at, piece.size(), replacement);
}

/// The small scene with one piece of it replaced.
inline std::string with(const std::string& piece, const std::string& replacement) {
    return replaced(small_scene, piece, replacement);
}

inline std::string without(const std::string& piece) {
    return with(piece, "");
}

/// The small scene with a line more in front of a section's first key.
inline std::string with_line(const std::string& section, const std::string& line) {
    return with(section + "\n", section + "\n" + line + "\n");
}

/// What the reader says against a text; empty if it takes it.
inline std::string refusal(const std::string& text, const std::optional<std::string>& variant = std::nullopt,
                           const std::vector<std::string>& overrides = {}) {
    try {
        parse_scene(text, "small.toml", variant, overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace wetdeck::samples
