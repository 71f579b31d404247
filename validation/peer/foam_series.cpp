// SPDX-License-Identifier: BSD-3-Clause
#include "validation/peer/foam_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"
#include "validation/import/formats.hpp"
#include "validation/run/recorders.hpp"
#include "validation/scene/faces.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

CodeRecord record_of(const fs::path& folder, const std::string& object) {
    return read_openfoam({(folder / "postProcessing" / object).string()});
}

Series gauge_series(const FoamGauge& gauge, const CodeRecord& record, double atmosphere) {
    Series series{gauge.unit, gauge.description, {}, {}, gauge.abscissa};
    const double datum = gauge.unit == "Pa" ? atmosphere : 0;
    for (std::size_t row = 0; row < record.time.size(); ++row) {
        std::vector<double> probes;
        for (const RecordColumn& column : record.columns) probes.push_back(column.values[row]);
        const std::vector<double> values = gauge_values(gauge, probes, record.time[row]);
        if (std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) continue;
        series.time.push_back(record.time[row]);
        for (const double value : values) series.value.push_back(value - datum);
    }
    return series;
}

/// Along each ray, the place at which the share of water first rises to a half; NaN where it does not.
std::vector<double> first_water(const FoamGauge& gauge, const std::vector<double>& shares) {
    std::vector<double> found;
    std::size_t begin = 0;
    for (const std::size_t count : gauge.rays) {
        double place = std::nan("");
        for (std::size_t k = begin; k < begin + count && std::isnan(place); ++k) {
            if (shares[k] < 0.5) continue;
            place = gauge.places[k];
            if (k == begin) continue;
            const double part = (0.5 - shares[k - 1]) / (shares[k] - shares[k - 1]);
            place = gauge.places[k - 1] + part * (gauge.places[k] - gauge.places[k - 1]);
        }
        found.push_back(place);
        begin += count;
    }
    return found;
}

/// Where the share of water falls through a half for the last time along the row.
double front_in(const FoamGauge& gauge, const std::vector<double>& shares) {
    for (std::size_t k = shares.size(); k-- > 0;) {
        if (shares[k] < 0.5) continue;
        if (k + 1 == shares.size()) return gauge.places[k] + 0.5 * (gauge.places[k] - gauge.places[k - 1]);
        const double share = (shares[k] - 0.5) / (shares[k] - shares[k + 1]);
        return gauge.places[k] + share * (gauge.places[k + 1] - gauge.places[k]);
    }
    return gauge.places.front();
}

void add_body(const Scene& scene, const SceneCase& written, const fs::path& folder,
              std::map<std::string, Series>& all) {
    const CodeRecord record = record_of(folder, "body");
    const auto load = [&](const char* column, const char* unit, const char* description) {
        const auto found = std::find_if(record.columns.begin(), record.columns.end(),
                                        [&](const RecordColumn& c) { return c.name == column; });
        if (found == record.columns.end())
            throw DataError(
                fmt::format("{}: holds no {}", (folder / "postProcessing/body").string(), column));
        Series series{unit, description, record.time, found->values, {}};
        for (double& value : series.value) value *= written.force_factor / foam_layer;
        return series;
    };
    Series force = load("force_y", "N/m", "force of the fluid, up");
    if (written.force_factor == 1) {  // of half a body they are no loads of the whole
        all["body_force_x"] = load("force_x", "N/m", "force of the fluid, to the right");
        all["body_torque"] =
            load("moment_z", "N", "moment of the fluid about the mass centre, anticlockwise");
    }
    const std::vector<double>& t = force.time;
    Series impulse{"N s/m", "impulse of the fluid, up", t, {0}, {}};
    for (std::size_t k = 1; k < t.size(); ++k)
        impulse.value.push_back(impulse.value.back() +
                                0.5 * (force.value[k] + force.value[k - 1]) * (t[k] - t[k - 1]));
    const BodySpec& body = scene.bodies.front();
    const double surface = scene.water_boxes.front().high.y();
    const double lowest = extent_of(body.outline).low.y();
    Series velocity{"m/s", "of the mass centre, up", t, {}, {}}, place{"m", "of the mass centre", t, {}, {}},
        clearance{"m", "from the level of the water at the start to the body", t, {}, {}};
    for (const double time : t) {
        velocity.value.push_back(body.body.velocity.y());
        place.value.push_back(body.body.position.y() + time * body.body.velocity.y());
        clearance.value.push_back(lowest - surface + time * body.body.velocity.y());
    }
    Series filtered{"N/m",
                    "force of the fluid, up, moving mean",
                    t,
                    mean_slopes({t, impulse.value}, scene.force_filter),
                    {}};
    all["body_force_y"] = std::move(force);
    all["body_force_y_filtered"] = std::move(filtered);
    all["body_impulse_y"] = std::move(impulse);
    all["body_velocity_y"] = std::move(velocity);
    all["body_y"] = std::move(place);
    all["body_clearance"] = std::move(clearance);
}

}  // namespace

std::vector<double> gauge_values(const FoamGauge& gauge, const std::vector<double>& probes, double time) {
    const std::size_t expected = gauge.rays.empty() ? gauge.weights.size() : gauge.places.size();
    if (probes.size() != expected)
        throw DataError(fmt::format("{} has {} probes, expected {}", gauge.object, probes.size(), expected));
    if (std::any_of(probes.begin(), probes.end(), [](double v) { return std::isnan(v); }))
        return std::vector<double>(gauge.columns(), std::nan(""));
    switch (gauge.kind) {
        case FoamGauge::Kind::front:
            return {front_in(gauge, probes)};
        case FoamGauge::Kind::profile:
            return probes;
        case FoamGauge::Kind::film: {
            double least = std::nan("");
            for (const double distance : first_water(gauge, probes)) least = std::fmin(least, distance);
            return {least};
        }
        case FoamGauge::Kind::surface: {
            std::vector<double> heights = first_water(gauge, probes);
            for (double& height : heights) height -= gauge.rise * time;
            return heights;
        }
        case FoamGauge::Kind::depth:
        case FoamGauge::Kind::pressure:
            break;
    }
    double sum = 0;
    for (std::size_t k = 0; k < probes.size(); ++k) sum += gauge.weights[k] * probes[k];
    return {sum};
}

RunRecord foam_record(const Scene& scene, const SceneCase& written, const fs::path& folder) {
    RunRecord record;
    record.scene = scene.name();
    record.variant = scene.variant;
    record.particle_spacing = written.cell;
    if (written.foam.has_body) add_body(scene, written, folder, record.series);
    for (const FoamGauge& gauge : written.gauges)
        record.series[gauge.series] =
            gauge_series(gauge, record_of(folder, gauge.object), written.foam.air_pressure);
    return record;
}

}  // namespace wetdeck
