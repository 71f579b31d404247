// SPDX-License-Identifier: BSD-3-Clause
// Comparison of a series of a run with a reference curve.
#include "validation/metrics/compare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "validation/metrics/curve_metrics.hpp"
#include "validation/metrics/reference_curve.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

void add_note(ComparisonResult& result, const std::string& note) {
    if (note.empty()) return;
    result.note += (result.note.empty() ? "" : "; ") + note;
}

std::string spans(const char* who, const Curve& curve, const Window& window) {
    return fmt::format("{} spans {:.6g} to {:.6g}, the window is {:.6g} to {:.6g}", who, curve.x.front(),
                       curve.x.back(), window.begin, window.end);
}

/// Where the metrics are taken, or nothing with a note that says why there are none.
std::optional<Window> comparison_window(ComparisonResult& result, const RunRecord& record) {
    if (!result.window && record.status != RunStatus::ok) {
        add_note(result, "the run stopped early and the comparison has no window");
        return std::nullopt;
    }
    const Window wanted = result.window.value_or(extent(result.simulated));
    const auto known = overlap(result.measured, wanted);
    if (!known) {
        add_note(result, spans("the reference", result.measured, wanted));
        return std::nullopt;
    }
    if (result.window && !covers(result.measured, wanted))
        add_note(result, spans("the reference", result.measured, wanted));
    if (!covers(result.simulated, *known)) {
        add_note(result, spans("the series", result.simulated, *known));
        return std::nullopt;
    }
    return overlap(result.simulated, *known);
}

void compute_metrics(ComparisonResult& result, const Window& window) {
    const Curve simulated = clip(result.simulated, window);
    const Curve measured = clip(result.measured, window);
    result.features = curve_features(simulated, measured, window);
    result.agreement = curve_agreement(result.simulated, result.measured, window);
    const auto [lowest, highest] = std::minmax_element(measured.y.begin(), measured.y.end());
    const double range = *highest - *lowest;
    if (range <= 0) {
        add_note(result, "the reference is constant in the window, nothing to normalise with");
        return;
    }
    result.nrmse = rms_difference(result.simulated, result.measured, window) / range;
    result.within = *result.nrmse <= result.tolerance;
    const std::size_t s = index_of_maximum(simulated);
    const std::size_t m = index_of_maximum(measured);
    if (measured.y[m] != 0) result.peak_error = (simulated.y[s] - measured.y[m]) / std::abs(measured.y[m]);
    if (m > 0 && m + 1 < measured.x.size()) result.time_error = simulated.x[s] - measured.x[m];
}

void take_reference(ComparisonResult& result, const ComparisonSpec& spec, ReferenceShelf& references) {
    ReferenceCurve found = reference_curve(request_of(spec), references);
    result.available = found.problem.empty();
    result.unusable = found.unusable;
    add_note(result, found.problem);
    if (!result.available) return;
    result.measured = std::move(found.curve);
    result.kind = found.reference->kind;
    result.citation = found.reference->citation;
    result.reference_uncertainty = found.reference->u_data;
    result.reference_hash = found.reference->hash;
    if (found.empty_cells > 0)
        add_note(result,
                 fmt::format("{} empty cells of column '{}' left out", found.empty_cells, spec.y_column));
}

}  // namespace

ComparisonResult compare(const ComparisonSpec& spec, const RunRecord& record, ReferenceShelf& references) {
    ComparisonResult result;
    result.title = spec.title;
    result.quantity = spec.quantity;
    result.reference = spec.reference;
    result.tolerance = spec.tolerance;
    result.x_label = spec.x_label;
    result.y_label = spec.y_label;
    result.window = spec.window;

    SeriesCurve series = series_curve(record, spec.quantity, spec);
    result.simulated = std::move(series.curve);
    add_note(result, series.problem);

    take_reference(result, spec, references);
    if (!result.available) return result;
    if (!series.problem.empty()) return result;
    if (const auto window = comparison_window(result, record)) compute_metrics(result, *window);
    return result;
}

}  // namespace wetdeck
