// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/curve_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

constexpr double largest_shift = 0.1;  // of the window

std::optional<std::size_t> inner_peak(const Curve& curve) {
    const std::size_t top = index_of_maximum(curve);
    return top > 0 && top + 1 < curve.x.size() ? std::optional(top) : std::nullopt;
}

/// Where the straight line between two samples takes the value `level`.
double crossing(const Curve& curve, std::size_t before, double level) {
    const double share = (level - curve.y[before]) / (curve.y[before + 1] - curve.y[before]);
    return std::lerp(curve.x[before], curve.x[before + 1], share);
}

std::optional<double> rise_time(const Curve& curve) {
    const auto top = inner_peak(curve);
    if (!top || curve.y[*top] <= 0) return std::nullopt;
    const double low = 0.1 * curve.y[*top], high = 0.9 * curve.y[*top];
    std::size_t start = *top;
    while (start > 0 && curve.y[start] >= low) --start;
    if (curve.y[start] >= low) return std::nullopt;  // already high where the window begins
    std::size_t arrival = start;
    while (curve.y[arrival + 1] < high) ++arrival;
    return crossing(curve, arrival, high) - crossing(curve, start, low);
}

double integral(const Curve& curve) {
    double sum = 0;
    for (std::size_t i = 1; i < curve.x.size(); ++i)
        sum += 0.5 * (curve.y[i - 1] + curve.y[i]) * (curve.x[i] - curve.x[i - 1]);
    return sum;
}

std::vector<double> sampled(const Curve& curve, const Window& window) {
    std::vector<double> values;
    for (int i = 0; i < comparison_instants; ++i) {
        const double share = static_cast<double>(i) / (comparison_instants - 1);
        values.push_back(interpolate(curve, std::lerp(window.begin, window.end, share)));
    }
    return values;
}

/// Sums over the instants at which both are inside the window when S is read `shift` instants later.
struct Products {
    double ss = 0, sd = 0, dd = 0;
    double count = 0;
};

Products products(const std::vector<double>& s, const std::vector<double>& d, int shift) {
    const int n = static_cast<int>(d.size());
    Products sums;
    for (int i = std::max(0, -shift); i < std::min(n, n - shift); ++i) {
        const double a = s[static_cast<std::size_t>(i + shift)];
        const double b = d[static_cast<std::size_t>(i)];
        sums.ss += a * a;
        sums.sd += a * b;
        sums.dd += b * b;
        sums.count += 1;
    }
    return sums;
}

}  // namespace

std::vector<CurveFeature> curve_features(const Curve& simulated, const Curve& reference,
                                         const Window& window) {
    const Curve s = clip(simulated, window), d = clip(reference, window);
    const auto peak = [](const Curve& c) {
        const auto top = inner_peak(c);
        return top ? std::optional(c.y[*top]) : std::nullopt;
    };
    const auto time = [](const Curve& c) {
        const auto top = inner_peak(c);
        return top ? std::optional(c.x[*top]) : std::nullopt;
    };
    const double length = window.end - window.begin;
    return {{"peak", peak(s), peak(d)},
            {"time of peak", time(s), time(d)},
            {"rise time", rise_time(s), rise_time(d)},
            {"impulse", integral(s), integral(d)},
            {"mean", integral(s) / length, integral(d) / length}};
}

CurveAgreement curve_agreement(const Curve& simulated, const Curve& reference, const Window& window) {
    const std::vector<double> s = sampled(simulated, window), d = sampled(reference, window);
    const Products whole = products(s, d, 0);
    CurveAgreement result;
    if (whole.ss == 0 || whole.dd == 0) return result;
    result.magnitude = std::sqrt(whole.ss / whole.dd) - 1;
    const double cosine = std::clamp(whole.sd / std::sqrt(whole.ss * whole.dd), -1.0, 1.0);
    result.phase = std::acos(cosine) / std::numbers::pi;
    result.combined = std::hypot(*result.magnitude, *result.phase);

    const auto [lowest, highest] = std::minmax_element(d.begin(), d.end());
    if (*highest <= *lowest) return result;
    const int steps = static_cast<int>(largest_shift * comparison_instants);
    const double instant = (window.end - window.begin) / (comparison_instants - 1);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 2 * steps; ++k) {
        const int shift = k % 2 == 0 ? k / 2 : -(k + 1) / 2;  // of equally good shifts the smallest
        const Products part = products(s, d, shift);
        if (part.ss == 0) continue;
        const double factor = part.sd / part.ss;
        const double rest = std::max(0.0, part.dd - factor * part.sd) / part.count;
        if (rest >= least) continue;
        least = rest;
        result.amplitude_factor = factor;
        result.time_shift = shift * instant;
        result.shape_error = std::sqrt(rest) / (*highest - *lowest);
    }
    return result;
}

std::optional<double> simulated_feature(const ComparisonResult& comparison, const std::string& name) {
    for (const CurveFeature& feature : comparison.features)
        if (feature.name == name) return feature.simulated;
    return std::nullopt;
}

std::optional<double> reference_feature(const ComparisonResult& comparison, const std::string& name) {
    for (const CurveFeature& feature : comparison.features)
        if (feature.name == name) return feature.reference;
    return std::nullopt;
}

const char* judged_feature(const ComparisonResult& comparison) {
    constexpr double least_share = 0.1;
    const std::optional<double> peak = reference_feature(comparison, "peak");
    if (!peak) return "mean";
    const Curve& measured = comparison.measured;
    if (measured.x.empty()) return "peak";
    const auto window = overlap(measured, comparison.window.value_or(extent(measured)));
    if (!window) return "peak";
    const Curve part = clip(measured, *window);
    const double lowest = *std::min_element(part.y.begin(), part.y.end());
    const double above_ends = *peak - std::max(part.y.front(), part.y.back());
    return above_ends >= least_share * (*peak - lowest) ? "peak" : "mean";
}

}  // namespace wetdeck
