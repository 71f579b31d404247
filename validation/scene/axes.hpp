// SPDX-License-Identifier: BSD-3-Clause
// [scales] and [time_origins] of a scene, and the units of the series that quantities and comparisons are
// taken from. A scale or an origin is a number in SI units, or a text with its unit: "0.6 m", "10.2 ms"; an
// origin may be an event that each run finds, too (time_origins.hpp).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/metrics/specification.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// A number [SI] and the unit with which it was written, empty for a plain number.
struct MeasuredValue {
    double number = 1;
    std::string unit;
};
/// A number, or a text of a number and its unit. Throws InputError for anything else.
MeasuredValue read_measured_value(const TomlTable& table, const std::string& key);

class Axes {
  public:
    Axes(const TomlTable& root, const Scene& scene);

    /// Names of all series that a run of the scene holds.
    std::vector<std::string> series_names() const;

    const std::map<std::string, TimeOrigin>& origins() const { return origins_; }

    /// Reads `x_scale`, `x_origin` and `y_scale` of an entry, and returns the units of its axes.
    SeriesUnits read(const TomlTable& table, const std::string& series, SeriesScaling& scaling) const;

  private:
    using Scales = std::map<std::string, MeasuredValue>;
    struct SeriesAxes {
        std::string name, unit, abscissa_unit;
    };

    void add_series(const SeriesInfo& info, const std::string& name);
    double read_scale(const TomlTable& table, const std::string& key, AxisUnits& axis) const;

    Scales scales_;
    std::map<std::string, TimeOrigin> origins_;
    std::vector<SeriesAxes> series_;
};

}  // namespace wetdeck
