// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/judged_values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "validation/metrics/curve_metrics.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

const QuantitySpec* find_spec(const AnalysisSpec& scene, const std::string& quantity) {
    const auto found = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                    [&](const QuantitySpec& spec) { return spec.name == quantity; });
    return found == scene.quantities.end() ? nullptr : &*found;
}

JudgedValue value_of(const QuantitySpec* spec, const QuantityResult& q) {
    JudgedValue value{q.name, q.unit, q.expected_source, {}, q.value, q.expected, {}, {}, {}};
    if (spec == nullptr) return value;
    value.kind = spec->expected_kind;
    value.u_data = spec->expected_uncertainty;
    value.assumed_reason = spec->assumed_reason;
    value.required = spec->required;
    return value;
}

/// Its series and reference or, where the scene compares these more than once, its title: rows of one name
/// would take each other's values.
std::string name_of(const AnalysisSpec& scene, const ComparisonResult& c, std::string_view feature) {
    const auto alike = std::count_if(
        scene.comparisons.begin(), scene.comparisons.end(),
        [&](const ComparisonSpec& s) { return s.quantity == c.quantity && s.reference == c.reference; });
    return alike > 1 ? fmt::format("{}: {}", c.title, feature)
                     : fmt::format("{}: {} against {}", c.quantity, feature, c.reference);
}

/// Of the reference's mean over the window, for the uncertainty along its abscissa.
double shifted_mean(const ComparisonResult& c) {
    if (!c.abscissa_uncertainty) return 0;
    const auto window = overlap(c.measured, c.window.value_or(extent(c.simulated)));
    if (!window) return 0;
    const Curve part = clip(c.measured, *window);
    return *c.abscissa_uncertainty * std::abs(part.y.back() - part.y.front()) /
           (part.x.back() - part.x.front());
}

std::optional<double> required_accuracy(const AnalysisSpec& scene, const std::string& title) {
    const auto found = std::find_if(scene.comparisons.begin(), scene.comparisons.end(),
                                    [&](const ComparisonSpec& spec) { return spec.title == title; });
    return found == scene.comparisons.end() ? std::nullopt : found->required;
}

JudgedValue value_of(const AnalysisSpec& scene, const ComparisonResult& c) {
    const std::string_view feature = judged_feature(c);
    const bool peaked = feature == "peak";
    JudgedValue value{name_of(scene, c, feature),
                      "-",
                      c.title,
                      c.kind,
                      simulated_feature(c, std::string(feature)),
                      reference_feature(c, std::string(feature)),
                      {},
                      {},
                      required_accuracy(scene, c.title)};
    const auto stated = c.reference_uncertainty ? c.reference_uncertainty : c.assumed_uncertainty;
    if (!stated || !value.reference) return value;
    if (!c.reference_uncertainty) value.assumed_reason = c.assumed_reason;
    value.u_data = std::hypot(stated->of(*value.reference), peaked ? 0 : shifted_mean(c));
    return value;
}

}  // namespace

std::vector<JudgedValue> judged_values(const AnalysisSpec& scene, const RunSummary& run) {
    std::vector<JudgedValue> values;
    for (const QuantityResult& q : run.quantities) {
        const QuantitySpec* spec = find_spec(scene, q.name);
        if (spec != nullptr && spec->metric->is_error) continue;
        values.push_back(value_of(spec, q));
    }
    for (const ComparisonResult& c : run.comparisons) {
        if (c.available) values.push_back(value_of(scene, c));
    }
    return values;
}

std::map<std::string, SoundRuns> sound_runs(const AnalysisSpec& scene, const std::vector<RunSummary>& runs) {
    std::map<std::string, SoundRuns> variants;
    for (const RunSummary& run : runs)
        if (applies(scene, run.record) && counts(run)) variants[run.record.variant].push_back(&run);
    for (auto& entry : variants) {
        std::sort(entry.second.begin(), entry.second.end(), [](const auto* a, const auto* b) {
            return a->record.particle_spacing > b->record.particle_spacing;
        });
    }
    return variants;
}

}  // namespace wetdeck
