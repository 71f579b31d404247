// SPDX-License-Identifier: BSD-3-Clause
// Error against cost, and which runs are not beaten in both.
#include "validation/metrics/speed_error.hpp"

#include <algorithm>

namespace wetdeck {
namespace {

std::optional<double> error_of(const RunSummary& run, const std::string& quantity) {
    if (run.record.status != RunStatus::ok) return std::nullopt;
    for (const QuantityResult& result : run.quantities) {
        if (result.name == quantity) return result.value;
    }
    return std::nullopt;
}

bool beats(const SpeedErrorPoint& a, const SpeedErrorPoint& b) {
    if (!a.error) return false;
    const bool no_worse = a.core_s <= b.core_s && *a.error <= *b.error;
    return no_worse && (a.core_s < b.core_s || *a.error < *b.error);
}

}  // namespace

std::vector<SpeedErrorPoint> speed_error_points(const std::vector<RunSummary>& runs, const std::string& scene,
                                                const std::string& error_quantity) {
    std::vector<SpeedErrorPoint> points;
    for (const RunSummary& run : runs) {
        if (run.record.scene != scene) continue;
        points.push_back({scene, run.record.variant, run.record.particle_spacing, run.record.cost.core_s,
                          error_of(run, error_quantity), false});
    }
    for (SpeedErrorPoint& point : points) {
        point.pareto = point.error &&
                       std::none_of(points.begin(), points.end(),
                                    [&point](const SpeedErrorPoint& other) { return beats(other, point); });
    }
    return points;
}

}  // namespace wetdeck
