// SPDX-License-Identifier: BSD-3-Clause
// Quantities of interest: one number from one series of a run.
#include "validation/metrics/quantities.hpp"

#include <fmt/core.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/analytic/curves.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

/// A number, or why there is none.
struct Outcome {
    std::optional<double> value;
    std::string note;
};

double mean_of(const Curve& curve, const std::function<double(double)>& f) {
    double integral = 0;
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
        integral += 0.5 * (f(curve.y[i - 1]) + f(curve.y[i])) * (curve.x[i] - curve.x[i - 1]);
    }
    return integral / (curve.x.back() - curve.x.front());
}

double integral(const Curve& curve) {
    return mean_of(curve, [](double y) { return y; }) * (curve.x.back() - curve.x.front());
}

double mean(const Curve& curve) {
    return mean_of(curve, [](double y) { return y; });
}

double standard_deviation(const Curve& curve) {
    const double centre = mean(curve);
    return std::sqrt(mean_of(curve, [centre](double y) { return (y - centre) * (y - centre); }));
}

double slope(const Curve& curve) {
    double intercept = 0, gradient = 0, cov00 = 0, cov01 = 0, cov11 = 0, residual = 0;
    gsl_fit_linear(curve.x.data(), 1, curve.y.data(), 1, curve.x.size(), &intercept, &gradient, &cov00,
                   &cov01, &cov11, &residual);
    return gradient;
}

double proportion(const Curve& curve) {
    double factor = 0, variance = 0, residual = 0;
    gsl_fit_mul(curve.x.data(), 1, curve.y.data(), 1, curve.x.size(), &factor, &variance, &residual);
    return factor;
}

Outcome first_crossing(const Curve& curve, const Window& window, double threshold) {
    const Curve part = clip(curve, window);
    for (std::size_t i = 1; i < part.x.size(); ++i) {
        const double below = part.y[i - 1];
        const double above = part.y[i];
        if (below >= threshold || above < threshold) continue;
        return {std::lerp(part.x[i - 1], part.x[i], (threshold - below) / (above - below)), {}};
    }
    return {{}, fmt::format("does not rise through {:.6g}", threshold)};
}

/// Integral up to where the curve has fallen from its maximum to `share` of it.
Outcome first_peak_integral(const Curve& curve, double share) {
    const std::size_t top = index_of_maximum(curve);
    const double low = share * curve.y[top];
    for (std::size_t i = top + 1; i < curve.x.size(); ++i) {
        if (curve.y[i] > low) continue;
        const double end =
            std::lerp(curve.x[i - 1], curve.x[i], (curve.y[i - 1] - low) / (curve.y[i - 1] - curve.y[i]));
        return {integral(clip(curve, {curve.x.front(), end})), {}};
    }
    return {{}, fmt::format("does not fall to {:.6g} of its peak within the window", share)};
}

Outcome value_at(const Curve& curve, double x) {
    if (x < curve.x.front() || x > curve.x.back()) {
        return {
            {},
            fmt::format("the series spans {:.6g} to {:.6g}, not {:.6g}", curve.x.front(), curve.x.back(), x)};
    }
    return {interpolate(curve, x), {}};
}

Outcome difference_to_reference(const QuantitySpec& spec, const Curve& curve, const Window& window,
                                ReferenceShelf& references) {
    const Reference* reference = references.find(spec.reference);
    if (reference == nullptr) return {{}, curve_not_available(spec.reference)};
    const std::string& x_column = reference->columns.front().name;
    const Curve measured = scaled_reference(*reference, x_column, spec.y_column, spec.x_scale, spec.y_scale);
    if (!covers(measured, window))
        return {{}, fmt::format("reference '{}' does not cover the window", spec.reference)};
    return {rms_difference(curve, measured, *overlap(curve, *overlap(measured, window))), {}};
}

void require(bool given, const QuantitySpec& spec, const char* key) {
    if (given) return;
    throw InputError(fmt::format("quantity '{}': metric {} needs '{}'", spec.name, spec.metric, key));
}

/// The metrics that map the part of the curve inside the window to a number.
const std::map<std::string, double (*)(const Curve&)>& window_metrics() {
    static const std::map<std::string, double (*)(const Curve&)> metrics{
        {"mean", mean},
        {"standard_deviation", standard_deviation},
        {"maximum", [](const Curve& c) { return c.y[index_of_maximum(c)]; }},
        {"time_of_maximum", [](const Curve& c) { return c.x[index_of_maximum(c)]; }},
        {"minimum", [](const Curve& c) { return *std::min_element(c.y.begin(), c.y.end()); }},
        {"slope", slope},
        {"proportion", proportion},
        {"integral", integral},
        {"change", [](const Curve& c) { return c.y.back() - c.y.front(); }}};
    return metrics;
}

void check(const QuantitySpec& spec) {
    const bool windowed = window_metrics().contains(spec.metric);
    const bool thresholded =
        spec.metric == "first_crossing" || spec.metric == "value_at" || spec.metric == "first_peak_integral";
    if (!windowed && !thresholded && spec.metric != "rms_difference") {
        throw InputError(
            fmt::format("quantity '{}': unknown metric '{}', expected mean, standard_deviation, maximum, "
                        "time_of_maximum, minimum, "
                        "slope, proportion, integral, change, first_crossing, value_at, first_peak_integral "
                        "or rms_difference",
                        spec.name, spec.metric));
    }
    if (thresholded) require(spec.threshold.has_value(), spec, "threshold");
    if (spec.metric == "rms_difference") {
        require(!spec.reference.empty(), spec, "reference");
        require(!spec.y_column.empty(), spec, "y_column");
    }
}

Outcome evaluate(const QuantitySpec& spec, const RunRecord& record, ReferenceShelf& references) {
    const SeriesCurve series = series_curve(record, spec.series, spec);
    if (!series.problem.empty()) return {{}, series.problem};
    const Curve& curve = series.curve;
    const Window window = spec.window.value_or(extent(curve));
    if (spec.metric == "first_crossing") return first_crossing(curve, window, *spec.threshold);
    if (spec.metric == "value_at") return value_at(curve, *spec.threshold);
    if (!covers(curve, window)) {
        return {{},
                fmt::format("the series spans {:.6g} to {:.6g}, the window {:.6g} to {:.6g}", curve.x.front(),
                            curve.x.back(), window.begin, window.end)};
    }
    if (spec.metric == "rms_difference") return difference_to_reference(spec, curve, window, references);
    if (spec.metric == "first_peak_integral")
        return first_peak_integral(clip(curve, window), *spec.threshold);
    return {window_metrics().at(spec.metric)(clip(curve, window)), {}};
}

}  // namespace

std::filesystem::path reference_file(const std::string& stem, const std::filesystem::path& own,
                                     const std::filesystem::path& directory) {
    const std::filesystem::path name = stem + ".csv";
    return !own.empty() && std::filesystem::exists(own / name) ? own / name : directory / name;
}

const Reference* ReferenceShelf::find(const std::string& stem) {
    auto found = files_.find(stem);
    if (found == files_.end()) {
        const std::filesystem::path path = reference_file(stem, own_, directory_);
        std::optional<Reference> reference;
        if (is_analytic(stem)) {
            reference = parse_reference(stem, analytic_reference(stem));
        } else if (std::filesystem::exists(path)) {
            reference = load_reference(path);
        }
        found = files_.emplace(stem, std::move(reference)).first;
    }
    return found->second ? &*found->second : nullptr;
}

std::string reference_hashes(const AnalysisSpec& scene, const std::filesystem::path& directory) {
    std::set<std::string> stems;
    for (const QuantitySpec& quantity : scene.quantities) stems.insert(quantity.reference);
    for (const ComparisonSpec& comparison : scene.comparisons) stems.insert(comparison.reference);
    stems.erase("");
    std::string out;
    for (const std::string& stem : stems) {
        const std::string hash = file_hash(reference_file(stem, scene.folder, directory));
        if (!hash.empty()) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", stem, hash);
    }
    return out;
}

std::string curve_not_available(const std::string& stem) {
    return fmt::format("curve not available: no file {}.csv", stem);
}

Curve scaled_reference(const Reference& reference, const std::string& x_column, const std::string& y_column,
                       double x_scale, double y_scale) {
    Curve curve = column_curve(reference, x_column, y_column);
    const double x_unit = find_column(reference, x_column).unit == "-" ? 1 : x_scale;
    const double y_unit = find_column(reference, y_column).unit == "-" ? 1 : y_scale;
    for (double& x : curve.x) x /= x_unit;
    for (double& y : curve.y) y /= y_unit;
    return curve;
}

QuantityResult evaluate_quantity(const QuantitySpec& spec, const RunRecord& record,
                                 ReferenceShelf& references) {
    check(spec);
    Outcome outcome = evaluate(spec, record, references);
    QuantityResult result;
    result.name = spec.name;
    result.unit = spec.unit;
    result.value = outcome.value;
    result.note = std::move(outcome.note);
    result.expected = spec.expected;
    result.tolerance = spec.tolerance;
    result.expected_source = spec.expected_source;
    if (result.value && result.expected && result.tolerance) {
        result.within = std::abs(*result.value - *result.expected) <= *result.tolerance;
    }
    return result;
}

}  // namespace wetdeck
