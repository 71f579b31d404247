// SPDX-License-Identifier: BSD-3-Clause
// A drawing of the set-up of a scene: tank, fluids, solids, bodies with the way that is given to them,
// springs, probes.
#pragma once

#include "validation/commands/drawing.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

Drawing sketch(const Scene& scene);

}  // namespace wetdeck
