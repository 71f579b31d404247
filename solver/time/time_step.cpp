// SPDX-License-Identifier: BSD-3-Clause
#include "solver/time/time_step.hpp"

#include <cmath>
#include <limits>

namespace wetdeck {

TimeStep stable_time_step(const Model& model, double smoothing_length,
                          const std::array<double, phase_count>& fastest, bool has_water, bool has_air) {
    const double h = smoothing_length;
    TimeStep step{std::numeric_limits<double>::infinity(), LimitingCriterion::force};
    const auto limit = [&step](double size, LimitingCriterion criterion) {
        if (size < step.size) step = {size, criterion};
    };
    const auto limit_by = [&](const Material& material, double speed, LimitingCriterion acoustic) {
        limit(model.courant_number * h / (material.eos.sound_speed + speed), acoustic);
        if (model.viscosity != Viscosity::none && material.viscosity > 0) {
            limit(0.125 * material.eos.reference_density * h * h / material.viscosity,
                  LimitingCriterion::viscous);
        }
    };
    if (has_water) limit_by(model.water, fastest[0], LimitingCriterion::acoustic_water);
    if (has_air) limit_by(model.air, fastest[1], LimitingCriterion::acoustic_air);
    const double g = model.gravity.norm();
    if (g > 0) limit(0.25 * std::sqrt(h / g), LimitingCriterion::force);
    return step;
}

}  // namespace wetdeck
