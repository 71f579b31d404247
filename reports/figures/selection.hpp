// SPDX-License-Identifier: BSD-3-Clause
// Order, names and colours of runs, the same everywhere in the report.
#pragma once

#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck::report {

using Runs = std::vector<const RunSummary*>;

/// False for a directory that holds verification problems or hard cases alone.
bool about_runs(const Summary& summary);

/// The scenes of the summary, then scenes that appear in the runs alone.
std::vector<AnalysisSpec> scenes_of(const Summary& summary);

/// The runs of a scene: default variant first, then by name; coarse to fine.
Runs runs_of(const Summary& summary, const AnalysisSpec& scene);

/// A run of a variant that the scene declares unstable: its instability is a result and no failure.
bool unstable_as_expected(const RunSummary& run);

/// Variants in the order of `runs`.
std::vector<std::string> variants_of(const Runs& runs);
Runs with_variant(const Runs& runs, const std::string& variant);

/// One run of each of these variants: at the finest spacing that all of them have, else each at its finest.
Runs side_by_side_runs(const Runs& runs, const SideBySide& entry);

/// The finest run of each variant.
Runs finest_of_each(const Runs& runs);
/// The finest run of the first variant that reached its end; null if there is none.
const RunSummary* finest_completed(const Runs& runs);

/// "0.01 m".
std::string spacing_text(double particle_spacing);
/// "tank, two-phase, dx = 0.01 m".
std::string run_name(const RunSummary& run);
/// An entry of the run's provenance; "unknown" if it is missing.
std::string provenance_of(const RunRecord& record, const std::string& key);
/// The commit of the program that made the run.
std::string revision_of(const RunSummary& run);
/// The unit of a quantity of the scene; "-" if the scene does not define it.
std::string unit_of_quantity(const AnalysisSpec& scene, const std::string& quantity);

/// Revisions of the runs (the first three by name), with compiler and processor of the first run.
std::string stamp_of(const Summary& summary);

/// One hue per variant; within it the finest spacing is the darkest.
std::string run_colour(std::size_t variant, std::size_t spacing, std::size_t spacings);
std::string variant_colour(std::size_t variant);

}  // namespace wetdeck::report
