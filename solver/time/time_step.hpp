// SPDX-License-Identifier: BSD-3-Clause
// The stable time step, Yang et al. (2020), Eq. (26), over both phases:
//     dt = min( C h/(c + v_max), 0.125 rho h^2 / mu, 0.25 sqrt(h/|g|) )
// The paper has C = 0.25; what the scheme bears is measured (see solver/README.md).
#pragma once

#include <array>

#include "solver/core/model.hpp"
#include "solver/core/particles.hpp"

namespace wetdeck {

enum class LimitingCriterion { acoustic_water, acoustic_air, viscous, force };
inline constexpr std::array limiting_criterion_names = {"acoustic_water", "acoustic_air", "viscous", "force"};

struct TimeStep {
    double size = 0;  ///< [s]
    LimitingCriterion criterion = LimitingCriterion::acoustic_water;
};

/// @param fastest  largest speed in water and in air [m/s]; a phase without particles does not limit
TimeStep stable_time_step(const Model& model, double smoothing_length,
                          const std::array<double, phase_count>& fastest, bool has_water, bool has_air);

}  // namespace wetdeck
