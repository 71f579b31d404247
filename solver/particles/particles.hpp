// SPDX-License-Identifier: BSD-3-Clause
// Storage of fluid and boundary particles.
//
// The pair loop reads neighbours one by one in an order that follows the geometry, so what it needs of a
// neighbour stands together in one cache line (FluidState). What only the owner needs (rates, mass) stands in
// arrays beside it. Fluid particles are kept sorted: water first, then air, each along the cells of the
// neighbour grid; `id` is stable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck {

enum class Phase : std::uint8_t { water = 0, air = 1 };
inline constexpr std::size_t phase_count = 2;

/// What a neighbour must know of a fluid particle: one cache line.
struct alignas(64) FluidState {
    double x = 0;         ///< position [m]
    double y = 0;         ///< its y [m]
    double vx = 0;        ///< velocity [m/s]
    double vy = 0;        ///< its y [m/s]
    double pressure = 0;  ///< [Pa], includes the background pressure
    double volume = 0;    ///< mass / density [m^2]
    double density = 0;   ///< [kg/m^3]
    double impact = 0;    ///< 1 where the dissipation switch is on, else 0

    /// Position [m].
    Vec2 position() const { return {x, y}; }
    /// Velocity [m/s].
    Vec2 velocity() const { return {vx, vy}; }
};

/// Fluid particles: indices [0, water) are water, [water, size) air. Where a step of the water has several of
/// the air, what acts on water besides air counts that many times in its rates, or not at all.
struct FluidParticles {
    std::vector<FluidState> state;       ///< what neighbours read
    std::vector<double> mass;            ///< [kg/m]
    std::vector<double> density_rate;    ///< [kg/(m^3 s)]
    std::vector<double> cover;           ///< SUM_j V_j W_ij, where densities are bounded by it
    std::vector<double> acceleration_x;  ///< [m/s^2], gravity included
    std::vector<double> acceleration_y;  ///< [m/s^2], gravity included
    std::vector<std::uint32_t> id;       ///< stable under sorting
    std::size_t water = 0;               ///< number of water particles

    /// Number of particles of both phases.
    std::size_t size() const { return state.size(); }
    /// Of particle i.
    Phase phase(std::size_t i) const { return i < water ? Phase::water : Phase::air; }

    /// Appends one particle at rest; all water must be added before the first air particle.
    void add(Phase phase, Vec2 position, double particle_mass, double density);
};

/// What a fluid particle must know of a boundary particle.
struct alignas(64) WallState {
    double x = 0;   ///< position [m]
    double y = 0;   ///< its y [m]
    double vx = 0;  ///< velocity of the wall there [m/s]
    double vy = 0;  ///< its y [m/s]
    double nx = 0;  ///< unit normal of the nearest face, into the fluid; zero at an edge
    double ny = 0;  ///< its other component
    double ax = 0;  ///< acceleration of the wall there [m/s^2]
    double ay = 0;  ///< its y [m/s^2]
};

/// Shepard means of the fluid around a boundary particle.
struct WallMean {
    double pressure = 0;  ///< [Pa], carried to the particle's own place
    double vx = 0;        ///< velocity [m/s]
    double vy = 0;        ///< its y [m/s]
};

/// Place and normal of a boundary particle in the frame of its body.
struct BodyPoint {
    double x = 0;            ///< place [m]
    double y = 0;            ///< its y [m]
    double nx = 0;           ///< unit normal, into the fluid
    double ny = 0;           ///< its other component
    std::uint32_t body = 0;  ///< number of the body
};

/// Dummy particles: indices [0, fixed) are the tank's walls, [fixed, size) belong to bodies. All have the
/// volume particle_spacing^2.
struct WallParticles {
    std::vector<WallState> state;       ///< what the fluid reads
    std::vector<WallMean> mean;         ///< where the model uses it
    std::vector<double> force_x;        ///< of the phase last summed on each; bodies only [N/m]
    std::vector<double> force_y;        ///< the same along y [N/m]
    std::vector<BodyPoint> body_point;  ///< of [fixed, size)
    std::vector<std::uint32_t> id;      ///< stable under sorting
    std::size_t fixed = 0;              ///< number of particles of the tank's walls

    /// Number of all boundary particles.
    std::size_t size() const { return state.size(); }
    /// Appends a particle of a tank wall; all of them must be added before the first of a body.
    void add(Vec2 position, Vec2 normal);
    /// Appends a particle of a body. Both vectors are in the body's frame, whose origin is the mass centre.
    void add_body_point(std::uint32_t body, Vec2 position, Vec2 normal);
};

}  // namespace wetdeck
