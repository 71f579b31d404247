// SPDX-License-Identifier: BSD-3-Clause
// Scaling, cutting and linear interpolation of curves.
#include "validation/metrics/resample.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "validation/metrics/time_origin.hpp"

namespace wetdeck {

namespace {

/// The values of a profile in the row nearest to the instant.
std::vector<double> values_at(const Series& series, double instant) {
    const auto after = std::lower_bound(series.time.begin(), series.time.end(), instant);
    auto row = static_cast<std::size_t>(after - series.time.begin());
    if (row > 0 && instant - series.time[row - 1] < *after - instant) --row;
    const auto begin = series.value.begin() + static_cast<std::ptrdiff_t>(row * series.columns());
    return {begin, begin + static_cast<std::ptrdiff_t>(series.columns())};
}

/// The means of the columns of a profile over an interval.
std::vector<double> means_over(const Series& series, const Window& interval) {
    std::vector<double> means;
    for (std::size_t k = 0; k < series.columns(); ++k) {
        Curve column{series.time, {}};
        for (std::size_t row = 0; row < series.time.size(); ++row)
            column.y.push_back(series.value[row * series.columns() + k]);
        means.push_back(average(clip(column, interval)));
    }
    return means;
}

/// A profile at its instant, or its mean over the interval that begins there.
SeriesCurve profile_curve(const Series& series, const std::string& name, const SeriesScaling& scaling,
                          double x_offset) {
    const double instant = *scaling.instant, end = instant + scaling.interval;
    if (instant < series.time.front() || end > series.time.back() * (1 + 1e-9)) {
        return {{},
                fmt::format("series '{}' spans {:.6g} to {:.6g} s, not {:.6g}", name, series.time.front(),
                            series.time.back(), instant < series.time.front() ? instant : end)};
    }
    const std::vector<double> values =
        scaling.interval > 0 ? means_over(series, {instant, end}) : values_at(series, instant);
    SeriesCurve result;
    for (std::size_t k = 0; k < series.columns(); ++k) {
        const double y = values[k] / scaling.y_scale - scaling.y_offset;
        if (!std::isfinite(y))
            return {{},
                    fmt::format("series '{}' is not finite at column {}, t = {:.6g} s", name, k, instant)};
        result.curve.x.push_back((series.abscissa[k] - x_offset) / scaling.x_scale);
        result.curve.y.push_back(y);
    }
    return result;
}

}  // namespace

SeriesCurve series_curve(const RunRecord& record, const std::string& name, const SeriesScaling& scaling) {
    const auto found = record.series.find(name);
    if (found == record.series.end()) return {{}, fmt::format("the run has no series '{}'", name)};
    const Series& series = found->second;
    const bool profile = series.columns() != 1;
    if (profile && !scaling.instant) return {{}, fmt::format("series '{}' has several columns", name)};
    if (!profile && scaling.instant) return {{}, fmt::format("series '{}' is no profile", name)};
    if (series.time.empty()) return {{}, fmt::format("series '{}' is empty", name)};
    if (series.time.size() * series.columns() != series.value.size()) {
        return {{},
                fmt::format("series '{}' has {} times and {} values", name, series.time.size(),
                            series.value.size())};
    }
    const FoundOrigin origin = find_origin(record, scaling);
    if (!origin.problem.empty())
        return {{}, fmt::format("time origin '{}': {}", scaling.origin, origin.problem)};
    if (profile) return profile_curve(series, name, scaling, origin.time);
    SeriesCurve result;
    for (std::size_t i = 0; i < series.time.size(); ++i) {
        const double x = (series.time[i] - origin.time) / scaling.x_scale;
        const double y = series.value[i] / scaling.y_scale - scaling.y_offset;
        if (!std::isfinite(x) || !std::isfinite(y)) {
            result.problem =
                fmt::format("series '{}' is not finite at sample {}, t = {:.6g} s", name, i, series.time[i]);
            return result;
        }
        if (i > 0 && x <= result.curve.x.back()) {
            result.problem =
                fmt::format("the time of series '{}' does not increase at sample {}, t = {:.6g} s", name, i,
                            series.time[i]);
            return result;
        }
        result.curve.x.push_back(x);
        result.curve.y.push_back(y);
    }
    return result;
}

double interpolate(const Curve& curve, double x) {
    if (x <= curve.x.front()) return curve.y.front();
    if (x >= curve.x.back()) return curve.y.back();
    const auto right =
        static_cast<std::size_t>(std::upper_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin());
    const double share = (x - curve.x[right - 1]) / (curve.x[right] - curve.x[right - 1]);
    return std::lerp(curve.y[right - 1], curve.y[right], share);
}

Window extent(const Curve& curve) {
    return {curve.x.front(), curve.x.back()};
}

std::optional<Window> overlap(const Curve& curve, const Window& window) {
    if (curve.x.empty()) return std::nullopt;
    const Window common{std::max(curve.x.front(), window.begin), std::min(curve.x.back(), window.end)};
    if (common.end <= common.begin) return std::nullopt;
    return common;
}

bool covers(const Curve& curve, const Window& window) {
    const auto common = overlap(curve, window);
    return common && common->end - common->begin >= required_coverage * (window.end - window.begin);
}

Curve clip(const Curve& curve, const Window& window) {
    const auto common = overlap(curve, window);
    if (!common) return {};
    Curve part{{common->begin}, {interpolate(curve, common->begin)}};
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (curve.x[i] <= common->begin || curve.x[i] >= common->end) continue;
        part.x.push_back(curve.x[i]);
        part.y.push_back(curve.y[i]);
    }
    part.x.push_back(common->end);
    part.y.push_back(interpolate(curve, common->end));
    return part;
}

double average(const Curve& curve) {
    double integral = 0;
    for (std::size_t i = 1; i < curve.x.size(); ++i)
        integral += 0.5 * (curve.y[i - 1] + curve.y[i]) * (curve.x[i] - curve.x[i - 1]);
    return integral / (curve.x.back() - curve.x.front());
}

double rms_difference(const Curve& a, const Curve& b, const Window& window) {
    double sum = 0;
    for (int i = 0; i < comparison_instants; ++i) {
        const double x =
            std::lerp(window.begin, window.end, static_cast<double>(i) / (comparison_instants - 1));
        const double difference = interpolate(a, x) - interpolate(b, x);
        sum += difference * difference;
    }
    return std::sqrt(sum / comparison_instants);
}

std::size_t index_of_maximum(const Curve& curve) {
    return static_cast<std::size_t>(std::max_element(curve.y.begin(), curve.y.end()) - curve.y.begin());
}

}  // namespace wetdeck
