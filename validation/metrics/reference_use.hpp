// SPDX-License-Identifier: BSD-3-Clause
// Which reference files a scene uses: for comparisons, quantities and the figures of its source, or not at
// all.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "validation/metrics/specification.hpp"

namespace wetdeck {

/// Stems of the reference files, and names of the analytic curves, of all quantities and comparisons.
std::set<std::string> references_in_use(const AnalysisSpec& scene);

/// Stems of the files in `directory` that no variant uses and that no list of unused references names. Only
/// the specifications of all variants together give the answer for a scene.
std::set<std::string> unmentioned_references(const std::vector<AnalysisSpec>& variants,
                                             const std::filesystem::path& directory);

/// Sets `available` of the curves that the figures of the scene's source show.
void find_source_curves(AnalysisSpec& scene, const std::filesystem::path& directory);

}  // namespace wetdeck
