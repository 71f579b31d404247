// SPDX-License-Identifier: BSD-3-Clause
// The chapters of the report. Each adds to a page and is independent of the others.
#pragma once

#include <map>
#include <string>

#include "reports/figures/selection.hpp"
#include "reports/page/page.hpp"
#include "reports/page/report_inputs.hpp"

namespace wetdeck::report {

/// The first page: what each scene reached, what to look at next, where to find the rest. `scene_pages`:
/// addresses by scene.
void add_overview(Page& page, const Summary& summary, const ReportInputs& inputs,
                  const std::map<std::string, std::string>& scene_pages);
/// The library of cases: each with its picture, what it tests, against what, verdict and cost; bias and
/// scatter over all.
void add_library_part(Page& page, const Summary& summary, const ReportInputs& inputs,
                      const std::map<std::string, std::string>& scene_pages);
/// The worst results and what would improve most, as a list.
std::string next_steps(const Summary& summary, const std::map<std::string, std::string>& scene_pages);
/// Runs of a scene that became unstable or failed; values and curves outside tolerance.
void add_failures(Page& page, const AnalysisSpec& scene, const Runs& runs);
/// Verdicts of all scenes in one table.
void add_verdicts_part(Page& page, const Summary& summary);
/// This program beside other codes; nothing where no scene was run with one.
void add_codes_part(Page& page, const Summary& summary, const std::vector<ValidationRow>& rows);
/// Convergence of all scenes in one table.
void add_convergence_part(Page& page, const Summary& summary);
/// Speed against error, table of runs, revisions.
void add_cost_part(Page& page, const Summary& summary);
/// Bias and scatter of each class of quantities over all scenes.
void add_statistics_part(Page& page, const Summary& summary);
/// Problems with exact solutions, if any were run.
void add_verification_part(Page& page, const Summary& summary);
/// Hard cases, if any were run.
void add_stress_part(Page& page, const Summary& summary, const ReportInputs& inputs);
/// The page of one scene, from purpose to provenance.
void add_scene_part(Page& page, const Summary& summary, const AnalysisSpec& scene,
                    const ReportInputs& inputs);
/// Variants of a scene beside each other, as the scene asks for.
void add_side_by_side_part(Page& page, const AnalysisSpec& scene, const Runs& runs,
                           const ReportInputs& inputs);
/// Where the figures of each scene's source have their counterparts. Added last: it links to the others.
void add_source_figures_part(Pages& pages, const Summary& summary);

}  // namespace wetdeck::report
