// SPDX-License-Identifier: BSD-3-Clause
// Mass and moment of inertia of a body.
#pragma once

#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// Reads `mass` or `density`, and `inertia`: that of even density over the outline unless the file knows
/// better, with Steiner's share for a mass centre beside the centroid. The freedom and the mass centre of the
/// body must be set.
/// @param moments  of the outline
/// Throws InputError where a body that is free to move has no mass, or two.
void read_mass(const TomlTable& table, const AreaMoments& moments, BodySpec& spec);

}  // namespace wetdeck
