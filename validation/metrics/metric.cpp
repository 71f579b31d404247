// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/metric.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

double integral_of(const Curve& curve) {
    return average(curve) * (curve.x.back() - curve.x.front());
}

MetricResult mean(const MetricInput& in) {
    return {average(in.part), {}};
}

MetricResult standard_deviation(const MetricInput& in) {
    const double centre = average(in.part);
    Curve squares = in.part;
    for (double& y : squares.y) y = (y - centre) * (y - centre);
    return {std::sqrt(average(squares)), {}};
}

MetricResult maximum(const MetricInput& in) {
    return {in.part.y[index_of_maximum(in.part)], {}};
}

MetricResult time_of_maximum(const MetricInput& in) {
    return {in.part.x[index_of_maximum(in.part)], {}};
}

MetricResult minimum(const MetricInput& in) {
    return {*std::min_element(in.part.y.begin(), in.part.y.end()), {}};
}

MetricResult slope(const MetricInput& in) {
    const Curve& c = in.part;
    double intercept = 0, gradient = 0, cov00 = 0, cov01 = 0, cov11 = 0, residual = 0;
    gsl_fit_linear(c.x.data(), 1, c.y.data(), 1, c.x.size(), &intercept, &gradient, &cov00, &cov01, &cov11,
                   &residual);
    return {gradient, {}};
}

MetricResult proportion(const MetricInput& in) {
    const Curve& c = in.part;
    double factor = 0, variance = 0, residual = 0;
    gsl_fit_mul(c.x.data(), 1, c.y.data(), 1, c.x.size(), &factor, &variance, &residual);
    return {factor, {}};
}

MetricResult first_crossing(const MetricInput& in) {
    const Curve& c = in.part;
    for (std::size_t i = 1; i < c.x.size(); ++i) {
        const double below = c.y[i - 1], above = c.y[i];
        if (below >= in.threshold || above < in.threshold) continue;
        std::string note;
        if (c.y.front() >= in.threshold)
            note = fmt::format("starts above {:.6g}, and falls through it before it rises", in.threshold);
        return {std::lerp(c.x[i - 1], c.x[i], (in.threshold - below) / (above - below)), note};
    }
    return {{}, fmt::format("does not rise through {:.6g}", in.threshold)};
}

MetricResult value_at(const MetricInput& in) {
    const double begin = in.series.x.front(), end = in.series.x.back();
    if (in.threshold < begin || in.threshold > end)
        return {{}, fmt::format("the series spans {:.6g} to {:.6g}, not {:.6g}", begin, end, in.threshold)};
    return {interpolate(in.series, in.threshold), {}};
}

MetricResult difference_to_reference(const MetricInput& in) {
    return {rms_difference(in.series, in.reference, *overlap(in.series, *overlap(in.reference, in.window))),
            {}};
}

MetricResult largest_difference(const MetricInput& in) {
    std::optional<double> largest;
    for (std::size_t i = 0; i < in.reference.x.size(); ++i) {
        const double x = in.reference.x[i];
        if (x < in.window.begin || x > in.window.end) continue;
        if (x < in.series.x.front() || x > in.series.x.back()) continue;
        largest = std::max(largest.value_or(0), std::abs(interpolate(in.series, x) - in.reference.y[i]));
    }
    if (!largest) return {{}, "no point of the reference lies in the window"};
    return {largest, {}};
}

MetricResult integral(const MetricInput& in) {
    return {integral_of(in.part), {}};
}

MetricResult change(const MetricInput& in) {
    return {in.part.y.back() - in.part.y.front(), {}};
}

MetricResult first_peak_integral(const MetricInput& in) {
    const Curve& c = in.part;
    const std::size_t top = index_of_maximum(c);
    const double low = in.threshold * c.y[top];
    for (std::size_t i = top + 1; i < c.x.size(); ++i) {
        if (c.y[i] > low) continue;
        const double end = std::lerp(c.x[i - 1], c.x[i], (c.y[i - 1] - low) / (c.y[i - 1] - c.y[i]));
        return {integral_of(clip(c, {c.x.front(), end})), {}};
    }
    return {{}, fmt::format("does not fall to {:.6g} of its peak within the window", in.threshold)};
}

}  // namespace

const std::vector<Metric>& metrics() {
    using enum Dimension;
    static constexpr MetricNeeds window{.whole_window = true};
    static constexpr MetricNeeds threshold{.threshold = true};
    static const std::vector<Metric> table{
        {"mean", series, window, false, "average over the window (trapezoidal rule)", mean},
        {"standard_deviation", series, window, true,
         "root mean square deviation from the mean (trapezoidal rule)", standard_deviation},
        {"maximum", series, window, false, "largest value", maximum},
        {"time_of_maximum", abscissa, window, false, "abscissa of the largest value", time_of_maximum},
        {"minimum", series, window, false, "smallest value", minimum},
        {"slope", series_per_abscissa, window, false, "slope of the least-squares line", slope},
        {"proportion", series_per_abscissa, window, false,
         "slope of the least-squares line through the origin", proportion},
        {"first_crossing", abscissa, threshold, false,
         "first abscissa at which the series rises through the threshold, interpolated", first_crossing},
        {"value_at", series, threshold, false, "value at the abscissa that the threshold names, interpolated",
         value_at},
        {"rms_difference",
         series,
         {.reference = true, .whole_window = true},
         true,
         "root mean square difference to a reference curve at 2000 equidistant instants, without a time "
         "shift",
         difference_to_reference},
        {"largest_difference",
         series,
         {.reference = true, .whole_window = true},
         true,
         "largest difference to a reference curve at its points in the window, without a time shift",
         largest_difference},
        {"integral", series_times_abscissa, window, false, "integral over the window (trapezoidal rule)",
         integral},
        {"change", series, window, false, "last value less the first", change},
        {"first_peak_integral",
         series_times_abscissa,
         {.threshold = true, .whole_window = true},
         false,
         "integral until the series has fallen from its maximum to the threshold times the maximum",
         first_peak_integral},
    };
    return table;
}

std::vector<std::string> metric_names() {
    std::vector<std::string> names;
    for (const Metric& metric : metrics()) names.emplace_back(metric.name);
    return names;
}

const Metric& metric_named(const std::string& name) {
    for (const Metric& metric : metrics()) {
        if (name == metric.name) return metric;
    }
    throw InputError(
        fmt::format("unknown metric '{}', expected one of {}", name, fmt::join(metric_names(), ", ")));
}

}  // namespace wetdeck
