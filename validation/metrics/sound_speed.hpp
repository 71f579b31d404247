// SPDX-License-Identifier: BSD-3-Clause
// The sound speed as a model error. A quantity at a half, once and twice the sound speed c of its variant, at
// one spacing, is extrapolated along
//     f(c) = f_inf + a / c^2,
// the leading error of a weakly compressible fluid, by least squares; beside it stands the extrapolation in
// the spacing (convergence.hpp):
//     f(c -> inf, dx -> 0) = f(c, finest) - [f(c) - f_inf] - [f(finest) - f(dx -> 0)].
#pragma once

#include <utility>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// A value as the sound speed grows.
struct SoundSpeedFit {
    double limit = 0;        ///< f_inf
    double coefficient = 0;  ///< a [unit of the value m^2/s^2]
    double u_limit = 0;      ///< standard error of f_inf, from the scatter about the fit
};

/// By GSL. Throws std::invalid_argument for fewer than three pairs of sound speed [m/s] and value.
SoundSpeedFit fit_sound_speed(const std::vector<std::pair<double, double>>& values);

/// One row per variant that the scene studies and quantity that all three runs have; `study` holds the runs
/// at the other sound speeds, `runs` those of the suite, among them the one at the same spacing.
std::vector<SoundSpeedRow> sound_speed_rows(const AnalysisSpec& scene,
                                            const std::vector<SensitivityRun>& study,
                                            const std::vector<RunSummary>& runs,
                                            const std::vector<ConvergenceRow>& convergence);

}  // namespace wetdeck
