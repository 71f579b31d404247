// SPDX-License-Identifier: BSD-3-Clause
// The table [parameters] of a scene: numbers that its expressions use.
#pragma once

#include "validation/scene/expressions.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// A number, a text of a number and its unit, or an expression in the other parameters, in any order. Throws
/// InputError with file, line and key for anything else and for parameters that need each other.
Expressions read_parameters(const TomlTable& table);

}  // namespace wetdeck
