// SPDX-License-Identifier: BSD-3-Clause
// The probe of the water's front: its direction, and the range in which it looks.
#pragma once

#include "validation/scene/probe.hpp"

namespace wetdeck {

/// Keys `direction` (right if absent), `x_range`, `y_range`: two numbers each [m]. Throws InputError for a
/// range that the tank does not meet. Doubts a front that has arrived before the run starts.
Probe read_front(const TomlTable& table, const Scene& scene);

}  // namespace wetdeck
