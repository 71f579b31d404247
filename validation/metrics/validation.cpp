// SPDX-License-Identifier: BSD-3-Clause
// Comparison error and validation uncertainty in the sense of ASME V&V 20.
#include "validation/metrics/validation.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/metrics/convergence.hpp"
#include "validation/metrics/judged_values.hpp"
#include "validation/metrics/replicates.hpp"
#include "validation/metrics/verdict.hpp"

namespace wetdeck {
namespace {

/// A variant with fewer spacings is not judged, unless it is the scene's default.
constexpr std::size_t least_spacings = 3;

using BySpacing = std::map<double, double>;

/// A value of unknown kind is taken for a measurement; the report says that its kind is not stated.
bool counts_as_validation(std::optional<ReferenceKind> kind) {
    return !kind || describe(*kind).validates;
}

/// Of the row's own variant or, where that has none, of the default variant.
const ReplicateRow* replicates_of(const ValidationRow& row, const AnalysisSpec& scene,
                                  const std::vector<ReplicateRow>& replicates) {
    for (const std::string& variant : {row.variant, scene.default_variant}) {
        for (const ReplicateRow& each : replicates)
            if (each.scene == row.scene && each.variant == variant && each.quantity == row.quantity)
                return &each;
    }
    return nullptr;
}

/// What the spacings differ by beyond what replicates do.
double excess_spread(const std::vector<double>& values, const ReplicateRow& replicates) {
    const double variance = gsl_stats_variance(values.data(), 1, values.size());
    return std::sqrt(std::max(0.0, variance - replicates.deviation * replicates.deviation));
}

std::string grid_source(const ConvergenceRow& row) {
    if (row.least_squares) return "least squares / 2";
    return row.gci_fine ? "GCI / 2" : row.verdict + ": range of three spacings";
}

void set_numerical(ValidationRow& row, const BySpacing& values, const ReplicateRow* replicates) {
    const ConvergenceRow verified = convergence({values.begin(), values.end()});
    row.u_grid = numerical_uncertainty(verified);
    row.u_num_source = row.u_grid ? grid_source(verified) : "unknown: fewer than three spacings";
    if (replicates != nullptr) {
        row.u_scatter = replicates->deviation;
        if (row.u_grid &&
            (verified.verdict == "oscillatory" || differ_as_replicates(verified.value, *replicates))) {
            row.u_grid = excess_spread(verified.value, *replicates);
            row.u_num_source = "spread over the spacings beyond that of replicates";
        }
    }
    if (row.u_grid) row.u_num = std::hypot(*row.u_grid, row.u_scatter.value_or(0));
}

void combine(ValidationRow& row) {
    double sum = 0;
    bool all = true;
    for (const auto& part : {row.u_num, row.u_input, row.u_data}) {
        sum += part ? *part * *part : 0;
        all = all && part.has_value();
    }
    row.u_known = std::sqrt(sum);
    if (!all) return;
    row.u_val = row.u_known;
    row.interval = {row.error - confidence * row.u_known, row.error + confidence * row.u_known};
}

/// u_input of the row's own variant or, where that has no study, of the default variant.
void set_input(ValidationRow& row, const std::vector<SensitivityRow>& study, const AnalysisSpec& scene) {
    for (const std::string& variant : {row.variant, scene.default_variant}) {
        double sum = 0, largest = -1;
        for (const SensitivityRow& each : study) {
            if (each.scene != row.scene || each.variant != variant || each.quantity != row.quantity) continue;
            sum += each.u_input * each.u_input;
            if (each.u_input <= largest) continue;
            largest = each.u_input;
            row.largest_input = each.key;
        }
        if (largest < 0) continue;
        row.u_input = std::sqrt(sum);
        row.u_input_variant = variant;
        return;
    }
}

/// Whether a judgement about an input counts in u_input.
bool assumes_inputs(const AnalysisSpec& scene) {
    return std::any_of(scene.sensitivities.begin(), scene.sensitivities.end(),
                       [](const SensitivitySpec& spec) { return spec.assumed; });
}

/// The values of all spacings, by name.
std::map<std::string, BySpacing> values_of(const AnalysisSpec& scene, const SoundRuns& runs) {
    std::map<std::string, BySpacing> values;
    for (const RunSummary* run : runs)
        for (const JudgedValue& value : judged_values(scene, *run))
            if (value.simulated) values[value.name][run->record.particle_spacing] = *value.simulated;
    return values;
}

/// A value of the finest run, its names and what is known without the other values.
ValidationRow row_of(const AnalysisSpec& scene, const RunRecord& finest, const JudgedValue& value) {
    ValidationRow row;
    row.scene = scene.scene;
    row.variant = finest.variant;
    row.quantity = value.name;
    row.unit = value.unit;
    row.against = value.against;
    row.kind = value.kind;
    row.dx = finest.particle_spacing;
    row.simulated = *value.simulated;
    row.reference = *value.reference;
    row.error = row.simulated - row.reference;
    row.required = value.required;
    row.u_data = value.u_data;
    row.assumed_reason = value.assumed_reason;
    if (!value.assumed_reason.empty()) row.assumed.emplace_back("u_data");
    return row;
}

}  // namespace

JudgedRows judged_rows(const AnalysisSpec& scene, const std::vector<RunSummary>& runs,
                       const InputStudies& studies) {
    JudgedRows rows;
    for (const auto& [variant, sound] : sound_runs(scene, runs)) {
        if (variant != scene.default_variant && sound.size() < least_spacings) continue;
        const std::map<std::string, BySpacing> values = values_of(scene, sound);
        for (const JudgedValue& value : judged_values(scene, *sound.back())) {
            if (!value.simulated || !value.reference) continue;
            const bool measured = counts_as_validation(value.kind);
            ValidationRow row = row_of(scene, sound.back()->record, value);
            set_numerical(row, values.at(value.name), replicates_of(row, scene, studies.replicates));
            if (measured) {
                set_input(row, studies.sensitivity, scene);
                if (row.u_input && assumes_inputs(scene)) row.assumed.emplace_back("u_input");
            } else {
                row.u_input = 0;
                if (describe(*row.kind).exact && !row.u_data) row.u_data = 0;
            }
            combine(row);
            conclude(row);
            (measured ? rows.validation : rows.agreement).push_back(std::move(row));
        }
    }
    return rows;
}

std::vector<SensitivityRow> sensitivity_rows(const AnalysisSpec& scene,
                                             const std::vector<SensitivityRun>& runs) {
    std::vector<SensitivityRow> rows;
    const auto run_at = [&](const std::string& key, double value) -> const SensitivityRun* {
        for (const SensitivityRun& each : runs) {
            const RunRecord& record = each.run.record;
            if (applies(scene, record) && each.key == key && each.value == value &&
                record.status == RunStatus::ok)
                return &each;
        }
        return nullptr;
    };
    for (const SensitivitySpec& spec : scene.sensitivities) {
        const SensitivityRun* low = run_at(spec.key, spec.low);
        const SensitivityRun* high = run_at(spec.key, spec.high);
        if (low == nullptr || high == nullptr) continue;
        const std::vector<JudgedValue> at_high = judged_values(scene, high->run);
        for (const JudgedValue& item : judged_values(scene, low->run)) {
            const auto same = std::find_if(at_high.begin(), at_high.end(),
                                           [&](const JudgedValue& other) { return other.name == item.name; });
            if (same == at_high.end() || !item.simulated || !same->simulated) continue;
            SensitivityRow row{scene.scene,      low->run.record.variant,
                               item.name,        item.unit,
                               spec.key,         low->run.record.particle_spacing,
                               spec.low,         spec.high,
                               spec.uncertainty, *item.simulated,
                               *same->simulated, 0};
            row.u_input = std::abs((row.value_high - row.value_low) / (spec.high - spec.low)) *
                          std::abs(spec.uncertainty);
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

}  // namespace wetdeck
