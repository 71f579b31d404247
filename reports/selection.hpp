// SPDX-License-Identifier: BSD-3-Clause
// Runs in the order of the report, and the names and colours by which they are known throughout.
#pragma once

#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck::report {

using Runs = std::vector<const RunSummary*>;

/// Not of verification problems or hard cases alone: then there is nothing to say of runs.
bool about_runs(const Summary& summary);

/// The scenes of the summary, then those that only runs name.
std::vector<AnalysisSpec> scenes_of(const Summary& summary);

/// The runs of a scene: default variant first, then by name; coarse to fine.
Runs runs_of(const Summary& summary, const AnalysisSpec& scene);

/// Variants in the order of `runs`.
std::vector<std::string> variants_of(const Runs& runs);
Runs with_variant(const Runs& runs, const std::string& variant);

/// The runs that are the finest of their variant.
Runs finest_of_each(const Runs& runs);

/// "0.01 m".
std::string spacing_text(double particle_spacing);
/// "dam_break, two-phase, dx = 0.01 m".
std::string run_name(const RunSummary& run);
/// The commit a run was made by, "unknown" if it does not say.
std::string revision_of(const RunSummary& run);

/// Every revision of the runs (the first three by name), with compiler and processor of the first.
std::string stamp_of(const Summary& summary);

/// One hue per variant; within it the finest spacing is the darkest.
std::string run_colour(std::size_t variant, std::size_t spacing, std::size_t spacings);
std::string variant_colour(std::size_t variant);

}  // namespace wetdeck::report
