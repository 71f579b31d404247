// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck baseline`: the results of a directory in one file, small enough for the repository, to be compared
// with the results of later programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wetdeck {

/// Writes the quantities of interest and the compared curves of every finished run of DIR to `file`. An
/// existing file is only replaced if `replace`. Throws InputError where a run was made by a program whose
/// sources were changed or unknown: such a baseline could not be reproduced.
void write_baseline(const std::filesystem::path& directory, const std::filesystem::path& file, bool replace);

/// The deviations, one line each. Every run of the baseline must be in DIR and must have finished; of each
/// quantity |value - baseline| must be within its tolerance, of each curve the rms difference over the
/// baseline's range.
std::vector<std::string> compare_with_baseline(const std::filesystem::path& directory,
                                               const std::filesystem::path& file);

}  // namespace wetdeck
