// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/pressure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/core/errors.hpp"

namespace wetdeck {

std::vector<double> face_pressures(const Simulation& simulation, std::span<const Vec2> points) {
    std::vector<double> pressure(points.size(), 0), weight(points.size(), 0);
    if (points.empty()) return pressure;
    const WendlandC2 kernel = simulation.kernel();
    const Vec2 reach = Vec2::Constant(kernel.support_radius());
    Box near{points[0], points[0]};
    for (const Vec2& point : points) near = {near.low.cwiseMin(point), near.high.cwiseMax(point)};
    near = {near.low - reach, near.high + reach};
    const FluidParticles& fluid = simulation.fluid();
    const double background = simulation.model().water.eos.background_pressure;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        if (p.x < near.low.x() || p.x > near.high.x() || p.y < near.low.y() || p.y > near.high.y()) continue;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double w = p.volume * kernel.value((p.position() - points[k]).norm());
            pressure[k] += w * (p.pressure - background);
            weight[k] += w;
        }
    }
    constexpr double least_cover = 0.25;
    for (std::size_t k = 0; k < points.size(); ++k) pressure[k] /= std::max(weight[k], least_cover);
    return pressure;
}

PressureGauge::PressureGauge(Vec2 centre, Vec2 along, double diameter, std::optional<std::size_t> body)
    : diameter_(diameter), body_(body) {
    constexpr int point_count = 16;
    double sum = 0;
    for (int k = 0; k < point_count; ++k) {
        const double offset = ((k + 0.5) / point_count - 0.5) * diameter;
        point_.push_back(centre + offset * along.normalized());
        weight_.push_back(std::sqrt(0.25 * diameter * diameter - offset * offset));
        sum += weight_.back();
    }
    for (double& weight : weight_) weight /= sum;
}

void PressureGauge::check(double particle_spacing) const {
    if (diameter_ >= particle_spacing * (1 - 1e-9)) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "a pressure gauge of %.4g m is smaller than the particle spacing %.4g m: too few particles "
                  "to average",
                  diameter_, particle_spacing);
    throw InputError(text);
}

double PressureGauge::sample(const Simulation& simulation) const {
    std::vector<Vec2> points = point_;
    if (body_) {
        for (Vec2& point : points) point = simulation.bodies().at(*body_).placed(point);
    }
    const std::vector<double> pressure = face_pressures(simulation, points);
    double mean = 0;
    for (std::size_t k = 0; k < pressure.size(); ++k) mean += weight_[k] * pressure[k];
    return mean;
}

}  // namespace wetdeck
