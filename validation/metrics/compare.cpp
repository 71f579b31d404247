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

constexpr const char* no_peak = "has its largest value at an end, there is no peak to align";

/// Shifts the curve until its largest value is at zero and returns where that was; nothing, and no curve is
/// left, if it lies at an end.
std::optional<double> align_peak(Curve& curve) {
    const std::size_t top = curve.x.empty() ? 0 : index_of_maximum(curve);
    if (top == 0 || top + 1 == curve.x.size()) {
        curve = {};
        return std::nullopt;
    }
    const double peak = curve.x[top];
    for (double& x : curve.x) x -= peak;
    return peak;
}

/// Whether the reference could be aligned, as the series was; a note tells by how much both were shifted.
bool align_reference(ComparisonResult& result, double origin_of_series) {
    const std::optional<double> peak = align_peak(result.measured);
    add_note(result, peak ? fmt::format("aligned on the peaks, {:.4g} of the series and {:.4g} of the "
                                        "reference on their own axes",
                                        origin_of_series, *peak)
                          : fmt::format("the reference {}", no_peak));
    return peak.has_value();
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
    result.reference_uncertainty = found.u_data;
    result.assumed_uncertainty = found.u_data_assumed;
    if (const auto reason = found.reference->keys.find("u_data_assumed_reason");
        reason != found.reference->keys.end())
        result.assumed_reason = reason->second;
    result.abscissa_uncertainty = found.u_abscissa;
    result.reference_hash = found.reference->hash;
    if (found.empty_cells > 0)
        add_note(result,
                 fmt::format("{} empty cells of column '{}' left out", found.empty_cells, spec.y_column));
}

}  // namespace

SeriesCurve compared_series(const ComparisonSpec& spec, const RunRecord& record) {
    SeriesCurve series = series_curve(record, spec.quantity, spec);
    if (!spec.align_peaks || !series.problem.empty()) return series;
    const std::optional<double> peak = align_peak(series.curve);
    if (!peak) series.problem = fmt::format("series '{}' {}", spec.quantity, no_peak);
    series.origin = peak.value_or(0);
    return series;
}

ComparisonResult compare(const ComparisonSpec& spec, const RunRecord& record, ReferenceShelf& references) {
    ComparisonResult result;
    result.title = spec.title;
    result.quantity = spec.quantity;
    result.reference = spec.reference;
    result.tolerance = spec.tolerance;
    result.x_label = spec.x_label;
    result.y_label = spec.y_label;
    result.window = spec.window;
    result.judged = spec.judged;

    SeriesCurve series = compared_series(spec, record);
    result.simulated = std::move(series.curve);
    add_note(result, series.problem);

    take_reference(result, spec, references);
    if (!result.available) return result;
    if (!series.problem.empty()) return result;
    if (spec.align_peaks && !align_reference(result, series.origin)) return result;
    if (!spec.judged) {
        add_note(result, "shown, not judged");
        return result;
    }
    if (const auto window = comparison_window(result, record)) compute_metrics(result, *window);
    if (spec.align_peaks) result.time_error.reset();  // the alignment has taken it out
    return result;
}

}  // namespace wetdeck
