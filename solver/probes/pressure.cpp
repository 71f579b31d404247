// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/pressure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "solver/core/errors.hpp"
#include "solver/probes/both_halves.hpp"

namespace wetdeck {

namespace {

/// A fluid particle near the points.
struct NearFluid {
    Vec2 position;
    double volume, pressure, reference_density;
    double spacing;  ///< that it was laid at [m]
};

struct NearWall {
    Vec2 position;
    double spacing;  ///< [m]
};

/// What is near the points, as far as the kernel reaches.
struct Surroundings {
    std::vector<NearFluid> fluid;
    std::vector<NearWall> walls;
};

/// A particle as a point of a face sees it; lengths in h.
struct Seen {
    double weight;  ///< V W
    Vec2 from_point;
    double pressure, carried;  ///< p and q
};

/// Around all points, as far as the kernel reaches.
Box neighbourhood(std::span<const FacePoint> points, double reach) {
    Box near{points[0].place, points[0].place};
    for (const FacePoint& point : points) extend(near, point.place);
    return {near.low - Vec2::Constant(reach), near.high + Vec2::Constant(reach)};
}

Surroundings surroundings(const Simulation& simulation, const Box& box) {
    const auto inside = [&box](double x, double y) {
        return x >= box.low.x() && x <= box.high.x() && y >= box.low.y() && y <= box.high.y();
    };
    const Model& model = simulation.model();
    const FluidParticles& fluid = simulation.fluid();
    Surroundings near;
    for_each_in_both_halves(simulation, fluid.size(), [&](std::size_t i, Vec2 at) {
        if (!inside(at.x(), at.y())) return;
        const FluidState& p = fluid.state[i];
        const TaitEquationOfState& law = (i < fluid.water ? model.water : model.air).eos;
        near.fluid.push_back({at, p.volume, p.pressure - model.water.eos.background_pressure,
                              law.reference_density, simulation.spacing_of(p)});
    });
    const WallParticles& walls = simulation.walls();
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const WallState& wall = walls.state[n];
        if (inside(wall.x, wall.y))
            near.walls.push_back({{wall.x, wall.y}, simulation.particle_spacing() / walls.fineness[n]});
    }
    return near;
}

/// The kernel of the particles at a point: that of the nearest.
WendlandC2 kernel_at(Vec2 place, const Surroundings& near, const Simulation& simulation) {
    WendlandC2 kernel = simulation.kernel();
    if (!simulation.graded() || near.fluid.empty()) return kernel;
    const auto nearest = std::min_element(
        near.fluid.begin(), near.fluid.end(), [place](const NearFluid& a, const NearFluid& b) {
            return (a.position - place).squaredNorm() < (b.position - place).squaredNorm();
        });
    kernel.smoothing_length *= nearest->spacing / simulation.particle_spacing();
    return kernel;
}

/// The fluid in front of the face. Particles that are pressed into it by up to half a spacing count.
std::vector<Seen> seen_from(const FacePoint& point, const Surroundings& near, const WendlandC2& kernel,
                            const Simulation& simulation) {
    const Vec2 pull = simulation.model().gravity - point.acceleration.dot(point.normal) * point.normal;
    std::vector<Seen> seen;
    for (const NearFluid& p : near.fluid) {
        const Vec2 from_point = p.position - point.place;
        const double weight = p.volume * kernel.value(from_point.norm());
        if (weight == 0 || from_point.dot(point.normal) < -0.5 * p.spacing) continue;
        seen.push_back({weight, from_point / kernel.smoothing_length, p.pressure,
                        p.pressure - p.reference_density * pull.dot(from_point)});
    }
    return seen;
}

/// S: at most that of a straight face, so that a face without boundary particles is read, too.
double open_share(Vec2 place, const Surroundings& near, const WendlandC2& kernel) {
    double covered = 0;
    for (const NearWall& wall : near.walls)
        covered += wall.spacing * wall.spacing * kernel.value((wall.position - place).norm());
    return std::clamp(1 - covered, 0.125, 0.5);
}

double smaller_eigenvalue(const Eigen::Matrix2d& c) {
    return 0.5 * (c.trace() - std::hypot(c(0, 0) - c(1, 1), 2 * c(0, 1)));
}

/// f s . (x - <x>)
double rise_of_fit(const std::vector<Seen>& seen, double weight, double mean_carried) {
    constexpr double least_spread = 0.02, unexplained = 100;
    Vec2 centre = Vec2::Zero(), b = Vec2::Zero();
    for (const Seen& p : seen) centre += p.weight / weight * p.from_point;
    Eigen::Matrix2d c = Eigen::Matrix2d::Zero();
    double variance = 0;
    for (const Seen& p : seen) {
        const Vec2 off = p.from_point - centre;
        const double share = p.weight / weight, excess = p.carried - mean_carried;
        c += share * off * off.transpose();
        b += share * excess * off;
        variance += share * excess * excess;
    }
    const double spread = std::min(1.0, smaller_eigenvalue(c) / least_spread);
    if (!(spread > 1e-6)) return 0;
    const Vec2 slope = c.inverse() * b;
    const double explained = slope.dot(b);
    if (!(explained > 0)) return 0;
    const double doubt = unexplained * std::max(0.0, variance - explained) / explained;
    return -std::max(0.0, 1 - doubt) * spread * spread * slope.dot(centre);
}

double pressure_at(const std::vector<Seen>& seen, double open) {
    double weight = 0, pressure = 0, carried = 0;
    for (const Seen& p : seen) {
        weight += p.weight;
        pressure += p.weight * p.pressure;
        carried += p.weight * p.carried;
    }
    if (weight == 0) return 0;
    pressure /= weight;
    carried /= weight;
    const double wet = std::min(1.0, 2 * weight / open);
    return wet * (pressure + wet * wet * (carried - pressure + rise_of_fit(seen, weight, carried)));
}

}  // namespace

std::vector<double> face_pressures(const Simulation& simulation, std::span<const FacePoint> points) {
    std::vector<double> pressure;
    if (points.empty()) return pressure;
    const Surroundings near = surroundings(
        simulation, neighbourhood(points, simulation.coarsest() * simulation.kernel().support_radius()));
    const bool bears_tension =
        simulation.model().negative_pressure || simulation.fluid().water < simulation.fluid().size();
    for (const FacePoint& point : points) {
        const WendlandC2 kernel = kernel_at(point.place, near, simulation);
        const double p =
            pressure_at(seen_from(point, near, kernel, simulation), open_share(point.place, near, kernel));
        pressure.push_back(bears_tension ? p : std::max(0.0, p));
    }
    return pressure;
}

double largest_mean(std::span<const double> values, double width) {
    std::vector<double> integral = {0};
    for (const double value : values) integral.push_back(integral.back() + value);
    const double end = static_cast<double>(values.size());
    const auto integral_to = [&](double x) {
        const auto whole = static_cast<std::size_t>(std::min(std::floor(x), end - 1));
        return integral[whole] + (x - static_cast<double>(whole)) * values[whole];
    };
    // the integral over a window is linear while neither of its ends passes a boundary
    double largest = -std::numeric_limits<double>::infinity();
    const auto take = [&](double from) {
        if (from >= 0 && from + width <= end)
            largest = std::max(largest, (integral_to(from + width) - integral_to(from)) / width);
    };
    for (double boundary = 0; boundary <= end; ++boundary) {
        take(boundary);
        take(boundary - width);
    }
    return largest;
}

FacePoint placed(const FacePoint& point, const RigidBody& body) {
    const Vec2 place = body.placed(point.place);
    return {place, body.axes() * point.normal, body.acceleration_at(place - body.position)};
}

PressureGauge::PressureGauge(Vec2 centre, Vec2 normal, double diameter, std::optional<std::size_t> body)
    : diameter_(diameter), body_(body) {
    constexpr int point_count = 16;
    normal.normalize();
    const Vec2 along(-normal.y(), normal.x());
    double sum = 0;
    for (int k = 0; k < point_count; ++k) {
        const double offset = ((k + 0.5) / point_count - 0.5) * diameter;
        point_.push_back({centre + offset * along, normal});
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
