// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/field_frame.hpp"

namespace wetdeck {

FieldFrame frame_of(const Simulation& simulation, const std::string& provenance) {
    constexpr int wall = 2;
    const FluidParticles& fluid = simulation.fluid();
    const WallParticles& walls = simulation.walls();
    const std::size_t count = fluid.size() + walls.size();
    FieldFrame frame;
    frame.time = simulation.time();
    frame.provenance = provenance;
    for (auto* values : {&frame.x, &frame.y, &frame.vx, &frame.vy, &frame.pressure, &frame.density})
        values->resize(count);
    if (simulation.graded()) frame.spacing.resize(count);
    frame.phase.resize(count);
    frame.id.resize(count);
    const auto put = [&frame](std::size_t id, const auto& particle, double pressure, double density,
                              int phase) {
        frame.x[id] = static_cast<float>(particle.x);
        frame.y[id] = static_cast<float>(particle.y);
        frame.vx[id] = static_cast<float>(particle.vx);
        frame.vy[id] = static_cast<float>(particle.vy);
        frame.pressure[id] = static_cast<float>(pressure);
        frame.density[id] = static_cast<float>(density);
        frame.phase[id] = phase;
        frame.id[id] = static_cast<std::int64_t>(id);
    };
    const double background = simulation.model().water.eos.background_pressure;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        put(fluid.id[i], p, p.pressure - background, p.density, static_cast<int>(fluid.phase(i)));
        if (simulation.graded()) frame.spacing[fluid.id[i]] = static_cast<float>(simulation.spacing_of(p));
    }
    const double rho0 = simulation.model().water.eos.reference_density;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const bool fixed = i < walls.fixed;
        const int phase = fixed ? wall : wall + 1 + static_cast<int>(walls.body_point[i].body);
        const std::size_t id = fluid.size() + walls.id[i];
        put(id, walls.state[i], 0, rho0, phase);
        if (simulation.graded())
            frame.spacing[id] = static_cast<float>(simulation.particle_spacing() / walls.fineness[i]);
    }
    return frame;
}

}  // namespace wetdeck
