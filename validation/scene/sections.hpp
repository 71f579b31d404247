// SPDX-License-Identifier: BSD-3-Clause
// The sections of a scene file, each read by one function.
#pragma once

#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// Two numbers under one key.
inline Vec2 point(const TomlTable& table, const std::string& key) {
    const std::vector<double> values = table.numbers(key, 2);
    return {values[0], values[1]};
}

/// [water], [air], [model], [execution], gravity -> Model, Execution.
void read_model(const TomlTable& root, Scene& scene);
/// The keys `law` and `sound_speed` of [air] -> the air's sound speed.
void read_air_law(const TomlTable& air, Model& model);
/// [[quantities]], [[compare]], [[deviations]], limits; what the file says of its sources.
void read_analysis(const TomlTable& root, Scene& scene);
/// [[source_statements]] and [[side_by_side]]; `series` and `quantities` are the names they may use.
void read_statements(const TomlTable& root, const std::vector<std::string>& series,
                     const std::vector<std::string>& quantities, Scene& scene);
/// [[source_figures]], [[unused_references]]
void read_sources(const TomlTable& root, AnalysisSpec& analysis);
/// tank.size, or tank.outline and the box around it. Returns the outline, or none.
Outline read_tank(const TomlTable& tank, Scene& scene);
/// tank.motion and tank.roll_centre; it finishes the table.
void read_tank_motion(const TomlTable& tank, Scene& scene);
/// [body], [body_2], ..., and [[solids]] behind them
void read_bodies(const TomlTable& root, Scene& scene);
/// tank.outline -> solids between it and the box around it; none for an empty outline.
void add_tank_walls(const TomlTable& tank, const Outline& outline, Scene& scene);
/// [[probes]]
void read_probes(const TomlTable& root, Scene& scene);

}  // namespace wetdeck
