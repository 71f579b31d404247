// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetdeck {

double front_position(const Simulation& simulation) {
    const FluidParticles& fluid = simulation.fluid();
    double front = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < fluid.water; ++i) front = std::max(front, fluid.state[i].x);
    return front + 0.5 * simulation.particle_spacing();
}

double water_depth(const Simulation& simulation, double x, double width) {
    const FluidParticles& fluid = simulation.fluid();
    const double dx = simulation.particle_spacing();
    double volume = 0;
    for (std::size_t i = 0; i < fluid.water; ++i) {
        // a particle counts by the share of its width that lies in the strip
        const double low = std::max(fluid.state[i].x - 0.5 * dx, x - 0.5 * width);
        const double high = std::min(fluid.state[i].x + 0.5 * dx, x + 0.5 * width);
        volume += fluid.state[i].volume * std::max(0.0, high - low) / dx;
    }
    return volume / width;
}

std::vector<double> water_top(const Simulation& simulation, double low, double high, std::size_t count) {
    const FluidParticles& fluid = simulation.fluid();
    const double dx = simulation.particle_spacing(), width = (high - low) / static_cast<double>(count);
    std::vector<double> top(count, simulation.domain().low.y());
    for (std::size_t i = 0; i < fluid.water; ++i) {
        const FluidState& p = fluid.state[i];
        // the particle covers every column that its width reaches
        const double first = std::ceil((p.x - 0.5 * dx - low) / width - 0.5);
        const double last = std::floor((p.x + 0.5 * dx - low) / width - 0.5);
        const double end = std::min(last, static_cast<double>(count) - 1);
        for (double k = std::max(first, 0.0); k <= end; ++k) {
            double& height = top[static_cast<std::size_t>(k)];
            height = std::max(height, p.y + 0.5 * dx);
        }
    }
    return top;
}

double gap_to_water(const Simulation& simulation, std::size_t body, Vec2 from, Vec2 to) {
    const RigidBody& b = simulation.bodies().at(body);
    const double length = (to - from).norm();
    const Vec2 along = (to - from) / length, outward(along.y(), -along.x());
    const Eigen::Matrix2d into_frame = b.axes().transpose();
    const FluidParticles& fluid = simulation.fluid();
    double gap = (simulation.domain().high - simulation.domain().low).norm();
    for (std::size_t i = 0; i < fluid.water; ++i) {
        const Vec2 r = into_frame * (fluid.state[i].position() - b.position) - from;
        const double s = r.dot(along), distance = r.dot(outward);
        if (s >= 0 && s <= length && distance > 0) gap = std::min(gap, distance);
    }
    return std::max(0.0, gap - 0.5 * simulation.particle_spacing());
}

}  // namespace wetdeck
