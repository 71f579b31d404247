// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/energy_budget.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wetdeck {
namespace {

const Series* scalar_series(const RunRecord& record, const std::string& name) {
    const auto found = record.series.find(name);
    if (found == record.series.end()) return nullptr;
    const Series& series = found->second;
    const bool usable =
        series.columns() == 1 && !series.time.empty() && series.time.size() == series.value.size();
    return usable ? &series : nullptr;
}

Curve change(const Series& series, double scale) {
    Curve curve{series.time, series.value};
    for (double& value : curve.y) value = (value - series.value.front()) / scale;
    return curve;
}

}  // namespace

std::optional<EnergyChanges> energy_changes(const RunRecord& record) {
    const Series* kinetic = scalar_series(record, "energy_kinetic");
    const Series* potential = scalar_series(record, "energy_potential");
    const Series* compression = scalar_series(record, "energy_compression");
    if (!kinetic || !potential || !compression || kinetic->time != potential->time ||
        kinetic->time != compression->time)
        return std::nullopt;
    const double scale = std::abs(potential->value.front());
    if (scale == 0) return std::nullopt;
    EnergyChanges changes{
        change(*kinetic, scale), change(*potential, scale), change(*compression, scale), {}};
    changes.total = changes.kinetic;
    for (std::size_t i = 0; i < changes.total.y.size(); ++i)
        changes.total.y[i] += changes.potential.y[i] + changes.compression.y[i];
    return changes;
}

void add_energy_loss(RunRecord& record) {
    const std::optional<EnergyChanges> changes = energy_changes(record);
    if (!changes) return;
    Series loss{"-", energy_loss_description, changes->total.x, changes->total.y, {}};
    for (double& value : loss.value) value = -value;
    record.series.try_emplace(energy_loss_name, std::move(loss));
}

std::optional<double> relative_drift(const RunRecord& record, const std::string& name) {
    const Series* series = scalar_series(record, name);
    if (series == nullptr || series->value.front() == 0) return std::nullopt;
    double drift = 0;
    for (const double value : series->value)
        drift = std::max(drift, std::abs(value / series->value.front() - 1));
    return drift;
}

std::optional<double> largest_value(const RunRecord& record, const std::string& name) {
    const Series* series = scalar_series(record, name);
    if (series == nullptr) return std::nullopt;
    return *std::max_element(series->value.begin(), series->value.end());
}

}  // namespace wetdeck
