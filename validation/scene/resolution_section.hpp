// SPDX-License-Identifier: BSD-3-Clause
// [resolution]: where particles are finest, and how their spacing grows from there.
#pragma once

#include "solver/setup/graded_lattice.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// [resolution] -> scene.resolution. After everything that it looks at: tank, water, bodies, symmetry. Throws
/// InputError where the scene cannot have differing spacings.
void read_resolution(const TomlTable& root, Scene& scene);

/// The grading of a scene that has one, with this finest spacing [m].
Grading grading_of(const Resolution& resolution, double finest);

/// Whether the currents that gravity drives where spacings differ, about 0.005 g t (docs/decisions.md), are
/// more than a thirtieth of the fastest motion that is expected, in words.
std::optional<std::string> doubtful_currents(const Scene& scene);

/// The coarsest spacing along a probe, as the scene is at the start [m].
double spacing_of(const Scene& scene, const Probe& probe, double finest);

/// The cells of the particles of a graded scene.
struct SceneCells {
    std::vector<Box> water;  ///< [m]
    std::vector<Box> above;  ///< of the air, or of the dry part of the tank, which walls need [m]
};
/// Throws InputError where the finest spacing does not fit.
SceneCells cells_of(const Scene& scene, double finest);

}  // namespace wetdeck
