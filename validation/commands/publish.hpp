// SPDX-License-Identifier: BSD-3-Clause
// Publishes the small tables and figures of a report in the repository.
#pragma once

#include <filesystem>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Writes TARGET/TIER/: README.md (what each scene reached, where the numbers come from, statistics, errors
/// and costs), runs.csv, values.csv, statistics.csv, scatter.csv, and of the figures of DIR those over all
/// scenes and of speed against error. Figures of an earlier publication in that folder are removed. DIR must
/// hold the report.
void publish(const Summary& summary, const std::filesystem::path& directory,
             const std::filesystem::path& target);

}  // namespace wetdeck
