// SPDX-License-Identifier: BSD-3-Clause
// One pair of numbers per class of quantity over all scenes: bias and scatter.
#include "validation/metrics/statistics.hpp"

#include <fmt/core.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "validation/metrics/curve_metrics.hpp"
#include "validation/metrics/judged_values.hpp"

namespace wetdeck {
namespace {

const std::map<std::string, std::string>& classes_by_unit() {
    static const std::map<std::string, std::string> classes{
        {"Pa", "pressure"},        {"N/m", "force"},
        {"N", "torque"},           {"m", "position"},
        {"rad", "angle"},          {"m/s", "velocity"},
        {"m/s^2", "acceleration"}, {"N s/m", "impulse"},
        {"J/m", "energy"},         {"rad/s", "angular velocity"}};
    return classes;
}

const Series* series_of(const RunSummary& run, const std::string& name) {
    const auto found = run.record.series.find(name);
    return found == run.record.series.end() ? nullptr : &found->second;
}

bool exact(const ScatterPoint& point) {
    return point.kind && describe(*point.kind).exact;
}

ScatterPoint point_of(const RunSummary& run) {
    ScatterPoint point;
    point.scene = run.record.scene;
    point.variant = run.record.variant;
    point.dx = run.record.particle_spacing;
    return point;
}

/// SI units per unit of the quantity.
struct SiScale {
    double factor;
    std::string unit;
};

SiScale si_scale(const QuantitySpec& spec, const std::string& unit) {
    switch (spec.metric->dimension) {
        case Dimension::series:
            break;
        case Dimension::abscissa:
            return {spec.x_scale, "s"};
        case Dimension::series_per_abscissa:
            return {spec.y_scale / spec.x_scale, unit + "/s"};
        case Dimension::series_times_abscissa:
            return {spec.y_scale * spec.x_scale, unit == "N/m" ? "N s/m" : unit + " s"};
    }
    return {spec.y_scale, unit};
}

std::optional<ScatterPoint> quantity_point(const QuantitySpec& spec, const RunSummary& run) {
    const auto result = std::find_if(run.quantities.begin(), run.quantities.end(),
                                     [&](const QuantityResult& q) { return q.name == spec.name; });
    const Series* series = series_of(run, spec.series);
    if (result == run.quantities.end() || !result->value || !spec.expected || series == nullptr ||
        spec.metric->is_error)
        return std::nullopt;
    ScatterPoint point = point_of(run);
    point.quantity = spec.name;
    point.quantity_class = quantity_class(spec.metric->dimension, series->unit);
    const SiScale si = si_scale(spec, series->unit);
    const double scale = si.factor;
    point.unit = si.unit;
    point.expected = *spec.expected * scale;
    point.predicted = *result->value * scale;
    point.against = spec.expected_source;
    point.kind = spec.expected_kind;
    if (spec.expected_uncertainty && spec.assumed_reason.empty() && *spec.expected != 0)
        point.u_data = *spec.expected_uncertainty / std::abs(*spec.expected);
    return point;
}

std::optional<ScatterPoint> curve_point(const ComparisonSpec& spec, const RunSummary& run,
                                        const ComparisonResult& c) {
    const Series* series = series_of(run, c.quantity);
    const char* const feature = judged_feature(c);
    const auto predicted = simulated_feature(c, feature), expected = reference_feature(c, feature);
    if (series == nullptr || !predicted || !expected) return std::nullopt;
    ScatterPoint point = point_of(run);
    point.quantity = fmt::format("{}, {}", c.quantity, feature);
    point.quantity_class = quantity_class(Dimension::series, series->unit);
    point.unit = series->unit;
    point.expected = (*expected + spec.y_offset) * spec.y_scale;
    point.predicted = (*predicted + spec.y_offset) * spec.y_scale;
    point.against = c.reference;
    point.kind = c.kind;
    if (c.reference_uncertainty && *expected != 0)
        point.u_data = c.reference_uncertainty->of(*expected) / std::abs(*expected);
    return point;
}

std::string reason_to_drop(const ScatterPoint& point) {
    if (!point.kind) return "the scene does not say what kind the expected value is";
    if (const std::string reason = describe(*point.kind).not_counted; !reason.empty()) return reason;
    if (!(point.predicted * point.expected > 0)) return "of another sign, or zero: no logarithm of the ratio";
    return "";
}

/// Those of one run, as scatter_points says.
std::vector<ScatterPoint> points_of(const AnalysisSpec& scene, const RunSummary& run) {
    std::vector<ScatterPoint> points;
    std::map<std::string, std::string> taken;  // series, class and kind, then the point that represents them
    for (const QuantitySpec& spec : scene.quantities) {
        if (auto point = quantity_point(spec, run)) {
            point->dropped = reason_to_drop(*point);
            if (point->dropped.empty())
                taken[spec.series + "|" + point->quantity_class + "|" + name_of(point->kind)] = spec.name;
            points.push_back(std::move(*point));
        }
    }
    for (std::size_t k = 0; k < scene.comparisons.size() && k < run.comparisons.size(); ++k) {
        const ComparisonResult& c = run.comparisons[k];
        auto point = curve_point(scene.comparisons[k], run, c);
        if (!point) continue;
        point->dropped = reason_to_drop(*point);
        if (point->dropped.empty()) {
            const std::string as_quantity =
                c.quantity + "|" + point->quantity_class + "|" + name_of(point->kind);
            const std::string as_record =
                as_quantity + "|" + c.citation + "|" + scene.comparisons[k].y_column;
            if (const auto found = taken.find(as_quantity); found != taken.end()) {
                point->dropped = fmt::format("'{}' stands for this series", found->second);
            } else if (!taken.emplace(as_record, c.reference).second) {
                point->dropped = fmt::format("another reading of '{}'", taken.at(as_record));
            }
        }
        points.push_back(std::move(*point));
    }
    for (ScatterPoint& point : points) {
        point.counted = point.dropped.empty();
        if (exact(point) && !point.u_data) point.u_data = 0;
    }
    return points;
}

/// Bias and scatter of points of one class against one kind of reference.
ClassStatistics statistics_of(const std::vector<const ScatterPoint*>& members) {
    ClassStatistics result;
    result.quantity_class = statistics_class(members.front()->quantity_class);
    result.against = *members.front()->kind;
    result.count = members.size();
    const auto n = static_cast<double>(members.size());
    double mean = 0, data_variance = 0, variance = 0;
    bool data_known = true;
    for (const ScatterPoint* p : members) {
        mean += std::log(p->predicted / p->expected) / n;
        data_known = data_known && p->u_data.has_value();
        if (p->u_data) data_variance += *p->u_data * *p->u_data / n;
    }
    for (const ScatterPoint* p : members) {
        const double off = std::log(p->predicted / p->expected) - mean;
        if (n > 1) variance += off * off / (n - 1);
    }
    if (data_known) result.sigma_data = std::sqrt(data_variance);
    double shift = 0;
    if (members.size() > 1) {
        result.scatter = std::sqrt(variance);
        if (data_known) {
            const double model_variance = std::max(0.0, variance - data_variance);
            result.sigma_model = std::sqrt(model_variance);
            shift = 0.5 * (model_variance - data_variance);
        }
        const double half = gsl_cdf_tdist_Pinv(0.975, n - 1) * std::sqrt(variance / n);
        result.bias_low = std::exp(mean + shift - half);
        result.bias_high = std::exp(mean + shift + half);
    }
    result.bias = std::exp(mean + shift);
    return result;
}

}  // namespace

std::string quantity_class(Dimension dimension, const std::string& series_unit) {
    const auto found = classes_by_unit().find(series_unit);
    const std::string name = found == classes_by_unit().end() ? "other" : found->second;
    switch (dimension) {
        case Dimension::series:
            break;
        case Dimension::abscissa:
            return "time";
        case Dimension::series_per_abscissa:
            return series_unit == "m" ? "velocity" : "slope of " + name;
        case Dimension::series_times_abscissa:
            return series_unit == "N/m" ? "impulse" : "integral of " + name;
    }
    return name;
}

std::string statistics_class(const std::string& quantity_class) {
    static const std::map<std::string, std::string> wider{
        {"position", "motion"},       {"velocity", "motion"},         {"angle", "motion"},
        {"acceleration", "motion"},   {"angular velocity", "motion"}, {"slope of force", "force"},
        {"slope of torque", "torque"}};
    const auto found = wider.find(quantity_class);
    return found == wider.end() ? quantity_class : found->second;
}

std::vector<ScatterPoint> scatter_points(const AnalysisSpec& scene, const std::vector<RunSummary>& runs) {
    std::vector<ScatterPoint> points;
    const auto add = [&](const RunSummary& finest, bool all) {
        for (ScatterPoint& point : points_of(scene, finest))
            if (all || exact(point)) points.push_back(std::move(point));
    };
    const std::map<std::string, SoundRuns> variants = sound_runs(scene, runs);
    if (const auto main = variants.find(scene.default_variant); main != variants.end())
        add(*main->second.back(), true);
    for (const auto& [variant, of_variant] : variants)
        if (variant != scene.default_variant) add(*of_variant.back(), false);
    return points;
}

void count_each_once(std::vector<ScatterPoint>& points) {
    std::map<std::tuple<std::string, std::string, double>, std::string> variants;
    for (ScatterPoint& point : points) {
        if (!point.counted) continue;
        const auto [first, is_new] = variants.emplace(
            std::tuple(point.scene, point.quantity + point.against, point.expected), point.variant);
        if (is_new) continue;
        point.counted = false;
        point.dropped = fmt::format("the variant '{}' stands for this value", first->second);
    }
}

std::vector<ClassStatistics> class_statistics(const std::vector<ScatterPoint>& points) {
    std::map<std::pair<ReferenceKind, std::string>, std::vector<const ScatterPoint*>> classes;
    for (const ScatterPoint& point : points)
        if (point.counted) classes[{*point.kind, statistics_class(point.quantity_class)}].push_back(&point);
    std::vector<ClassStatistics> all;
    for (const auto& [of, members] : classes) all.push_back(statistics_of(members));
    return all;
}

}  // namespace wetdeck
