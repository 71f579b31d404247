// SPDX-License-Identifier: BSD-3-Clause
// The values of a run that have a verdict: its quantities, and the peak or the mean of each curve that is
// compared with a reference (judged_feature).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

struct JudgedValue {
    std::string name, unit;
    std::string against;                ///< who measured or computed
    std::optional<ReferenceKind> kind;  ///< empty if the scene does not say
    std::optional<double> simulated, reference;
    std::optional<double> u_data;    ///< standard (k = 1), in the unit
    std::string assumed_reason;      ///< of u_data; empty: it is stated
    std::optional<double> required;  ///< relative accuracy that the user asks for
};

/// Names are the same in every run of the scene. u_data of a curve's value holds the relative uncertainty of
/// the reference and, of a mean, that along the abscissa: moved by dx, the mean over a window changes by
/// dx (y(end) - y(begin))/(end - begin); a peak keeps its height.
std::vector<JudgedValue> judged_values(const AnalysisSpec& scene, const RunSummary& run);

/// Runs of one variant that count, coarse to fine.
using SoundRuns = std::vector<const RunSummary*>;

/// Those of the variants to which `scene` applies, by variant.
std::map<std::string, SoundRuns> sound_runs(const AnalysisSpec& scene, const std::vector<RunSummary>& runs);

}  // namespace wetdeck
