// SPDX-License-Identifier: BSD-3-Clause
// A committed baseline: what the runs of a directory gave, small enough for the repository, to be compared
// with what later programs give.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wetdeck {

/// Writes the quantities of interest and the compared curves of every run of DIR that ended well to `file`.
/// An existing file is only replaced if `replace`. Throws InputError where a run was made by a program whose
/// sources were changed or unknown: nobody could make that baseline again.
void write_baseline(const std::filesystem::path& directory, const std::filesystem::path& file, bool replace);

/// What deviates, one line each; empty if nothing does. Every run of the baseline must be in DIR and have
/// ended well; of each quantity |value - baseline| must be within its tolerance, of each curve the rms
/// difference over the baseline's range.
std::vector<std::string> compare_with_baseline(const std::filesystem::path& directory,
                                               const std::filesystem::path& file);

}  // namespace wetdeck
