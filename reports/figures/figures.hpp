// SPDX-License-Identifier: BSD-3-Clause
// The figures of the report, made from the results of the analysis. `variant` is the place of a variant among
// those of its scene and chooses the hue.
#pragma once

#include <optional>
#include <vector>

#include "reports/figures/selection.hpp"
#include "reports/page/figure.hpp"

namespace wetdeck::report {

/// Curves over references: one variant by spacing, and all variants at their finest spacing.
std::vector<Figure> comparison_figures(const AnalysisSpec& scene, const Runs& runs_of_variant,
                                       std::size_t variant);
std::vector<Figure> variant_figures(const AnalysisSpec& scene, const Runs& runs);

/// Probes, and loads and motion of bodies, that the scene compares with nothing; series over an abscissa.
std::vector<Figure> history_figures(const AnalysisSpec& scene, const Runs& runs);
std::vector<Figure> profile_figures(const Runs& runs);

/// One series of the variants that the scene wants beside each other, scaled as in its first comparison.
Figure side_by_side_figure(const AnalysisSpec& scene, const SideBySide& entry, const Runs& runs);

/// Quantities over the spacing, and differences of whole curves between neighbouring spacings.
std::vector<Figure> convergence_figures(const Summary& summary, const AnalysisSpec& scene);
std::vector<Figure> curve_convergence_figures(const Summary& summary, const AnalysisSpec& scene);

/// Distribution functions of the replicates of the values that scatter most, beside their references.
std::vector<Figure> replicate_figures(const Summary& summary, const AnalysisSpec& scene);

/// Energies of one variant over time.
std::vector<Figure> energy_figures(const Runs& runs_of_variant, std::size_t variant);

/// Without series where no run has both a cost and an error.
Figure speed_error_figure(const Summary& summary, const AnalysisSpec& scene);

/// Predicted over measured values, one figure per class of quantities.
std::vector<Figure> scatter_figures(const Summary& summary);

/// Computed and exact curves of a problem, and its errors over resolution.
std::vector<Figure> verification_figures(const VerificationProblem& problem);

}  // namespace wetdeck::report
