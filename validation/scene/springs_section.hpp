// SPDX-License-Identifier: BSD-3-Clause
// [[body.springs]]: springs, dashpots, end stops and mooring lines between a body and the earth.
#pragma once

#include <vector>

#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// Reads the springs of a body's table into the body, whose pose and frame must be set. Throws InputError
/// "file:line: key ...: what was expected".
void read_springs(const TomlTable& table, BodySpec& spec);

}  // namespace wetdeck
