// SPDX-License-Identifier: BSD-3-Clause
// Figures of a body that follow from the scene alone: how it floats, and the numbers of its entry.
#pragma once

#include <optional>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// What is unknown or does not apply is empty.
struct BodyFigures {
    double area = 0;                     ///< inside the outline and those joined to it [m^2]
    double beam = 0;                     ///< breadth over all of these, as placed [m]
    std::optional<double> draught;       ///< of the body floating at rest with the angle of the start [m]
    std::optional<double> heave_period;  ///< 2 pi sqrt((M + a) / (rho g b)), b the breadth of its waterline
                                         ///< and a = rho pi b^2 / 8 the added mass of fast heave of a deep
                                         ///< semicircle [s]
    std::optional<double> speed;     ///< with which it meets the water, or the largest that is given [m/s]
    std::optional<double> froude;    ///< speed / sqrt(g beam)
    std::optional<double> reynolds;  ///< rho speed beam / mu, for a water with viscosity
    std::optional<double> mach;      ///< speed over the sound speed of the water of the scene
    std::optional<double> first_contact;  ///< time at which it meets the water [s]
};

BodyFigures body_figures(const Scene& scene, const BodySpec& spec);

}  // namespace wetdeck
