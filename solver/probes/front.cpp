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

}  // namespace wetdeck
