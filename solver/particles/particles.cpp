// SPDX-License-Identifier: BSD-3-Clause
#include "solver/particles/particles.hpp"

#include "solver/core/errors.hpp"

namespace wetdeck {

void FluidParticles::add(Phase phase, Vec2 position, double particle_mass, double density) {
    if (phase == Phase::water) {
        if (water != size()) throw InputError("water particles must be added before air particles");
        ++water;
    }
    FluidState particle;
    particle.x = position.x();
    particle.y = position.y();
    particle.density = density;
    particle.volume = particle_mass / density;
    state.push_back(particle);
    mass.push_back(particle_mass);
    density_rate.push_back(0);
    cover.push_back(0);
    acceleration_x.push_back(0);
    acceleration_y.push_back(0);
    id.push_back(static_cast<std::uint32_t>(id.size()));
}

void WallParticles::add(Vec2 position, Vec2 normal) {
    if (fixed != size()) throw InputError("tank walls must be added before bodies");
    ++fixed;
    WallState particle;
    particle.x = position.x();
    particle.y = position.y();
    particle.nx = normal.x();
    particle.ny = normal.y();
    state.push_back(particle);
    mean.emplace_back();
    force_x.push_back(0);
    force_y.push_back(0);
    id.push_back(static_cast<std::uint32_t>(id.size()));
}

void WallParticles::add_body_point(std::uint32_t body, Vec2 position, Vec2 normal) {
    state.emplace_back();
    mean.emplace_back();
    force_x.push_back(0);
    force_y.push_back(0);
    id.push_back(static_cast<std::uint32_t>(id.size()));
    body_point.push_back({position.x(), position.y(), normal.x(), normal.y(), body});
}

}  // namespace wetdeck
