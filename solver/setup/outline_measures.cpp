// SPDX-License-Identifier: BSD-3-Clause
// What needs no geometry library: areas and points of outlines.
#include <algorithm>
#include <cmath>

#include "solver/setup/body_outline.hpp"

namespace wetdeck {

bool contains(const Outline& outline, Vec2 point) {
    bool inside = false;
    for (std::size_t k = 0, last = outline.size() - 1; k < outline.size(); last = k++) {
        const Vec2 a = outline[k], b = outline[last];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        if (point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y())) inside = !inside;
    }
    return inside;
}

bool inside(const Outline& outline, Box box) {
    return std::all_of(outline.begin(), outline.end(), [&](const Vec2& p) {
        return (p - box.low).minCoeff() > 0 && (box.high - p).minCoeff() > 0;
    });
}

AreaMoments area_moments(const Outline& outline) {
    double area = 0, second = 0;
    Vec2 first = Vec2::Zero();
    const Vec2 origin = outline.front();
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k] - origin, b = outline[(k + 1) % outline.size()] - origin;
        const double cross = a.x() * b.y() - a.y() * b.x();
        area += cross / 2;
        first += cross / 6 * (a + b);
        second += cross / 12 * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
    }
    const Vec2 centre = first / area;
    return {std::abs(area), origin + centre, std::abs(second) - std::abs(area) * centre.squaredNorm()};
}

Outline corners_of(Box box) {
    return {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
}

}  // namespace wetdeck
