// SPDX-License-Identifier: BSD-3-Clause
// [scales] and [time_origins] of a scene, and the units of the series that quantities and comparisons are
// taken from. A scale or an origin is a number in SI units, or a text with its unit: "0.6 m", "10.2 ms".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/metrics/specification.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

class Axes {
  public:
    Axes(const TomlTable& root, const Scene& scene);

    /// Names of all series that a run of the scene holds.
    std::vector<std::string> series_names() const;

    /// Reads `x_scale`, `x_origin` and `y_scale` of an entry, and returns the units of its axes.
    SeriesUnits read(const TomlTable& table, const std::string& series, SeriesScaling& scaling) const;

  private:
    struct Value {
        double number = 1;  ///< [SI]
        std::string unit;   ///< empty for a plain number
    };
    using Values = std::map<std::string, Value>;
    struct SeriesAxes {
        std::string name, unit, abscissa_unit;
    };

    void add_series(const SeriesInfo& info, const std::string& name);
    static Value read_value(const TomlTable& table, const std::string& key);
    static const Value* chosen(const TomlTable& table, const std::string& key, const Values& values);
    static double read_scale(const TomlTable& table, const std::string& key, const Values& values,
                             AxisUnits& axis);

    Values scales_, origins_;
    std::vector<SeriesAxes> series_;
};

}  // namespace wetdeck
