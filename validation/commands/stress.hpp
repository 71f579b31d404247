// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck stress`: runs the hard cases and keeps what survived.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wetdeck {

struct StressOptions {
    std::vector<std::string> cases;  ///< all if empty
    std::filesystem::path directory;
    bool fast = false;  ///< the quick settings with the default scheme, no limits
    int jobs = 0;       ///< runs at a time; 0: one per core
};

/// Runs the cases, prints a table, writes DIR/stress.json and a picture of each death as
/// DIR/stress/CASE-SETTING.png. Results of other cases that the file holds stay.
/// @return whether the default scheme survived every sensible setting
bool run_stress(const StressOptions& options);

}  // namespace wetdeck
