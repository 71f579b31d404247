// SPDX-License-Identifier: BSD-3-Clause
// Which of the meshes of shapes.hpp a scene fits.
#pragma once

#include <optional>
#include <string>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// The body of a scene that OpenFOAM computes at rest in a stream.
struct FoamBody {
    enum class Shape {
        plate,   ///< a rectangle with a flat bottom, in the middle of the tank
        wedge,   ///< upright, its sides straight up to its beam, in the middle of the tank
        section  ///< any other
    };
    Shape shape = Shape::section;
    double deadrise = 0;       ///< of a wedge [rad]
    double side = 0;           ///< of a wedge: length of a side from the keel [m]
    Box extent;                ///< [m]
    Vec2 keel = Vec2::Zero();  ///< middle of the lowest side, or the lowest corner [m]
    double speed = 0;          ///< downwards, constant [m/s]
    bool flat = false;         ///< a section whose bottom is flatter than 4 degrees over a tenth of the beam
    bool hollow = false;       ///< a section whose underside shuts in air
};

/// None: a closed tank without bodies. Throws InputError in one line for a scene that fits no mesh.
std::optional<FoamBody> foam_body(const Scene& scene);

/// Throws InputError "SCENE cannot be written for OpenFOAM: WHY; supported are ...".
[[noreturn]] void refuse_for_foam(const Scene& scene, const std::string& why);

}  // namespace wetdeck
