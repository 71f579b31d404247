// SPDX-License-Identifier: BSD-3-Clause
// Comparison error and validation uncertainty in the sense of ASME V&V 20.
#include "validation/metrics/validation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/metrics/convergence.hpp"
#include "validation/metrics/curve_metrics.hpp"
#include "validation/metrics/verdict.hpp"

namespace wetdeck {
namespace {

/// A variant with fewer spacings is not judged, unless it is the scene's default.
constexpr std::size_t least_spacings = 3;

/// A simulated value and its reference, from a quantity or from a curve.
struct Item {
    std::string name, unit, against;
    std::optional<ReferenceKind> kind;
    std::optional<double> simulated, reference, u_data;
    bool u_data_assumed = false;
    std::optional<double> required;
};

bool error_measure(const AnalysisSpec& scene, const std::string& quantity) {
    return std::any_of(scene.quantities.begin(), scene.quantities.end(), [&](const QuantitySpec& spec) {
        return spec.name == quantity && spec.metric->is_error;
    });
}

/// A value of unknown kind is taken for a measurement; the report says that its kind is not stated.
bool counts_as_validation(std::optional<ReferenceKind> kind) {
    return !kind || describe(*kind).validates;
}

Item item_of(const AnalysisSpec& scene, const QuantityResult& q) {
    Item item{q.name, q.unit, q.expected_source, {}, q.value, q.expected, {}, false, {}};
    for (const QuantitySpec& spec : scene.quantities) {
        if (spec.name != q.name) continue;
        item.kind = spec.expected_kind;
        item.u_data = spec.expected_uncertainty;
        item.u_data_assumed = spec.uncertainty_assumed;
        item.required = spec.required;
    }
    return item;
}

/// Its series or, where the scene compares that with the reference more than once, its title: rows of one
/// name would take each other's values.
const std::string& distinct_name(const AnalysisSpec& scene, const ComparisonResult& c) {
    const auto alike = std::count_if(
        scene.comparisons.begin(), scene.comparisons.end(),
        [&](const ComparisonSpec& s) { return s.quantity == c.quantity && s.reference == c.reference; });
    return alike > 1 ? c.title : c.quantity;
}

Item item_of(const AnalysisSpec& scene, const ComparisonResult& c) {
    const bool peaked = reference_feature(c, "peak").has_value();
    const std::string feature = peaked ? "peak" : "mean";
    Item item{fmt::format("{}: {} against {}", distinct_name(scene, c), feature, c.reference),
              "-",
              c.title,
              c.kind,
              simulated_feature(c, feature),
              reference_feature(c, feature),
              {},
              !c.reference_uncertainty && c.assumed_uncertainty,
              {}};
    const auto relative = item.u_data_assumed ? c.assumed_uncertainty : c.reference_uncertainty;
    if (relative && item.reference) item.u_data = *relative * std::abs(*item.reference);
    return item;
}

std::vector<Item> items_of(const AnalysisSpec& scene, const RunSummary& run) {
    std::vector<Item> items;
    for (const QuantityResult& q : run.quantities) {
        if (!error_measure(scene, q.name)) items.push_back(item_of(scene, q));
    }
    for (const ComparisonResult& c : run.comparisons) {
        if (c.available) items.push_back(item_of(scene, c));
    }
    return items;
}

void set_numerical(ValidationRow& row, const std::map<double, double>& values) {
    const ConvergenceRow verified = convergence({values.begin(), values.end()});
    row.u_num = numerical_uncertainty(verified);
    row.u_num_source = verified.gci_fine ? "GCI / 2"
                       : row.u_num       ? verified.verdict + ": range of three spacings"
                                         : "unknown: fewer than three spacings";
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

/// What the study of a variant says of the quantity of a row; none without a study.
std::optional<double> input_uncertainty(const ValidationRow& row, const std::string& variant,
                                        const std::vector<SensitivityRow>& study) {
    double sum = 0;
    bool known = false;
    for (const SensitivityRow& each : study) {
        if (each.scene != row.scene || each.variant != variant || each.quantity != row.quantity) continue;
        known = true;
        sum += each.u_input * each.u_input;
    }
    return known ? std::optional(std::sqrt(sum)) : std::nullopt;
}

/// u_input of the row's own variant or, where that has no study, of the default variant.
void set_input(ValidationRow& row, const std::vector<SensitivityRow>& study, const AnalysisSpec& scene) {
    for (const std::string& variant : {row.variant, scene.default_variant}) {
        row.u_input = input_uncertainty(row, variant, study);
        if (!row.u_input) continue;
        row.u_input_variant = variant;
        return;
    }
}

/// Whether a judgement about an input counts in u_input.
bool assumes_inputs(const AnalysisSpec& scene) {
    return std::any_of(scene.sensitivities.begin(), scene.sensitivities.end(),
                       [](const SensitivitySpec& spec) { return spec.assumed; });
}

using Sound = std::vector<const RunSummary*>;  // by spacing, coarse to fine

std::map<std::string, Sound> sound_runs(const AnalysisSpec& scene, const std::vector<RunSummary>& runs) {
    std::map<std::string, Sound> variants;
    for (const RunSummary& run : runs) {
        if (applies(scene, run.record) && counts(run)) variants[run.record.variant].push_back(&run);
    }
    for (auto& entry : variants) {
        std::sort(entry.second.begin(), entry.second.end(), [](const auto* a, const auto* b) {
            return a->record.particle_spacing > b->record.particle_spacing;
        });
    }
    return variants;
}

std::map<double, double> values_by_spacing(const AnalysisSpec& scene, const Sound& runs,
                                           const std::string& name) {
    std::map<double, double> values;
    for (const RunSummary* run : runs) {
        for (const Item& item : items_of(scene, *run)) {
            if (item.name == name && item.simulated) values[run->record.particle_spacing] = *item.simulated;
        }
    }
    return values;
}

}  // namespace

std::vector<ValidationRow> validation_rows(const AnalysisSpec& scene, const std::vector<RunSummary>& runs,
                                           const std::vector<SensitivityRow>& sensitivity) {
    std::vector<ValidationRow> rows;
    for (const auto& [variant, sound] : sound_runs(scene, runs)) {
        for (const Item& item : items_of(scene, *sound.back())) {
            if (!item.simulated || !item.reference || !counts_as_validation(item.kind)) continue;
            if (variant != scene.default_variant && sound.size() < least_spacings) continue;
            ValidationRow row;
            row.scene = scene.scene;
            row.variant = variant;
            row.quantity = item.name;
            row.unit = item.unit;
            row.against = item.against;
            row.kind = item.kind;
            row.dx = sound.back()->record.particle_spacing;
            row.simulated = *item.simulated;
            row.reference = *item.reference;
            row.error = row.simulated - row.reference;
            set_numerical(row, values_by_spacing(scene, sound, item.name));
            row.u_data = item.u_data;
            if (item.u_data_assumed) row.assumed.push_back("u_data");
            set_input(row, sensitivity, scene);
            if (row.u_input && assumes_inputs(scene)) row.assumed.push_back("u_input");
            row.required = item.required;
            combine(row);
            conclude(row);
            rows.push_back(std::move(row));
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
        const std::vector<Item> at_high = items_of(scene, high->run);
        for (const Item& item : items_of(scene, low->run)) {
            const auto same = std::find_if(at_high.begin(), at_high.end(),
                                           [&](const Item& other) { return other.name == item.name; });
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
