// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/sound_speed.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "validation/metrics/convergence.hpp"

namespace wetdeck {
namespace {

const QuantityResult* quantity_of(const RunSummary& run, const std::string& name) {
    for (const QuantityResult& q : run.quantities)
        if (q.name == name) return &q;
    return nullptr;
}

/// Whether the scene studies the sound speed of a variant; an input of that key may be varied for u_input
/// alone.
bool studied(const AnalysisSpec& scene, const RunSummary& run) {
    const std::vector<std::string>& variants = scene.sound_speed_variants;
    return std::find(variants.begin(), variants.end(), run.record.variant) != variants.end();
}

/// The runs of one variant at one spacing by sound speed; empty unless there are three.
std::map<double, const RunSummary*> at_three_speeds(const AnalysisSpec& scene,
                                                    const std::vector<SensitivityRun>& study,
                                                    const std::vector<RunSummary>& runs) {
    std::map<double, const RunSummary*> by_speed;
    double spacing = 0;
    for (const SensitivityRun& each : study) {
        if (each.key != sound_speed_key || !applies(scene, each.run.record)) continue;
        if (each.run.record.status != RunStatus::ok || !studied(scene, each.run)) continue;
        by_speed[each.value] = &each.run;
        spacing = each.run.record.particle_spacing;
    }
    for (const RunSummary& run : runs)
        if (applies(scene, run.record) && counts(run) && run.record.particle_spacing == spacing)
            by_speed[scene.sound_speed] = &run;
    if (by_speed.size() < 3 || !by_speed.contains(scene.sound_speed)) by_speed.clear();
    return by_speed;
}

/// What the spacings of the suite add to a row.
void extrapolate_in_spacing(SoundSpeedRow& row, const std::vector<ConvergenceRow>& convergence) {
    for (const ConvergenceRow& each : convergence) {
        if (each.scene != row.scene || each.variant != row.variant || each.qoi != row.quantity) continue;
        row.finest_dx = each.dx.back();
        row.finest_value = each.value.back();
        row.u_num = numerical_uncertainty(each);
        if (each.extrapolated) row.spacing_part = row.finest_value - *each.extrapolated;
    }
    row.limit = row.finest_value - row.sound_part - row.spacing_part.value_or(0);
    if (row.u_num) row.u_limit = std::hypot(row.u_sound, *row.u_num);
}

}  // namespace

SoundSpeedFit fit_sound_speed(const std::vector<std::pair<double, double>>& values) {
    if (values.size() < 3) throw std::invalid_argument("a fit over the sound speed needs three of them");
    std::vector<double> x, y;
    for (const auto& [speed, value] : values) {
        x.push_back(1 / (speed * speed));
        y.push_back(value);
    }
    SoundSpeedFit fit;
    double variance_of_limit = 0, covariance = 0, variance_of_slope = 0, squares = 0;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &fit.limit, &fit.coefficient, &variance_of_limit,
                   &covariance, &variance_of_slope, &squares);
    fit.u_limit = std::sqrt(std::max(0.0, variance_of_limit));
    return fit;
}

std::vector<SoundSpeedRow> sound_speed_rows(const AnalysisSpec& scene,
                                            const std::vector<SensitivityRun>& study,
                                            const std::vector<RunSummary>& runs,
                                            const std::vector<ConvergenceRow>& convergence) {
    std::vector<SoundSpeedRow> rows;
    const std::map<double, const RunSummary*> by_speed = at_three_speeds(scene, study, runs);
    if (by_speed.empty()) return rows;
    const RunSummary& own = *by_speed.at(scene.sound_speed);
    for (const QuantityResult& q : own.quantities) {
        SoundSpeedRow row;
        row.scene = scene.scene;
        row.variant = own.record.variant;
        row.quantity = q.name;
        row.unit = q.unit;
        row.dx = own.record.particle_spacing;
        row.expected = q.expected;
        std::vector<std::pair<double, double>> values;
        for (const auto& [speed, run] : by_speed) {
            const QuantityResult* same = quantity_of(*run, q.name);
            if (same == nullptr || !same->value) continue;
            values.emplace_back(speed, *same->value);
            row.sound_speed.push_back(speed);
            row.value.push_back(*same->value);
        }
        if (values.size() < 3 || !q.value) continue;
        const SoundSpeedFit fit = fit_sound_speed(values);
        row.sound_part = fit.coefficient / (scene.sound_speed * scene.sound_speed);
        row.u_sound = fit.u_limit;
        extrapolate_in_spacing(row, convergence);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace wetdeck
