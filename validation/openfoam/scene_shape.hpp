// SPDX-License-Identifier: BSD-3-Clause
// Which of the meshes of shapes.hpp a scene fits.
#pragma once

#include <optional>
#include <string>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// The body of a scene that OpenFOAM computes at rest in a stream.
struct FoamBody {
    std::optional<double> deadrise;  ///< of a wedge [rad]; none: a rectangle with a flat bottom
    Box extent;                      ///< [m]
    Vec2 keel = Vec2::Zero();        ///< middle of the lowest side, or the corner [m]
    double side = 0;                 ///< length of a side from the keel [m]
    double speed = 0;                ///< downwards, constant [m/s]
};

/// None: a closed tank without bodies. Throws InputError in one line for a scene that fits no mesh.
std::optional<FoamBody> foam_body(const Scene& scene);

/// Throws InputError "SCENE cannot be written for OpenFOAM: WHY; supported are ...".
[[noreturn]] void refuse_for_foam(const Scene& scene, const std::string& why);

}  // namespace wetdeck
