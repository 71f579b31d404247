// SPDX-License-Identifier: BSD-3-Clause
// The sections of a scene file, each read by one function.
#pragma once

#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// Scales by name ("time", "length", "pressure"), as quantities and comparisons refer to them.
using Scales = std::map<std::string, double>;

/// [water], [air], [model], [execution], gravity -> Model, Execution.
void read_model(const TomlTable& root, Scene& scene);
/// The keys `law` and `sound_speed` of [air] -> the air's sound speed.
void read_air_law(const TomlTable& air, Model& model);
/// [[quantities]], [[compare]], [[deviations]], [[source_figures]], limits.
void read_analysis(const TomlTable& root, Scene& scene);
/// [body], [body_2], ...
void read_bodies(const TomlTable& root, Scene& scene);
/// [[probes]]
void read_probes(const TomlTable& root, Scene& scene);

}  // namespace wetdeck
