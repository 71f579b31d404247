// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/field_frame.hpp"

namespace wetdeck {

FieldFrame frame_of(const Simulation& simulation, const std::string& provenance) {
    constexpr int wall = 2;
    FieldFrame frame;
    frame.time = simulation.time();
    frame.provenance = provenance;
    const auto add = [&frame](double x, double y, double vx, double vy, double p, double rho, int phase,
                              std::int64_t id) {
        frame.x.push_back(static_cast<float>(x));
        frame.y.push_back(static_cast<float>(y));
        frame.vx.push_back(static_cast<float>(vx));
        frame.vy.push_back(static_cast<float>(vy));
        frame.pressure.push_back(static_cast<float>(p));
        frame.density.push_back(static_cast<float>(rho));
        frame.phase.push_back(phase);
        frame.id.push_back(id);
    };
    const FluidParticles& fluid = simulation.fluid();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        const double background = simulation.model().water.eos.background_pressure;
        add(p.x, p.y, p.vx, p.vy, p.pressure - background, p.density, static_cast<int>(fluid.phase(i)),
            fluid.id[i]);
    }
    const WallParticles& walls = simulation.walls();
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const WallState& w = walls.state[i];
        const double rho0 = simulation.model().water.eos.reference_density;
        const bool fixed = i < walls.fixed;
        const int phase = fixed ? wall : wall + 1 + static_cast<int>(walls.body_point[i].body);
        add(w.x, w.y, w.vx, w.vy, 0, rho0, phase, static_cast<std::int64_t>(fluid.size() + walls.id[i]));
    }
    return frame;
}

}  // namespace wetdeck
