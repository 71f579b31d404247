// SPDX-License-Identifier: BSD-3-Clause
#include "solver/particles/fluid.hpp"

#include "solver/core/errors.hpp"

namespace wetdeck {

void FluidParticles::add(Phase phase, Vec2 position, double particle_mass, double density, double fineness) {
    if (phase == Phase::water) {
        if (water != size()) throw InputError("water particles must be added before air particles");
        ++water;
    }
    append_particle(*this);
    state.back().x = position.x();
    state.back().y = position.y();
    state.back().density = density;
    state.back().volume = particle_mass / density;
    state.back().fineness = fineness;
    mass.back() = particle_mass;
    id.back() = static_cast<std::uint32_t>(id.size() - 1);
}

}  // namespace wetdeck
