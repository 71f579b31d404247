// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/conservation.hpp"

#include <algorithm>
#include <cmath>

#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

/// Work of the fluid on all bodies at each sample [J/m]: energy given to bodies is not lost.
std::vector<double> work_on_bodies(const RunRecord& record, std::size_t samples) {
    std::vector<double> work(samples, 0);
    for (const auto& [name, series] : record.series) {
        if (!name.starts_with("body_work") || series.value.size() != samples) continue;
        for (std::size_t i = 0; i < samples; ++i) work[i] += series.value[i];
    }
    return work;
}

}  // namespace

std::optional<double> energy_error(const RunRecord& record) {
    const SeriesCurve kinetic = series_curve(record, "energy_kinetic");
    const SeriesCurve potential = series_curve(record, "energy_potential");
    const SeriesCurve compression = series_curve(record, "energy_compression");
    for (const SeriesCurve* part : {&kinetic, &potential, &compression}) {
        if (!part->problem.empty() || part->curve.x != kinetic.curve.x) return std::nullopt;
    }
    const auto& height = potential.curve.y;
    const auto [lowest_height, highest_height] = std::minmax_element(height.begin(), height.end());
    const double scale = std::max(*highest_height - *lowest_height, std::abs(height.front()));
    if (scale == 0) return std::nullopt;
    const std::vector<double> work = work_on_bodies(record, height.size());
    double lowest = kinetic.curve.y[0] + height[0] + compression.curve.y[0] + work[0];
    double rise = 0;
    for (std::size_t i = 0; i < height.size(); ++i) {
        const double total = kinetic.curve.y[i] + height[i] + compression.curve.y[i] + work[i];
        lowest = std::min(lowest, total);
        rise = std::max(rise, total - lowest);
    }
    return rise / scale;
}

std::optional<double> momentum_error(const RunRecord& record) {
    const SeriesCurve series = series_curve(record, "momentum_error");
    if (!series.problem.empty()) return std::nullopt;
    double largest = 0;
    for (const double error : series.curve.y) largest = std::max(largest, std::abs(error));
    return largest;
}

}  // namespace wetdeck
