// SPDX-License-Identifier: BSD-3-Clause
// Everything that moves: fluid particles, boundary particles, bodies; and how boundary particles and bodies
// belong together, Yang et al. (2020), Eqs. (20)-(23).
#pragma once

#include <vector>

#include "solver/bodies/moving_frame.hpp"
#include "solver/bodies/rigid_body.hpp"
#include "solver/particles/fluid.hpp"
#include "solver/particles/walls.hpp"
#include "solver/physics/wendland_c2.hpp"

namespace wetdeck {

/// Fluid, walls and bodies at one time.
struct Flow {
    FluidParticles fluid;           ///< of both phases
    WallParticles walls;            ///< of the tank, then of the bodies
    std::vector<RigidBody> bodies;  ///< in the order of the numbers that their boundary particles carry
    double time = 0;                ///< of the positions, since the start [s]
    MovingFrame tank_motion;        ///< of the tank, whose frame all positions and velocities are in

    /// Whether there are particles of both phases.
    bool two_phase() const { return fluid.water > 0 && fluid.water < fluid.size(); }
};

/// Sets radius, added mass and added inertia of each body from its boundary particles, and the acceleration
/// at the start of bodies that are lighter than their added mass: free fall, which they would else take steps
/// to reach.
/// @param added_mass  of each boundary particle [kg/m]
/// @param gravity     [m/s^2]
///
/// Throws std::out_of_range where a boundary particle carries the number of no body.
void measure_bodies(Flow& flow, double added_mass, Vec2 gravity);

/// Sets the kernel sum of each boundary particle over those of the same body, or of the tank, itself
/// included; 1 at most.
/// @param kernel  of the finest spacing
/// @param volume  of each boundary particle of the finest spacing [m^2]
void sum_own_kernels(WallParticles& walls, const WendlandC2& kernel, double volume);

/// Moves the boundary particles of the bodies to where the poses put them, Eqs. (22)-(23). Where the tank
/// moves, all walls get the acceleration against the forces of its frame, as the wall pressure needs it.
void place_walls(Flow& flow, Vec2 gravity);

/// Sets where joined bodies are in the frames of those that carry them. Throws std::out_of_range where a body
/// is joined to none before it.
void join_bodies(Flow& flow);

/// Gives joined bodies the pose and the motion that follow from those that carry them.
void carry_joined_bodies(std::vector<RigidBody>& bodies);

/// Sum of the forces that the last force pass left on the boundary particles of one body, Eqs. (20)-(21).
BodyLoad load_on(const Flow& flow, std::size_t body);

/// The same where the flow to the right of a plane x = const is computed alone: twice that of the boundary
/// particles there, without force along x and torque.
BodyLoad load_on_both_halves(const Flow& flow, std::size_t body, double plane, double particle_spacing);

/// Share of a particle in the half that is computed: 1 in it, 1/2 on the plane, 0 behind.
/// @param distance  from the plane [m]
inline double share_of_half(double distance, double particle_spacing) {
    const double on_plane = 1e-6 * particle_spacing;
    return distance > on_plane ? 1 : distance < -on_plane ? 0 : 0.5;
}

}  // namespace wetdeck
