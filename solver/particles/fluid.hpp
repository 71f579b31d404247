// SPDX-License-Identifier: BSD-3-Clause
// Storage of fluid particles.
//
// The passes over pairs read neighbours one by one in an order that follows the geometry, so what they need
// of a neighbour stands together in one cache line (FluidState). What only the owner needs (rates, mass)
// stands in arrays beside it. Fluid particles are kept sorted: water first, then air, or coarse water before
// fine, each along the cells of the neighbour grid; `id` is stable.
#pragma once

#include "solver/core/vec2.hpp"
#include "solver/particles/fields.hpp"

namespace wetdeck {

enum class Phase : std::uint8_t { water = 0, air = 1 };
inline constexpr std::size_t phase_count = 2;

/// The state of a fluid particle as its neighbours read it: one cache line.
struct alignas(64) FluidState {
    double x = 0;         ///< position [m]
    double y = 0;         ///< its y [m]
    double vx = 0;        ///< velocity [m/s]
    double vy = 0;        ///< its y [m/s]
    double pressure = 0;  ///< [Pa], includes the background pressure
    double volume = 0;    ///< mass / density [m^2]
    double density = 0;   ///< [kg/m^3]
    union {
        double impact = 0;  ///< where all spacings are equal: 1 where the dissipation switch is on, else 0
        double fineness;    ///< where they differ: the finest smoothing length over the particle's own
    };

    /// Position [m].
    Vec2 position() const { return {x, y}; }
    /// Velocity [m/s].
    Vec2 velocity() const { return {vx, vy}; }
};

/// Fluid particles: indices [0, water) are water, [water, size) air. Where fast fluid takes several steps in
/// one of the slow, the rates of slow fluid hold its pairs with itself times the weight of the substep.
struct FluidParticles {
    std::vector<FluidState> state;       ///< what neighbours read
    std::vector<double> mass;            ///< [kg/m]
    std::vector<double> density_rate;    ///< [kg/(m^3 s)]
    std::vector<double> kernel_sum;      ///< SUM_j V_j W_ij, where it bounds the density
    std::vector<double> acceleration_x;  ///< [m/s^2], gravity included
    std::vector<double> acceleration_y;  ///< [m/s^2], gravity included
    std::vector<std::uint32_t> id;       ///< stable under sorting
    std::size_t water = 0;               ///< number of water particles

    /// Number of particles of both phases.
    std::size_t size() const { return state.size(); }
    /// Phase of particle i.
    Phase phase(std::size_t i) const { return i < water ? Phase::water : Phase::air; }

    /// Appends one particle at rest; all water must be added before the first air particle.
    /// @param fineness  where spacings differ, else 0
    void add(Phase phase, Vec2 position, double particle_mass, double density, double fineness = 0);
};

/// The declaration of each field of the fluid.
constexpr auto fields_of(const FluidParticles&) {
    using P = FluidParticles;
    return std::tuple{Field{"fluid", &P::state, Sorted::yes, Stored::yes},
                      Field{"mass", &P::mass, Sorted::yes, Stored::yes},
                      Field{"id", &P::id, Sorted::yes, Stored::yes},
                      Field{"density_rate", &P::density_rate, Sorted::no, Stored::yes},
                      Field{"kernel_sum", &P::kernel_sum, Sorted::no, Stored::no},
                      Field{"acceleration_x", &P::acceleration_x, Sorted::no, Stored::yes},
                      Field{"acceleration_y", &P::acceleration_y, Sorted::no, Stored::yes}};
}

}  // namespace wetdeck
