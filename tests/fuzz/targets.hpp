// SPDX-License-Identifier: BSD-3-Clause
// What the fuzz targets and the test of their cases share: one function per kind of file, which either reads
// the bytes or refuses them with DataError or InputError. Anything else is a fault of the reader.
#pragma once

#include <map>
#include <string>

namespace wetdeck::fuzz {

/// Returns whether the bytes were read.
using Target = bool (*)(const std::string& bytes);
/// By the name of the target and of its folder of cases.
const std::map<std::string, Target>& targets();

}  // namespace wetdeck::fuzz
