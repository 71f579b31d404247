// SPDX-License-Identifier: BSD-3-Clause
// Whether the references that scenes name can be used, before anything is computed.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "validation/jobs/plan.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// Names of the references of the scene, as read for its variant, that do not exist. Throws InputError for
/// one that cannot be compared with its series (metrics/reference_check.hpp).
std::set<std::string> check_references(const Scene& scene);
/// The same of every scene and variant among the rows.
void check_references(const std::vector<SuiteRow>& rows);

}  // namespace wetdeck
