// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the fields of a run, for the report.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/report.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// The frames nearest to the scene's picture times (frames further away than 2 % of the run are left out),
/// and of the default variant also frames at equal intervals. Colours: pressure of the water, speed of the
/// air.
std::vector<report::Picture> field_pictures(const Scene& scene, const RunRecord& record,
                                            const std::filesystem::path& run_directory);

/// The frame nearest to `time` [s], with the voids, mixed particles and penetration recorded with it in the
/// title; empty if none is within 2 % of the run.
std::optional<report::Picture> field_picture_at(const Scene& scene, const RunRecord& record,
                                                const std::filesystem::path& run_directory, double time);

}  // namespace wetdeck
