// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/section_figures.hpp"

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

Box box_of(const Outline& corners) {
    Box box{corners.front(), corners.front()};
    for (const Vec2& corner : corners) {
        box.low = box.low.cwiseMin(corner);
        box.high = box.high.cwiseMax(corner);
    }
    return box;
}

/// Room for rounding of the file [m].
double rounding(const Box& box) {
    return 1e-5 * (box.high - box.low).maxCoeff();
}

/// The lowest height of an outline at x.
std::optional<double> bottom_at(const Outline& outline, double x) {
    std::optional<double> lowest;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()];
        if ((a.x() - x) * (b.x() - x) > 0 || a.x() == b.x()) continue;
        const double y = a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
        lowest = std::min(lowest.value_or(y), y);
    }
    return lowest;
}

}  // namespace

bool is_half_section(const SectionOutline& outline) {
    if (outline.closed || outline.corners.size() < 2) return false;
    const Box box = box_of(outline.corners);
    const double room = rounding(box);
    const bool one_side = box.low.x() >= -room || box.high.x() <= room;
    const Vec2& keel = outline.corners.front();
    return one_side && std::abs(keel.x()) <= room && keel.y() <= box.low.y() + room;
}

Outline whole_outline(const SectionOutline& outline) {
    Outline whole = outline.corners;
    if (!is_half_section(outline)) return whole;
    const double room = rounding(box_of(whole));
    for (Vec2& corner : whole) corner.x() = std::abs(corner.x()) <= room ? 0 : std::abs(corner.x());
    for (std::size_t k = outline.corners.size(); k-- > 0;)
        if (whole[k].x() > 0) whole.emplace_back(-whole[k].x(), whole[k].y());
    return whole;
}

SectionFigures figures_of(const SectionOutline& outline) {
    const Outline whole = whole_outline(outline);
    const Box box = box_of(whole);
    SectionFigures figures;
    figures.low = box.low.y();
    figures.high = box.high.y();
    figures.beam = box.high.x() - box.low.x();
    figures.area = std::abs(area_moments(whole).area);
    const double room = rounding(box);
    Vec2 keel = whole.front();
    for (const Vec2& corner : whole) {
        const bool lower = corner.y() < keel.y() - room;
        const bool as_low = corner.y() <= keel.y() + room;
        if (lower || (as_low && std::abs(corner.x()) < std::abs(keel.x()))) keel = corner;
    }
    const double side = box.high.x() - keel.x() >= keel.x() - box.low.x() ? 1 : -1;
    const double out = figures.beam / 8;
    if (const auto bottom = bottom_at(whole, keel.x() + side * out); bottom && out > 0)
        figures.deadrise = std::atan2(*bottom - keel.y(), out);
    return figures;
}

std::optional<double> half_breadth_at(const SectionOutline& outline, double height) {
    const Outline whole = whole_outline(outline);
    std::optional<double> widest;
    for (std::size_t k = 0; k < whole.size(); ++k) {
        const Vec2 a = whole[k], b = whole[(k + 1) % whole.size()];
        if ((a.y() - height) * (b.y() - height) > 0 || a.y() == b.y()) continue;
        const double x = std::abs(a.x() + (b.x() - a.x()) * (height - a.y()) / (b.y() - a.y()));
        widest = std::max(widest.value_or(x), x);
    }
    return widest;
}

}  // namespace wetdeck
