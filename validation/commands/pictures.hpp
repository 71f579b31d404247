// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the fields of a run, for the report.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/report.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// A run with its scene, and where its field files lie.
struct PictureSource {
    const Scene& scene;
    const RunRecord& record;
    std::filesystem::path directory;
};

/// The frames nearest to the scene's picture times (frames further away than 2 % of the run are left out),
/// and of the default variant also frames at equal intervals. Colours: pressure of the water, speed of the
/// air, each from zero to what all but a few particles of these frames have; how many lie beyond is said in
/// the label of the colour bar.
std::vector<report::Picture> field_pictures(const PictureSource& run);

/// Of each run the frame nearest to `time` [s], all with the same colours, with the voids, mixed particles
/// and penetration recorded with it in the title; none for a run that has no frame within 2 % of its time.
std::vector<report::Picture> field_pictures_at(const std::vector<PictureSource>& runs, double time);

}  // namespace wetdeck
