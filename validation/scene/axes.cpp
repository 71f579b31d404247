// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/axes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"
#include "validation/scene/series.hpp"
#include "validation/scene/time_origins.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {

MeasuredValue read_measured_value(const TomlTable& table, const std::string& key) {
    if (!table.holds_text(key)) return {table.number(key), {}};
    const std::string text = table.text(key);
    const std::size_t gap = text.find(' ');
    const std::optional<double> number = number_in(std::string_view(text).substr(0, gap));
    if (!number || gap == std::string::npos)
        table.fail(key,
                   fmt::format("is '{}', expected a number, or a number and a unit as in \"0.6 m\"", text));
    try {
        const Unit unit = unit_named(std::string(trimmed(std::string_view(text).substr(gap))));
        return {*number * unit.factor, si_name(unit.powers)};
    } catch (const InputError& error) {
        table.fail(key, error.what());
    }
}

Axes::Axes(const TomlTable& root, const Scene& scene) {
    if (const std::optional<TomlTable> table = root.optional_table("scales")) {
        for (const std::string& name : table->keys()) {
            scales_[name] = read_measured_value(*table, name);
            if (!(scales_[name].number > 0))
                table->fail(name, fmt::format("is {}, expected a positive number", scales_[name].number));
        }
    }
    for (const Probe& probe : scene.probes) add_series(probe.series, probe.series.name);
    for (const FluidSeries& each : every_run_series()) add_series(each.info, each.info.name);
    for (const FieldSeries& each : all_field_series()) add_series(each.info, each.info.name);
    for (const AnalysedSeries& each : analysed_series()) add_series(each.info, each.info.name);
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        for (const BodySeries& each : recorded_body_series())
            add_series(each.info, body_series_name(each.info.name, body));
        for (const DerivedSeries& each : derived_body_series())
            add_series(each.info, body_series_name(each.info.name, body));
    }
    origins_ = read_time_origins(root, scene, series_names());
}

void Axes::add_series(const SeriesInfo& info, const std::string& name) {
    series_.push_back({name, info.unit, info.abscissa.empty() ? "s" : "m"});
}

std::vector<std::string> Axes::series_names() const {
    std::vector<std::string> names;
    for (const SeriesAxes& each : series_) names.push_back(each.name);
    return names;
}

double Axes::read_scale(const TomlTable& table, const std::string& key, AxisUnits& axis) const {
    if (!table.has(key)) return 1;
    std::vector<std::string> names;
    for (const auto& [name, value] : scales_) names.push_back(name);
    axis.scale = table.choice(key, names);
    const MeasuredValue& scale = scales_.at(axis.scale);
    axis.scale_unit = scale.unit;
    return scale.number;
}

SeriesUnits Axes::read(const TomlTable& table, const std::string& series, SeriesScaling& scaling) const {
    const auto axes = std::find_if(series_.begin(), series_.end(),
                                   [&](const SeriesAxes& each) { return each.name == series; });
    SeriesUnits units;
    units.place = table.place_of(table.has("references") ? "references" : "reference");
    units.x.series = axes->abscissa_unit;
    units.y.series = axes->unit;
    scaling.x_scale = read_scale(table, "x_scale", units.x);
    scaling.y_scale = read_scale(table, "y_scale", units.y);
    read_x_origin(table, origins_, scaling);
    if (scaling.origin.empty()) return units;
    const std::string& unit = origins_.at(scaling.origin).unit;
    if (!unit.empty() && !same_dimension(unit_named(unit), unit_named(units.x.series)))
        table.fail("x_origin", fmt::format("is in {}, but the abscissa of series '{}' in {}", unit, series,
                                           units.x.series));
    return units;
}

}  // namespace wetdeck
