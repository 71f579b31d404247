// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/probes/both_halves.hpp"

namespace wetdeck {
namespace {

/// A side of a polygon, ready for many points.
struct Side {
    Vec2 from, along;  ///< a unit vector
    double length;

    double distance(Vec2 point) const {
        const Vec2 r = point - from;
        return (r - std::clamp(r.dot(along), 0.0, length) * along).norm();
    }
};

std::vector<Side> sides_of(std::span<const Vec2> corners) {
    std::vector<Side> sides;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 side = corners[(k + 1) % corners.size()] - corners[k];
        sides.push_back({corners[k], side.normalized(), side.norm()});
    }
    return sides;
}

}  // namespace

double front_position(const Simulation& simulation, const FrontProbe& probe) {
    const FluidParticles& fluid = simulation.fluid();
    const double sign = probe.forward ? 1 : -1;
    const Box tank = whole_tank(simulation);
    const double begin = probe.forward ? std::max(probe.range.low[probe.axis], tank.low[probe.axis])
                                       : std::min(probe.range.high[probe.axis], tank.high[probe.axis]);
    const double end = (probe.forward ? probe.range.high : probe.range.low)[probe.axis];
    double front = -std::numeric_limits<double>::infinity();  // along the direction
    for_each_in_both_halves(simulation, fluid.water, [&](std::size_t i, Vec2 at) {
        const bool within = (at - probe.range.low).minCoeff() >= 0 && (probe.range.high - at).minCoeff() >= 0;
        const double half = 0.5 * simulation.spacing_of(fluid.state[i]);
        if (within) front = std::max(front, sign * at[probe.axis] + half);
    });
    if (!std::isfinite(front)) return begin;
    return sign * std::min(front, sign * end);
}

double front_position(const Simulation& simulation) {
    const Vec2 unbounded = Vec2::Constant(std::numeric_limits<double>::infinity());
    return front_position(simulation, {0, true, {-unbounded, unbounded}});
}

double water_depth(const Simulation& simulation, double x, double width) {
    const FluidParticles& fluid = simulation.fluid();
    const Box tank = whole_tank(simulation);
    const double beyond =
        std::max(0.0, tank.low.x() - (x - 0.5 * width)) + std::max(0.0, x + 0.5 * width - tank.high.x());
    double volume = 0;
    for_each_in_both_halves(simulation, fluid.water, [&](std::size_t i, Vec2 at) {
        // a particle counts by the share of its width that lies in the strip
        const double dx = simulation.spacing_of(fluid.state[i]);
        const double low = std::max(at.x() - 0.5 * dx, x - 0.5 * width);
        const double high = std::min(at.x() + 0.5 * dx, x + 0.5 * width);
        volume += fluid.state[i].volume * std::max(0.0, high - low) / dx;
    });
    return volume / (width - beyond);
}

std::vector<double> water_top(const Simulation& simulation, double low, double high, std::size_t count) {
    const FluidParticles& fluid = simulation.fluid();
    const double width = (high - low) / static_cast<double>(count);
    std::vector<double> top(count, simulation.domain().low.y());
    for_each_in_both_halves(simulation, fluid.water, [&](std::size_t i, Vec2 at) {
        const double dx = simulation.spacing_of(fluid.state[i]);
        // neighbours overlap, so that no column falls between two that have moved apart a little
        const double first = std::ceil((at.x() - 0.75 * dx - low) / width - 0.5);
        const double last = std::floor((at.x() + 0.75 * dx - low) / width - 0.5);
        const double end = std::min(last, static_cast<double>(count) - 1);
        for (double k = std::max(first, 0.0); k <= end; ++k) {
            double& height = top[static_cast<std::size_t>(k)];
            height = std::max(height, at.y() + 0.5 * dx);
        }
    });
    return top;
}

double gap_to_water(const Simulation& simulation, std::size_t body, Vec2 from, Vec2 to) {
    const RigidBody& b = simulation.bodies().at(body);
    const double length = (to - from).norm();
    const Vec2 along = (to - from) / length, outward(along.y(), -along.x());
    const Eigen::Matrix2d into_frame = b.axes().transpose();
    const FluidParticles& fluid = simulation.fluid();
    double gap =
        (simulation.domain().high - simulation.domain().low).norm() - 0.5 * simulation.particle_spacing();
    for_each_in_both_halves(simulation, fluid.water, [&](std::size_t i, Vec2 at) {
        const Vec2 r = into_frame * (at - b.position) - from;
        const double s = r.dot(along), distance = r.dot(outward);
        const double half = 0.5 * simulation.spacing_of(fluid.state[i]);
        if (s >= 0 && s <= length && distance > 0) gap = std::min(gap, distance - half);
    });
    return std::max(0.0, gap);
}

double gap_around(const Simulation& simulation, std::span<const Vec2> corners) {
    const std::vector<Side> sides = sides_of(corners);
    Box around{corners[0], corners[0]};
    for (const Vec2& corner : corners) extend(around, corner);
    const FluidParticles& fluid = simulation.fluid();
    const double half = 0.5 * simulation.particle_spacing();
    double nearest = (simulation.domain().high - simulation.domain().low).norm();
    for_each_in_both_halves(simulation, fluid.water, [&](std::size_t, Vec2 at) {
        const Vec2 outside = (around.low - at).cwiseMax(at - around.high);
        if (nearest <= half || outside.maxCoeff() >= nearest) return;
        for (const Side& side : sides) nearest = std::min(nearest, side.distance(at));
    });
    return std::max(0.0, nearest - half);
}

}  // namespace wetdeck
