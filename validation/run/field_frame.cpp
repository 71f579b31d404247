// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/field_frame.hpp"

namespace wetdeck {

FieldFrame frame_of(const Simulation& simulation, const std::string& provenance) {
    constexpr int wall = 2;
    FieldFrame frame;
    frame.time = simulation.time();
    frame.provenance = provenance;
    const auto add = [&frame](const auto& particle, double pressure, double density, int phase,
                              std::size_t id) {
        frame.x.push_back(static_cast<float>(particle.x));
        frame.y.push_back(static_cast<float>(particle.y));
        frame.vx.push_back(static_cast<float>(particle.vx));
        frame.vy.push_back(static_cast<float>(particle.vy));
        frame.pressure.push_back(static_cast<float>(pressure));
        frame.density.push_back(static_cast<float>(density));
        frame.phase.push_back(phase);
        frame.id.push_back(static_cast<std::int64_t>(id));
    };
    const FluidParticles& fluid = simulation.fluid();
    const double background = simulation.model().water.eos.background_pressure;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        add(p, p.pressure - background, p.density, static_cast<int>(fluid.phase(i)), fluid.id[i]);
    }
    const WallParticles& walls = simulation.walls();
    const double rho0 = simulation.model().water.eos.reference_density;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const bool fixed = i < walls.fixed;
        const int phase = fixed ? wall : wall + 1 + static_cast<int>(walls.body_point[i].body);
        add(walls.state[i], 0, rho0, phase, fluid.size() + walls.id[i]);
    }
    return frame;
}

}  // namespace wetdeck
