// SPDX-License-Identifier: BSD-3-Clause
// Outlines of bodies, and the faces of bodies and tank on which probes lie.
//
// A face of a body is a run of sides of its outline whose directions differ by less than 10 degrees from that
// of the side in question: a straight side, or a curve drawn with short pieces.
#pragma once

#include <optional>
#include <string>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Where a point lies on the face nearest to it.
struct FacePlace {
    std::string name;      ///< "the floor", "the left wall", "the face"
    double distance;       ///< of the point from the face [m]
    Vec2 foot;             ///< nearest point of the face
    Vec2 along;            ///< unit vector along the face
    Vec2 normal;           ///< unit vector into the fluid
    double before, after;  ///< length of the face on either side of the point, against and along `along` [m]

    double to_end() const { return before < after ? before : after; }
};

/// Beyond it a point does not lie on a face, and a disc leaves it [m].
inline constexpr double face_tolerance = 1e-6;

/// How far from a face a probe is taken for one on it: the finest spacing of the scene's tiers [m].
double snapping_distance(const Scene& scene);

/// The smallest box around an outline.
Box extent_of(const Outline& outline);

/// Whether the corners of an outline follow each other with the body on the left.
bool counter_clockwise(const Outline& outline);

/// Of the floor, the roof and the two walls; `along` is the axis x or y.
FacePlace nearest_wall(const Box& tank, Vec2 point);

/// Of a body; `along` follows the order of the corners.
FacePlace nearest_face(const Outline& outline, Vec2 point);

/// Name of the body that never moves and covers the point, if there is one.
std::optional<std::string> covered_for_good(const Scene& scene, Vec2 point);

}  // namespace wetdeck
