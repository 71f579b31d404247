// SPDX-License-Identifier: BSD-3-Clause
// The parts of the report, in the order of the page. Each adds to the page and knows nothing of the others.
#pragma once

#include "reports/html.hpp"
#include "reports/page.hpp"
#include "reports/report.hpp"
#include "reports/selection.hpp"

namespace wetdeck::report {

/// Counts and words below the title.
std::string header_markup(const Summary& summary, const ReportInputs& inputs, const Page& page);
/// Runs that died or are missing; values and curves outside tolerance.
void add_failures(Page& page, const Summary& summary);
/// Table of runs, suite statistics, speed against error, revisions.
void add_front_part(Page& page, const Summary& summary);
/// Bias and scatter of each class of quantities over all scenes.
void add_statistics_part(Page& page, const Summary& summary);
/// Hard cases, if any were run.
void add_stress_part(Page& page, const Summary& summary, const ReportInputs& inputs);
/// Where each figure of the paper has its counterpart. Comes last: it links what the page has by then.
void add_paper_part(Page& page, const Summary& summary);

/// Problems with exact solutions, where the directory holds any.
void add_verification_part(Page& page, const Summary& summary);

/// One scene, from purpose to provenance.
void add_scene_part(Page& page, const Summary& summary, const AnalysisSpec& scene,
                    const ReportInputs& inputs);

/// Tables of a scene (markup).
std::string deviations_table(const AnalysisSpec& scene);
std::string quantities_table(const Runs& runs);
std::string comparison_tables(const Runs& runs);
std::string convergence_table(const Summary& summary, const AnalysisSpec& scene);
std::string curve_convergence_table(const Summary& summary, const AnalysisSpec& scene);
std::string agreement_table(const Runs& runs);
std::string validation_table(const Summary& summary, const AnalysisSpec& scene);
std::string sensitivity_table(const Summary& summary, const AnalysisSpec& scene);
std::string ablation_table(const Summary& summary, const AnalysisSpec& scene);
std::string cost_table(const Runs& runs, const AnalysisSpec& scene);
std::string provenance_table(const Runs& runs);
std::string references_table(const Runs& runs);
/// Pressures of other codes, and of the finest run, against each measured pressure. Empty without either.
std::string peer_table(const Runs& runs);
/// Over all scenes: what an accuracy costs, here and elsewhere. Empty without rows.
std::string cheapest_table(const Summary& summary);
std::string peer_points_table(const Summary& summary);
/// The field pictures of a run: a grid, which the script of the page turns into a player.
std::string picture_player(const std::vector<Picture>& pictures);

/// Figures of a scene. `variant` is its place among the scene's variants and chooses the hue.
std::vector<Figure> comparison_figures(const AnalysisSpec& scene, const Runs& runs_of_variant,
                                       std::size_t variant);
std::vector<Figure> variant_figures(const AnalysisSpec& scene, const Runs& runs);
std::vector<Figure> convergence_figures(const Summary& summary, const AnalysisSpec& scene);
std::vector<Figure> curve_convergence_figures(const Summary& summary, const AnalysisSpec& scene);
/// Loads and motion of bodies that the scene compares with nothing; series over an abscissa.
std::vector<Figure> body_figures(const Runs& runs);
std::vector<Figure> profile_figures(const Runs& runs);
Figure speed_error_figure(const Summary& summary, const AnalysisSpec& scene);

/// Energies and other balances.
std::vector<Figure> energy_figures(const Runs& runs_of_variant, std::size_t variant);
std::string conservation_table(const Runs& runs);

/// Empty where there is no reference to compare with; false also where the run did not get far enough.
std::optional<bool> verdict_of(const ComparisonResult& comparison);
Cell status_cell(const RunRecord& record);

/// The part of a comparison's title that names the reference, "Buchner (2002), first digitisation"; the stem
/// of the file where that is too long for a legend.
std::string reference_name(const std::string& title, const std::string& stem);
/// Of the reference: relative, one standard deviation.
std::string uncertainty_text(const ComparisonResult& comparison);
/// Empty if no time was taken.
std::optional<double> particle_rate(const RunCost& cost);

/// "measurements", "other simulations ...", ... as written for readers.
std::string kind_name(std::optional<ReferenceKind> kind);

}  // namespace wetdeck::report
