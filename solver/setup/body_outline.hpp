// SPDX-License-Identifier: BSD-3-Clause
// From the outline of a body to its boundary particles, and room for it in the fluid.
//
// Layers are parallel curves of the outline, half a spacing and then one spacing apart, with mitred corners:
// a keel stays sharp and no lattice is cut, whatever the angle of a face.
#pragma once

#include <vector>

#include "solver/core/vec2.hpp"
#include "solver/particles/fluid.hpp"
#include "solver/particles/walls.hpp"

namespace wetdeck {

/// Corners of a closed polygon in order, either way round [m]; the last side leads back to the first.
using Outline = std::vector<Vec2>;

/// Throws InputError, with the reason, unless the outline is a simple polygon with an area: at least three
/// corners, finite, no sides that cross or touch.
void check_outline(const Outline& outline);

/// Signed distance of a point from the outline [m], negative inside.
double distance_to(const Outline& outline, Vec2 point);

/// Whether a point lies inside, by counting sides; cheap enough to ask of every particle. Points on a side
/// may count either way.
bool contains(const Outline& outline, Vec2 point);

/// Whether two outlines share any point.
bool overlap(const Outline& a, const Outline& b);
/// Area that two outlines share [m^2]: none where they only touch.
double shared_area(const Outline& a, const Outline& b);
/// What an outline leaves of a box, as one outline a part.
std::vector<Outline> parts_outside(Box box, const Outline& outline);
/// Whether the outline lies in the box without touching its sides.
bool inside(const Outline& outline, Box box);

/// Area [m^2] and centroid of the polygon, and its second moment of area about the centroid [m^4].
struct AreaMoments {
    double area = 0;               ///< [m^2]
    Vec2 centroid = Vec2::Zero();  ///< in the coordinates of the outline [m]
    double second_moment = 0;      ///< about the centroid [m^4]
};
/// Of the area inside the outline.
AreaMoments area_moments(const Outline& outline);

/// The corners of a box, counter-clockwise.
Outline corners_of(Box box);

/// What the outlines leave of a box: area and centroid, no second moment.
AreaMoments area_left(Box box, const std::vector<Outline>& outlines);

/// Appends the layers of body number `body` to `walls`, as deep as the kernel's support or as the body is
/// thick.
/// @param walls             the tank's walls and the bodies before
/// @param body              number of the body, from 0
/// @param outline           as placed at the start [m]
/// @param frame_origin      mass centre, in the coordinates of the outline
/// @param particle_spacing  [m]
/// @param support_radius    of the kernel [m]
///
/// Throws InputError where the body is thinner than the support: fluid would act through it.
void add_body_particles(WallParticles& walls, std::uint32_t body, const Outline& outline, Vec2 frame_origin,
                        double particle_spacing, double support_radius);

/// The same of a solid whose sides may lie on faces of the tank: there it has no surface of its own, and its
/// layers run on to the face.
void add_solid_particles(WallParticles& walls, std::uint32_t body, const Outline& outline, Vec2 frame_origin,
                         double particle_spacing, double support_radius, Box tank);

/// Removes the fluid inside the outline and closer to it than half a spacing. Before velocities and pressures
/// are set: what stays is laid anew, at rest and with new ids.
void clear_fluid(FluidParticles& fluid, const Outline& outline, double particle_spacing);

}  // namespace wetdeck
