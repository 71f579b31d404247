// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/energy.hpp"

#include <algorithm>
#include <cmath>

namespace wetdeck {

Balance balance(const Simulation& simulation) {
    const FluidParticles& fluid = simulation.fluid();
    const Model& model = simulation.model();
    const Vec2 margin = Vec2::Constant(0.25 * simulation.particle_spacing());
    const Vec2 low = simulation.domain().low - margin, high = simulation.domain().high + margin;
    Balance sum;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        const double m = fluid.mass[i];
        const bool water = i < fluid.water;
        const TaitEquationOfState& eos = water ? model.water.eos : model.air.eos;
        sum.kinetic += 0.5 * m * (p.vx * p.vx + p.vy * p.vy);
        sum.potential -= m * (model.gravity.x() * p.x + model.gravity.y() * p.y);
        sum.compression += m * eos.compression_energy(p.density, p.pressure);
        sum.momentum += m * p.velocity();
        sum.mass += m;
        if (water) {
            const double error = std::abs(p.density / eos.reference_density - 1);
            sum.water_density_error = std::max(sum.water_density_error, error);
        }
        if (p.x < low.x() || p.y < low.y() || p.x > high.x() || p.y > high.y()) ++sum.outside;
    }
    return sum;
}

}  // namespace wetdeck
