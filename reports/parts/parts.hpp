// SPDX-License-Identifier: BSD-3-Clause
// The chapters of the report, in the order of the page. Each adds to the page and is independent of the
// others.
#pragma once

#include "reports/figures/selection.hpp"
#include "reports/page/page.hpp"
#include "reports/page/report_inputs.hpp"

namespace wetdeck::report {

/// Introduction and counts below the title.
std::string header_markup(const Summary& summary, const ReportInputs& inputs, const Page& page);
/// Runs that became unstable, failed or are missing; values and curves outside tolerance.
void add_failures(Page& page, const Summary& summary);
/// Verdicts of all scenes in one table.
void add_verdicts_part(Page& page, const Summary& summary);
/// Table of runs, suite statistics, speed against error, revisions.
void add_front_part(Page& page, const Summary& summary);
/// Bias and scatter of each class of quantities over all scenes.
void add_statistics_part(Page& page, const Summary& summary);
/// Problems with exact solutions, if any were run.
void add_verification_part(Page& page, const Summary& summary);
/// Hard cases, if any were run.
void add_stress_part(Page& page, const Summary& summary, const ReportInputs& inputs);
/// One scene, from purpose to provenance.
void add_scene_part(Page& page, const Summary& summary, const AnalysisSpec& scene,
                    const ReportInputs& inputs);
/// Variants of a scene beside each other, as the scene asks for.
void add_side_by_side_part(Page& page, const AnalysisSpec& scene, const Runs& runs,
                           const ReportInputs& inputs);
/// Where the figures of each scene's source have their counterparts. The last chapter: it links to the
/// others.
void add_source_figures_part(Page& page, const Summary& summary);

}  // namespace wetdeck::report
