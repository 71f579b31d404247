// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck report`, and the lines that suite and verify end with as well.
#pragma once

#include <filesystem>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Prints where the report lies and what is outside its tolerance. Returns the exit code, 0 or 1.
int print_verdict(const Summary& summary, const std::filesystem::path& directory);

}  // namespace wetdeck
