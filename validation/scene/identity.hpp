// SPDX-License-Identifier: BSD-3-Clause
// What makes two runs the same: the resolved set-up and the revision of the scheme. Labels, tolerances,
// tiers, references and other variants do not count.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Every model ingredient and number by its dotted key, defaults included: a flat object.
nlohmann::json parameters_json(const Scene& scene);

/// Everything that decides the results of a run but its spacing and end: parameters, geometry, bodies,
/// initial pressure, probes, sampling, and the revision of the scheme.
nlohmann::json setup_json(const Scene& scene);

/// A hash of setup_json(). Runs of one variant belong together only if they have the same.
std::string setup_identity(const Scene& scene);

}  // namespace wetdeck
