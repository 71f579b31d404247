// SPDX-License-Identifier: BSD-3-Clause
// The tables of the report, as markup.
#pragma once

#include <string>
#include <vector>

#include "reports/figures/selection.hpp"
#include "reports/page/html.hpp"
#include "reports/page/report_inputs.hpp"

namespace wetdeck::report {

/// Of one scene.
std::string deviations_table(const AnalysisSpec& scene);
/// One row a key in which a scheme differs from that of the source, one column a variant that differs in any.
std::string schemes_table(const std::vector<SchemeRow>& rows);
std::string quantities_table(const AnalysisSpec& scene, const Runs& runs);
/// Empty without statements.
std::string statements_table(const Summary& summary, const AnalysisSpec& scene);
std::string comparison_tables(const Runs& runs);
std::string agreement_table(const Runs& runs);
/// Pressures of other codes, and of the finest run, against each measured pressure. Empty without either.
std::string peer_table(const Runs& runs);
std::string convergence_table(const Summary& summary, const AnalysisSpec& scene);
std::string curve_convergence_table(const Summary& summary, const AnalysisSpec& scene);
std::string validation_table(const Summary& summary, const AnalysisSpec& scene);
/// The same beside exact solutions and other computations; empty without any.
std::string verification_table(const Summary& summary, const AnalysisSpec& scene);
/// Empty without replicates.
std::string replicates_table(const Summary& summary, const AnalysisSpec& scene);
std::string sensitivity_table(const Summary& summary, const AnalysisSpec& scene);
/// Empty where the scene asks for no runs at several sound speeds.
std::string sound_speed_table(const Summary& summary, const AnalysisSpec& scene);
std::string ablation_table(const Summary& summary, const AnalysisSpec& scene);
std::string conservation_table(const Runs& runs);
/// Voids, mixed particles, enclosed air and fluid in bodies; empty where no run recorded them.
std::string phase_defects_table(const Runs& runs);
std::string cost_table(const Runs& runs, const AnalysisSpec& scene);
std::string references_table(const Runs& runs);
/// Files of reference curves that the scene has and does not compare with; empty without any.
std::string unused_references_table(const AnalysisSpec& scene);
std::string provenance_table(const Runs& runs);

/// Runs of all scenes that became unstable although nobody expects it or failed, and missing runs; empty
/// without any.
std::string incomplete_table(const Summary& summary);
/// Convergence of the quantities of each scene's default variant.
std::string convergence_overview(const Summary& summary);

/// Over all scenes; empty without rows. The cheapest run within an error, and other codes.
std::string cheapest_table(const Summary& summary);
std::string peer_points_table(const Summary& summary);

/// Cells and texts that several tables share.
/// Values and curves of a completed run that lie outside their tolerance or could not be computed.
std::size_t outside_count(const AnalysisSpec& scene, const RunSummary& run);
/// The largest part of the uncertainty as what would make it smaller: "finer spacing".
std::string what_would_help(const ValidationRow& row);
Cell status_cell(const RunRecord& record);
/// Empty where there is no reference to compare with; false also where the run ended too early.
std::optional<bool> verdict_of(const ComparisonResult& comparison);
/// Relative standard uncertainty of the reference: "5 %", "none" or "unknown".
std::string uncertainty_text(const ComparisonResult& comparison);
/// A kind of reference in words: "measurements", "other simulations ...".
std::string kind_name(std::optional<ReferenceKind> kind);

}  // namespace wetdeck::report
