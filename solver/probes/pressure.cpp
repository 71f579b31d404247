// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/pressure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/core/errors.hpp"

namespace wetdeck {

namespace {

/// The part of gravity that the kernel's sums at a point do not see, because there is fluid on one side only.
Vec2 one_sided_gravity(const FacePoint& point, Vec2 gravity, double smoothing_length) {
    if (point.to_end < smoothing_length) return gravity;
    return gravity - gravity.dot(point.along) * point.along;
}

/// Around all points, as far as the kernel reaches.
Box neighbourhood(std::span<const FacePoint> points, double reach) {
    Box near{points[0].place, points[0].place};
    for (const FacePoint& point : points)
        near = {near.low.cwiseMin(point.place), near.high.cwiseMax(point.place)};
    return {near.low - Vec2::Constant(reach), near.high + Vec2::Constant(reach)};
}

}  // namespace

std::vector<double> face_pressures(const Simulation& simulation, std::span<const FacePoint> points) {
    std::vector<double> pressure(points.size(), 0), rise(points.size(), 0), weight(points.size(), 0);
    if (points.empty()) return pressure;
    const WendlandC2 kernel = simulation.kernel();
    std::vector<Vec2> gravity;
    for (const FacePoint& point : points)
        gravity.push_back(one_sided_gravity(point, simulation.model().gravity, kernel.smoothing_length));
    const Box near = neighbourhood(points, kernel.support_radius());
    const FluidParticles& fluid = simulation.fluid();
    const double background = simulation.model().water.eos.background_pressure;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        if (p.x < near.low.x() || p.x > near.high.x() || p.y < near.low.y() || p.y > near.high.y()) continue;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec2 from_point = p.position() - points[k].place;
            const double w = p.volume * kernel.value(from_point.norm());
            pressure[k] += w * (p.pressure - background);
            rise[k] -= w * p.density * gravity[k].dot(from_point);
            weight[k] += w;
        }
    }
    constexpr double least_cover = 0.25;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double wet = std::min(1.0, weight[k] / least_cover);
        pressure[k] = (pressure[k] + wet * wet * rise[k]) / std::max(weight[k], least_cover);
    }
    return pressure;
}

FacePoint placed(const FacePoint& point, const RigidBody& body) {
    return {body.placed(point.place), body.axes() * point.along, point.to_end};
}

PressureGauge::PressureGauge(Vec2 centre, Vec2 along, double diameter, std::optional<std::size_t> body,
                             double centre_to_end)
    : diameter_(diameter), body_(body) {
    constexpr int point_count = 16;
    double sum = 0;
    for (int k = 0; k < point_count; ++k) {
        const double offset = ((k + 0.5) / point_count - 0.5) * diameter;
        point_.push_back(
            {centre + offset * along.normalized(), along.normalized(), centre_to_end - std::abs(offset)});
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
    std::vector<FacePoint> points = point_;
    if (body_) {
        for (FacePoint& point : points) point = placed(point, simulation.bodies().at(*body_));
    }
    const std::vector<double> pressure = face_pressures(simulation, points);
    double mean = 0;
    for (std::size_t k = 0; k < pressure.size(); ++k) mean += weight_[k] * pressure[k];
    return mean;
}

}  // namespace wetdeck
