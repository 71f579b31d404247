// SPDX-License-Identifier: BSD-3-Clause
#include "solver/time/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "solver/core/errors.hpp"

namespace wetdeck {

namespace {

/// A number of substeps that a model states.
int checked(int substeps, const std::string& name, const Model& model) {
    if (substeps < 1 || substeps % 2 == 0)
        throw InputError(name + " must be odd: the middle one sets the density of the slow fluid");
    if (substeps > 1 && model.dissipation_switch)
        throw InputError("the dissipation switch needs " + name + " = 1");
    return substeps;
}

}  // namespace

int air_substeps(const Model& model) {
    if (model.air_substeps != 0) return checked(model.air_substeps, "air_substeps", model);
    if (model.dissipation_switch) return 1;
    constexpr double room = 1.5, most = 15;
    const double ratio = model.air.eos.sound_speed / (room * model.water.eos.sound_speed);
    return 2 * static_cast<int>((std::clamp(ratio, 1.0, most) - 1) / 2) + 1;
}

int coarse_substeps(const Model& model, const std::vector<double>& finenesses) {
    if (model.coarse_substeps != 0) return checked(model.coarse_substeps, "coarse_substeps", model);
    if (model.dissipation_switch) return 1;
    constexpr double least_saving = 0.1;  // of the particle-steps: the slow fluid near the fast has a share
    const auto all = static_cast<double>(finenesses.size());
    double fewest = (1 - least_saving) * all;
    int best = 1;
    for (const int count : {3, 5, 7}) {
        const auto slow = static_cast<double>(std::count_if(finenesses.begin(), finenesses.end(),
                                                            [count](double f) { return f <= 1.0 / count; }));
        const double steps = all - slow + slow / count;  // in one of the fast
        if (steps < fewest) {
            fewest = steps;
            best = count;
        }
    }
    return best;
}

TimeStep stable_time_step(const Model& model, double smoothing_length, const Extremes& extremes,
                          bool has_water, bool has_air, int coarse_substeps) {
    constexpr double diffusion_share = 1.4;  // of the Courant number
    const double h = smoothing_length;
    TimeStep step{std::numeric_limits<double>::infinity(), LimitingCriterion::force};
    const auto limit = [&step](double size, LimitingCriterion criterion) {
        if (size < step.size) step = {size, criterion};
    };
    const auto limit_by = [&](Phase phase, int substeps, LimitingCriterion acoustic) {
        const auto k = static_cast<std::size_t>(phase);
        const Material& material = phase == Phase::water ? model.water : model.air;
        const double c0 = material.eos.sound_speed;
        const double c = c0 * std::pow(extremes.densest[k], 0.5 * (material.eos.exponent - 1));
        limit(substeps * model.courant_number * h / (c + extremes.fastest[k]), acoustic);
        if (model.pressure_diffusion > 0) {
            limit(substeps * diffusion_share * model.courant_number * h * c0 /
                      (model.pressure_diffusion * c * c),
                  LimitingCriterion::diffusion);
        }
        if (model.viscosity != Viscosity::none && material.viscosity > 0) {
            limit(substeps * 0.125 * material.eos.reference_density * h * h / material.viscosity,
                  LimitingCriterion::viscous);
        }
    };
    if (has_water) limit_by(Phase::water, coarse_substeps, LimitingCriterion::acoustic_water);
    const int substeps = has_water && has_air ? air_substeps(model) : 1;
    if (has_air) limit_by(Phase::air, substeps, LimitingCriterion::acoustic_air);
    const double g = model.gravity.norm();
    if (g > 0) limit(0.25 * std::sqrt(coarse_substeps * h / g), LimitingCriterion::force);
    return step;
}

TimeStep with_contact(TimeStep step, double frequency) {
    constexpr double share = 0.2;
    const bool limits = frequency > 0 && share / frequency < step.size;
    return limits ? TimeStep{share / frequency, LimitingCriterion::contact} : step;
}

TimeStep step_of(const Model& model, TimeStep stable) {
    if (!(model.fixed_step > 0)) return stable;
    const bool within = model.fixed_step <= stable.size;
    return {model.fixed_step, within ? LimitingCriterion::fixed : LimitingCriterion::fixed_beyond};
}

}  // namespace wetdeck
