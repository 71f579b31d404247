// SPDX-License-Identifier: BSD-3-Clause
// Storage of boundary particles: dummy particles of the tank's walls and of bodies.
#pragma once

#include "solver/core/vec2.hpp"
#include "solver/particles/fields.hpp"

namespace wetdeck {

/// The state of a boundary particle as the fluid reads it: one cache line.
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

/// The fluid around a boundary particle: Shepard means, and whether it touches.
struct WallMean {
    double pressure = 0;  ///< [Pa], carried to the particle's own position
    double vx = 0;        ///< velocity [m/s]
    double vy = 0;        ///< its y [m/s]
    double wetness = 1;   ///< share of the wall's approach that the water feels, 0 while dry
};

/// Position and normal of a boundary particle in the frame of its body.
struct BodyPoint {
    double x = 0;            ///< position [m]
    double y = 0;            ///< its y [m]
    double nx = 0;           ///< unit normal, into the fluid
    double ny = 0;           ///< its other component
    std::uint32_t body = 0;  ///< number of the body
};

/// Boundary particles: indices [0, fixed) are the tank's walls, [fixed, size) belong to bodies. All have the
/// volume (particle_spacing / fineness)^2.
struct WallParticles {
    std::vector<WallState> state;       ///< what the fluid reads
    std::vector<WallMean> mean;         ///< where the model uses it
    std::vector<double> fineness;       ///< the finest spacing over its own, 1 where all are equal
    std::vector<double> own_sum;        ///< kernel sum over the walls of the same body, or of the tank
    std::vector<double> force_x;        ///< of the phase last summed on each; bodies only [N/m]
    std::vector<double> force_y;        ///< the same along y [N/m]
    std::vector<BodyPoint> body_point;  ///< zero for the tank's walls
    std::vector<std::uint32_t> id;      ///< stable under sorting
    std::size_t fixed = 0;              ///< number of particles of the tank's walls

    /// Number of all boundary particles.
    std::size_t size() const { return state.size(); }
    /// Appends a particle of a tank wall; all of them must be added before the first of a body.
    void add(Vec2 position, Vec2 normal, double fineness = 1);
    /// Appends a particle of a body. Both vectors are in the body's frame, whose origin is the mass centre.
    void add_body_point(std::uint32_t body, Vec2 position, Vec2 normal);
};

/// The declaration of each field of the walls.
constexpr auto fields_of(const WallParticles&) {
    using P = WallParticles;
    return std::tuple{Field{"wall", &P::state, Sorted::yes, Stored::yes},
                      Field{"wall_mean", &P::mean, Sorted::yes, Stored::yes},
                      Field{"wall_fineness", &P::fineness, Sorted::yes, Stored::no},
                      Field{"wall_own_sum", &P::own_sum, Sorted::yes, Stored::no},
                      Field{"wall_id", &P::id, Sorted::yes, Stored::yes},
                      Field{"body_point", &P::body_point, Sorted::yes, Stored::no},
                      Field{"wall_force_x", &P::force_x, Sorted::no, Stored::no},
                      Field{"wall_force_y", &P::force_y, Sorted::no, Stored::no}};
}

}  // namespace wetdeck
