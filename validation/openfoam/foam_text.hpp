// SPDX-License-Identifier: BSD-3-Clause
// Texts in the syntax of OpenFOAM.
#pragma once

#include <string>
#include <vector>

#include "solver/core/vec2.hpp"

namespace wetdeck {

/// The head that every file of OpenFOAM has.
/// @param kind  "dictionary", "volScalarField", "faceList" ...
std::string foam_head(const std::string& kind, const std::string& name);

/// "(x y z)"
std::string foam_vector(Vec2 v, double z = 0);

/// "nonuniform List<scalar> N ( ... )", or "uniform V" where all are equal.
std::string foam_scalars(const std::vector<double>& values);

}  // namespace wetdeck
