// SPDX-License-Identifier: BSD-3-Clause
// Which fields of a run the report shows.
#pragma once

#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// The times at which the report looks for fields of a variant [s]: picture_times and, of the default
/// variant, equal intervals from the start, up to a dozen in all.
std::vector<double> wanted_pictures(const Scene& scene, const std::string& variant);

/// The frame_times of the scene's variant nearest to them, each once, rising [s].
std::vector<double> shown_frames(const Scene& scene);

}  // namespace wetdeck
