// SPDX-License-Identifier: BSD-3-Clause
// [time_origins] of a scene file, and the origins that every run with a body finds.
//
//     [time_origins]
//     gate = 0.02                                    # a number [s], or "20 ms"
//     contact = "geometric_contact"                  # an event of the first body; "_2" of the second
//     keel_down = { series = "body_y", crosses = 1.05, direction = "falling" }   # or rising; either if left
//     out
#pragma once

#include <map>
#include <set>
#include <string>

#include "validation/metrics/specification.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {

/// The origins of a scene by name: those of the file, and first_contact and geometric_contact of its bodies.
/// @param series  names of the series that a run of the scene holds
std::map<std::string, TimeOrigin> read_time_origins(const TomlTable& root, const Scene& scene,
                                                    const std::vector<std::string>& series);

/// Geometric contact of each body of the scene.
std::vector<OriginEvent> geometric_contacts(const Scene& scene);

/// Key `x_origin` of a table, if it is there; of a profile only a number will do.
void read_x_origin(const TomlTable& table, const std::map<std::string, TimeOrigin>& origins,
                   SeriesScaling& scaling);

/// Names with "contact" of origins that are numbers, and that this variant uses or no variant does.
/// @param used  names that some variant uses
std::vector<std::string> stated_contacts(const AnalysisSpec& analysis, const std::set<std::string>& used);

}  // namespace wetdeck
