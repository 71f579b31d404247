// SPDX-License-Identifier: BSD-3-Clause
// Which samples of a curve are drawn: enough for the screen, so that the page stays small.
#include <algorithm>
#include <cmath>

#include "reports/page/figure.hpp"

namespace wetdeck::report {
namespace {

using Indices = std::vector<std::size_t>;

/// Lowest and highest sample of each of `stretches` runs of equal length.
Indices extremes(const Curve& curve, const Indices& all, std::size_t stretches) {
    if (all.size() <= 2 * stretches) return all;
    Indices kept;
    const auto lower = [&](std::size_t a, std::size_t b) { return curve.y[a] < curve.y[b]; };
    for (std::size_t s = 0; s < stretches; ++s) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(s * all.size() / stretches);
        const auto end = all.begin() + static_cast<std::ptrdiff_t>((s + 1) * all.size() / stretches);
        const auto [low, high] = std::minmax_element(begin, end, lower);
        kept.push_back(*std::min(low, high));
        if (low != high) kept.push_back(*std::max(low, high));
    }
    return kept;
}

struct Pixel {
    double x, y;
};

/// Places of the samples on a canvas of twice the width of its height.
std::vector<Pixel> pixels_of(const Figure& figure, const Curve& curve, const Indices& indices,
                             double columns) {
    const auto scaled = [](double value, const Axis& axis, const Window& range) {
        if (!axis.logarithmic) return (value - range.begin) / (range.end - range.begin);
        return std::log(value / range.begin) / std::log(range.end / range.begin);
    };
    const Window x = data_range(figure, true);
    const Window y = data_range(figure, false);
    std::vector<Pixel> pixels;
    for (const std::size_t i : indices) {
        pixels.push_back(
            {columns * scaled(curve.x[i], figure.x, x), 0.5 * columns * scaled(curve.y[i], figure.y, y)});
    }
    return pixels;
}

double distance_to_line(const Pixel& p, const Pixel& a, const Pixel& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length = std::hypot(dx, dy);
    if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
    return std::abs(dx * (p.y - a.y) - dy * (p.x - a.x)) / length;
}

/// Marks the samples between two kept ones without which the line would be off by more than a third of a
/// pixel (Douglas and Peucker 1973).
void mark_corners(const std::vector<Pixel>& pixels, std::size_t first, std::size_t last,
                  std::vector<bool>& keep) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [begin, end] = open.back();
        open.pop_back();
        double largest = 1.0 / 3;
        std::size_t corner = end;
        for (std::size_t k = begin + 1; k < end; ++k) {
            const double distance = distance_to_line(pixels[k], pixels[begin], pixels[end]);
            if (distance <= largest) continue;
            largest = distance;
            corner = k;
        }
        if (corner == end) continue;
        keep[corner] = true;
        open.emplace_back(begin, corner);
        open.emplace_back(corner, end);
    }
}

/// Without the samples on straight stretches. Both ends, the lowest and the highest sample always stay.
Indices corners(const Figure& figure, const Curve& curve, const Indices& indices, double columns) {
    if (indices.size() < 3) return indices;
    const std::vector<Pixel> pixels = pixels_of(figure, curve, indices, columns);
    const auto lower = [](const Pixel& a, const Pixel& b) { return a.y < b.y; };
    const auto [low, high] = std::minmax_element(pixels.begin(), pixels.end(), lower);
    Indices anchors{0, static_cast<std::size_t>(low - pixels.begin()),
                    static_cast<std::size_t>(high - pixels.begin()), pixels.size() - 1};
    std::sort(anchors.begin(), anchors.end());
    std::vector<bool> keep(pixels.size(), false);
    for (const std::size_t anchor : anchors) keep[anchor] = true;
    for (std::size_t k = 1; k < anchors.size(); ++k) mark_corners(pixels, anchors[k - 1], anchors[k], keep);
    Indices kept;
    for (std::size_t k = 0; k < indices.size(); ++k) {
        if (keep[k]) kept.push_back(indices[k]);
    }
    return kept;
}

}  // namespace

std::vector<std::size_t> drawn_samples(const Figure& figure, const PlotSeries& series, std::size_t columns) {
    const auto drawable = [](double value, const Axis& axis) {
        return std::isfinite(value) && (!axis.logarithmic || value > 0);
    };
    const Curve& curve = series.data;
    Indices all;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (drawable(curve.x[i], figure.x) && drawable(curve.y[i], figure.y)) all.push_back(i);
    }
    const bool markers = series.style == Style::points || series.style == Style::line_and_points;
    if (markers) return extremes(curve, all, columns / 10);
    return corners(figure, curve, extremes(curve, all, columns), static_cast<double>(columns));
}

}  // namespace wetdeck::report
