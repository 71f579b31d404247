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
    Series series{gauge.unit, gauge.description, {}, {}, {}};
    for (std::size_t row = 0; row < record.time.size(); ++row) {
        std::vector<double> probes;
        for (const RecordColumn& column : record.columns) probes.push_back(column.values[row]);
        const double value = gauge_value(gauge, probes);
        if (std::isnan(value)) continue;
        series.time.push_back(record.time[row]);
        series.value.push_back(gauge.kind == FoamGauge::Kind::pressure ? value - atmosphere : value);
    }
    return series;
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
    const auto found = std::find_if(record.columns.begin(), record.columns.end(),
                                    [](const RecordColumn& c) { return c.name == "force_y"; });
    if (found == record.columns.end())
        throw DataError(fmt::format("{}: holds no force", (folder / "postProcessing/body").string()));
    Series force{"N/m", "force of the fluid, up", record.time, found->values, {}};
    for (double& value : force.value) value *= written.force_factor / foam_layer;
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

double gauge_value(const FoamGauge& gauge, const std::vector<double>& probes) {
    if (probes.size() != gauge.weights.size())
        throw DataError(
            fmt::format("{} has {} probes, expected {}", gauge.object, probes.size(), gauge.weights.size()));
    if (std::any_of(probes.begin(), probes.end(), [](double v) { return std::isnan(v); }))
        return std::nan("");
    if (gauge.kind == FoamGauge::Kind::front) return front_in(gauge, probes);
    double sum = 0;
    for (std::size_t k = 0; k < probes.size(); ++k) sum += gauge.weights[k] * probes[k];
    return sum;
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
