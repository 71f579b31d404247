// SPDX-License-Identifier: BSD-3-Clause
// [symmetry] x = ...: a plane of symmetry in the middle of the tank. The scene stays whole; a run computes
// the half to the right of the plane.
#pragma once

#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// Reads the plane and checks that tank, fluids, bodies and their motions are symmetric about it. Probes may
/// lie on either half. Throws InputError "file:line: key 'symmetry.x': what is not symmetric".
void read_symmetry(const TomlTable& root, Scene& scene);

/// The half of the scene that is computed: tank and fluids end at the plane, bodies stay whole.
Scene right_half(const Scene& scene);

}  // namespace wetdeck
