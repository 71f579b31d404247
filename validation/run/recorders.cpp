// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/recorders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "validation/metrics/resample.hpp"
#include "validation/scene/resolution_section.hpp"

namespace wetdeck {
namespace {

/// What a balance of one half says of a symmetric whole.
Balance of_both_halves(Balance half) {
    half.kinetic *= 2;
    half.potential *= 2;
    half.compression *= 2;
    half.mass *= 2;
    half.momentum = {0, 2 * half.momentum.y()};
    return half;
}

}  // namespace

std::vector<double> mean_slopes(const Curve& curve, double width) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        double begin = curve.x[i == 0 ? 0 : i - 1], end = curve.x[std::min(i + 1, curve.x.size() - 1)];
        begin = std::min(begin, std::max(curve.x.front(), curve.x[i] - 0.5 * width));
        end = std::max(end, std::min(curve.x.back(), curve.x[i] + 0.5 * width));
        const double rise = interpolate(curve, end) - interpolate(curve, begin);
        slopes.push_back(end > begin ? rise / (end - begin) : 0);
    }
    return slopes;
}

Recorders::Recorders(const Scene& scene, double particle_spacing)
    : probes_(scene.probes),
      outlines_(local_outlines(scene)),
      water_(scene.water_boxes),
      surface_(scene.initial.surface) {
    for (const Probe& probe : probes_) {
        if (probe.check) probe.check(spacing_of(scene, probe, particle_spacing));
        list_.push_back(probe.series);
    }
    for (std::size_t body = 0; body < outlines_.size(); ++body) {
        for (const BodySeries& each : recorded_body_series()) {
            list_.push_back(each.info);
            list_.back().name = body_series_name(each.info.name, body);
        }
    }
    for (const FluidSeries& each : every_run_series()) list_.push_back(each.info);
}

void Recorders::sample(const Simulation& simulation, std::size_t number, std::vector<double>& values) const {
    const std::vector<double> last = std::exchange(values, {});
    for (const Probe& probe : probes_) probe.sample(simulation, values);
    for (std::size_t body = 0; body < outlines_.size(); ++body) {
        const BodyNow now{simulation, simulation.bodies()[body], outlines_[body], water_, surface_};
        for (const BodySeries& each : recorded_body_series()) values.push_back(each.value(now));
    }
    const Balance fluid =
        simulation.model().mirror_x ? of_both_halves(balance(simulation)) : balance(simulation);
    for (const FluidSeries& each : every_run_series()) {
        const bool due = number % each.samples_between == 0;
        values.push_back(due ? each.value(simulation, fluid) : last.at(values.size()));
    }
}

void add_body_means(const Scene& scene, std::map<std::string, Series>& series) {
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        for (const DerivedSeries& each : derived_body_series()) {
            const Series& from = series.at(body_series_name(each.recorded, body));
            const double filter = each.filtered ? scene.force_filter : 0;
            const double width = std::max(filter, 2 * scene.sample_interval);
            Series to{
                each.info.unit,
                fmt::format("{}; centred moving mean over {:.4g} ms", each.info.description, 1e3 * width),
                from.time,
                mean_slopes({from.time, from.value}, filter),
                {}};
            series[body_series_name(each.info.name, body)] = std::move(to);
        }
    }
}

}  // namespace wetdeck
