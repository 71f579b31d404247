// SPDX-License-Identifier: BSD-3-Clause
// Analysis of stored runs: all results that the report shows.
#pragma once

#include <filesystem>
#include <vector>

#include "validation/metrics/specification.hpp"
#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Evaluates every run (record and directory filled in by the caller) against the specification of its scene,
/// of which there may be one for each variant:
/// quantities, comparisons, energy and momentum error; then convergence per scene, variant and quantity over
/// the runs that ended well, and error against cost for the scenes that name an error quantity. References
/// are read from reference_directory/SCENE/. A run whose scene has no specification keeps its conservation
/// errors only. `sensitivity_runs` are runs with one input changed: they count for the input uncertainty
/// alone. `tier`, `ablation`, `stress` and `missing` are left to the caller. Throws InputError for a
/// specification, DataError for a reference file, that is not sound.
Summary analyse(const std::vector<AnalysisSpec>& scenes, std::vector<RunSummary> runs,
                const std::filesystem::path& reference_directory,
                std::vector<SensitivityRun> sensitivity_runs = {});

}  // namespace wetdeck
