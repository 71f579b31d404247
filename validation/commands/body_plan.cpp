// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/body_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/sections/section_figures.hpp"

namespace wetdeck {
namespace {

enum class Shown { all, left, right };

/// Adds what lies on the side that is shown; pieces on the centre line are left out.
void add_clipped(Vec2 a, Vec2 b, Shown shown, std::size_t row, std::vector<PlanLine>& lines) {
    if (shown != Shown::all) {
        const double side = shown == Shown::right ? 1 : -1;
        if (side * a.x() <= 0 && side * b.x() <= 0) return;
        const auto on_axis = [](Vec2 p, Vec2 q) {
            return Vec2(0, p.y() + (q.y() - p.y()) * p.x() / (p.x() - q.x()));
        };
        if (side * a.x() < 0)
            a = on_axis(a, b);
        else if (side * b.x() < 0)
            b = on_axis(a, b);
    }
    lines.push_back({a, b, row});
}

Box box_of(const std::vector<PlanLine>& lines) {
    Box box;  // the centre line is part of it
    if (lines.empty()) return box;
    box.low.y() = box.high.y() = lines.front().begin.y();
    for (const PlanLine& line : lines)
        for (const Vec2& point : {line.begin, line.end}) {
            box.low = box.low.cwiseMin(point);
            box.high = box.high.cwiseMax(point);
        }
    return box;
}

/// Where each row is labelled [pixels]: beside its point furthest out and up, further down where another
/// label stands there already.
std::map<std::size_t, Vec2> label_places(const std::vector<PlanLine>& lines, const Drawing& drawing) {
    constexpr double line_height = 12, width = 20;
    std::map<std::size_t, Vec2> places;
    for (const PlanLine& line : lines)
        for (const Vec2& point : {line.begin, line.end}) {
            Vec2& best = places.try_emplace(line.row, point).first->second;
            if (point.y() + std::abs(point.x()) > best.y() + std::abs(best.x())) best = point;
        }
    for (auto each = places.begin(); each != places.end(); ++each) {
        const Vec2 point = each->second;
        each->second = Vec2(drawing.x(point.x()) + (point.x() < 0 ? -width : 4), drawing.y(point.y()) - 3);
        const auto covered = [&](const auto& other) {
            const Vec2 apart = (each->second - other.second).cwiseAbs();
            return apart.x() < width && apart.y() < line_height - 1e-6;
        };
        for (auto other = places.begin(); (other = std::find_if(places.begin(), each, covered)) != each;)
            each->second.y() = other->second.y() + line_height;
    }
    return places;
}

/// Round steps of a grid, about six over a length.
double grid_step(double length) {
    const double rough = std::max(length, 1e-9) / 6, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= rough) return step * power;
    return 10 * power;
}

/// The multiples of a step from `low` to `high`.
std::vector<double> multiples(double step, double low, double high) {
    std::vector<double> values;
    for (double x = std::ceil(low / step - 1e-9) * step; x <= high + 1e-9; x += step) values.push_back(x);
    return values;
}

}  // namespace

std::vector<PlanLine> body_plan(const SectionFile& file) {
    std::vector<PlanLine> lines;
    std::size_t row = 0;
    for (std::size_t k = 0; k < file.stations.size(); ++k) {
        const bool forward = file.bow_first == (2 * k < file.stations.size());
        const Shown shown = file.drawn_as_body_plan ? Shown::all : forward ? Shown::right : Shown::left;
        const auto& outlines = file.stations[k].outlines;
        if (outlines.empty()) ++row;
        for (const SectionOutline& outline : outlines) {
            ++row;
            const bool whole = outline.closed || !file.drawn_as_body_plan;
            const Outline corners = whole ? whole_outline(outline) : outline.corners;
            for (std::size_t i = 0; i + (whole ? 0 : 1) < corners.size(); ++i)
                add_clipped(corners[i], corners[(i + 1) % corners.size()], shown, row, lines);
        }
    }
    return lines;
}

Drawing drawn_body_plan(const SectionFile& file) {
    constexpr Stroke grid{"#dddddd"}, centre{"#888888", 1, true}, curve{"#16324f", 1.2};
    const std::vector<PlanLine> lines = body_plan(file);
    Box box = box_of(lines);
    box.high = box.high.cwiseMax(box.low + Vec2::Constant(1e-9));
    Drawing drawing(box, "body plan", {800, 800 / 0.7});
    const double step = grid_step((box.high - box.low).maxCoeff());
    for (const double y : multiples(step, box.low.y(), box.high.y())) {
        drawing.line({box.low.x(), y}, {box.high.x(), y}, grid);
        drawing.label(-6, drawing.y(y) + 4, fmt::format("{:.4g}", y + 0.0), {Anchor::end, 11});
    }
    for (const double x : multiples(step, box.low.x(), box.high.x())) {
        drawing.line({x, box.low.y()}, {x, box.high.y()}, grid);
        drawing.label(drawing.x(x), drawing.height() + 16, fmt::format("{:.4g}", std::abs(x)),
                      {Anchor::middle, 11});
    }
    drawing.line({0, box.low.y()}, {0, box.high.y()}, centre);
    for (const PlanLine& line : lines) drawing.line(line.begin, line.end, curve);
    for (const auto& [row, place] : label_places(lines, drawing))
        drawing.label(place.x(), place.y(), std::to_string(row), {Anchor::start, 11});
    const double end = drawing.height() + 36;
    drawing.label(drawing.width() / 2, end,
                  file.drawn_as_body_plan ? "sections as drawn; metres"
                                          : "left: aft, right: forward; numbers: rows of the list; metres",
                  {Anchor::middle, 11});
    drawing.end_at(end);
    return drawing;
}

}  // namespace wetdeck
