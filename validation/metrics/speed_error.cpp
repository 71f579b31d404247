// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/speed_error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "validation/metrics/reference_curve.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

constexpr const char* own_limit = "its extrapolated value";

/// The value without error, and where it comes from.
struct Target {
    double value = 0;
    std::string against;
};

std::optional<Target> target_of(const QuantityResult& result, const RunRecord& record,
                                const AnalysisSpec& scene, const std::vector<ConvergenceRow>& convergence) {
    if (result.expected)
        return Target{*result.expected,
                      result.expected_source.empty() ? "the expected value" : result.expected_source};
    for (const QuantitySpec& spec : scene.quantities) {
        if (spec.name == result.name && spec.metric->needs.reference)
            return Target{0, "the curve " + spec.reference};
    }
    for (const ConvergenceRow& row : convergence) {
        const bool same =
            row.scene == record.scene && row.variant == record.variant && row.qoi == result.name;
        if (same && row.extrapolated) return Target{*row.extrapolated, own_limit};
    }
    return std::nullopt;
}

/// Errors against the same value: an extrapolated value belongs to its own variant alone.
bool comparable(const SpeedErrorPoint& a, const SpeedErrorPoint& b) {
    return a.against == b.against && (a.against != own_limit || a.variant == b.variant);
}

bool beats(const SpeedErrorPoint& a, const SpeedErrorPoint& b) {
    if (!a.error || !comparable(a, b)) return false;
    const bool no_worse = a.core_s <= b.core_s && *a.error <= *b.error;
    return no_worse && (a.core_s < b.core_s || *a.error < *b.error);
}

/// Takes a run into the row if it is cheaper, or better, than what is there.
void take(CheapestRow& row, const RunSummary& run, double error) {
    const RunRecord& record = run.record;
    const SpeedErrorPoint point{record.scene, record.variant, record.particle_spacing, record.cost.core_s,
                                error};
    const auto cheaper = [&](std::optional<SpeedErrorPoint>& place) {
        if (!place || point.core_s < place->core_s) place = point;
    };
    if (error <= 0.05) cheaper(row.within_5);
    if (error <= 0.10) cheaper(row.within_10);
    if (!row.best || error < *row.best->error) row.best = point;
}

std::optional<double> key_number(const Reference& reference, const std::string& key) {
    const auto found = reference.keys.find(key);
    if (found == reference.keys.end()) return std::nullopt;
    double value = 0;
    const std::string& text = found->second;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool sound = error == std::errc{} && end == text.data() + text.size() && value > 0;
    return sound ? std::optional(value) : std::nullopt;
}

}  // namespace

std::vector<SpeedErrorPoint> speed_error_points(const std::vector<RunSummary>& runs,
                                                const AnalysisSpec& scene,
                                                const std::vector<ConvergenceRow>& convergence) {
    std::vector<SpeedErrorPoint> points;
    for (const RunSummary& run : runs) {
        const RunRecord& record = run.record;
        if (record.scene != scene.scene) continue;
        SpeedErrorPoint point{scene.scene, record.variant, record.particle_spacing, record.cost.core_s, {}};
        for (const QuantityResult& result : run.quantities) {
            if (result.name != scene.error_quantity || !result.value || !counts(run)) continue;
            const std::optional<Target> target = target_of(result, record, scene, convergence);
            if (!target) continue;
            point.relative = target->value != 0;
            const double scale = point.relative ? std::abs(target->value) : 1;
            point.error = std::abs(*result.value - target->value) / scale;
            point.against = target->against;
        }
        points.push_back(std::move(point));
    }
    for (SpeedErrorPoint& point : points) {
        point.pareto = point.error &&
                       std::none_of(points.begin(), points.end(),
                                    [&point](const SpeedErrorPoint& other) { return beats(other, point); });
    }
    return points;
}

std::vector<CheapestRow> cheapest_rows(const std::vector<RunSummary>& runs, const AnalysisSpec& scene) {
    std::vector<CheapestRow> rows;
    const auto row_of = [&](const std::string& quantity, const std::string& against) -> CheapestRow& {
        for (CheapestRow& row : rows) {
            if (row.quantity == quantity && row.against == against) return row;
        }
        rows.push_back({scene.scene, quantity, against, {}, {}, {}});
        return rows.back();
    };
    for (const RunSummary& run : runs) {
        if (run.record.scene != scene.scene || !counts(run)) continue;
        for (const QuantityResult& q : run.quantities) {
            if (!q.value || q.expected.value_or(0) == 0) continue;
            take(row_of(q.name, q.expected_source), run,
                 std::abs(*q.value - *q.expected) / std::abs(*q.expected));
        }
        for (const ComparisonResult& c : run.comparisons) {
            if (!c.available || !c.nrmse || c.kind == ReferenceKind::peer_simulation) continue;
            take(row_of("curve of " + c.quantity, c.title), run, *c.nrmse);
        }
    }
    return rows;
}

std::vector<PeerPoint> peer_points(const AnalysisSpec& scene, ReferenceShelf& references) {
    std::vector<PeerPoint> points;
    const auto error = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                    [&](const QuantitySpec& q) { return q.name == scene.error_quantity; });
    if (error == scene.quantities.end() || !error->metric->needs.reference || !error->window) return points;
    const ReferenceCurve measured = reference_curve(request_of(*error), references);
    if (!measured.problem.empty()) return points;
    const Curve& target = measured.curve;
    for (const ComparisonSpec& spec : scene.comparisons) {
        if (spec.quantity != error->series || spec.reference == error->reference) continue;
        const ReferenceCurve peer = reference_curve(request_of(spec), references);
        if (!peer.problem.empty() || peer.reference->kind != ReferenceKind::peer_simulation) continue;
        const Curve& curve = peer.curve;
        const auto common = overlap(target, *error->window);
        if (!common || !covers(curve, *common)) continue;
        const auto& keys = peer.reference->keys;
        const auto conditions = keys.find("cost_conditions");
        points.push_back({scene.scene, spec.title, error->reference,
                          rms_difference(curve, target, *overlap(curve, *common)),
                          key_number(*peer.reference, "cost_core_s"),
                          conditions == keys.end() ? "" : conditions->second});
    }
    return points;
}

}  // namespace wetdeck
