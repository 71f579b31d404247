// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/dxf_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"
#include "validation/sections/plane_curves.hpp"

namespace wetdeck::dxf {
namespace {

constexpr int deepest_insert = 16;
constexpr double radian = std::numbers::pi / 180;
constexpr std::size_t most_curves = 20'000, most_points = 100'000;

struct Affine {
    Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
    Vec2 shift = Vec2::Zero();
    Vec2 operator()(Vec2 p) const { return linear * p + shift; }
    Affine then(const Affine& outer) const {
        return {outer.linear * linear, outer.linear * shift + outer.shift};
    }
};

/// From the system of an entity into that of the drawing.
Affine extrusion_of(const Entity& entity) {
    const double x = entity.number(210, 0), y = entity.number(220, 0), z = entity.number(230, 1);
    Affine all;
    if (std::abs(x) > 1e-9 || std::abs(y) > 1e-9 || z == 0)
        entity.fail("is drawn in another plane (extrusion), expected x, y");
    if (z < 0) all.linear(0, 0) = -1;
    return all;
}

/// The points of a pair of codes such as 10 and 20.
std::vector<Vec2> points_of(const Entity& entity, int x_code, int y_code) {
    const std::vector<double> x = entity.numbers(x_code), y = entity.numbers(y_code);
    if (x.size() != y.size()) entity.fail("has an x without its y, or a y without its x");
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < x.size(); ++k) points.emplace_back(x[k], y[k]);
    return points;
}

void check_flat(const Entity& entity, std::vector<double> heights) {
    if (heights.empty()) return;
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    if (*high - *low > 1e-6 * std::max(1.0, std::abs(*high)))
        entity.fail(fmt::format("leaves the x, y plane (z from {} to {}): expected a body plan in x, y", *low,
                                *high));
}

struct Corner {
    Vec2 place;
    double bulge = 0;
};

/// Corners with arcs of their bulges between them.
PlaneCurve bulged(const std::vector<Corner>& corners, bool closed, double tolerance) {
    PlaneCurve curve;
    curve.closed = closed;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        curve.points.push_back(corners[k].place);
        if (k + 1 == corners.size() && !closed) break;
        const Vec2 next = corners[(k + 1) % corners.size()].place;
        for (const Vec2& point : arc_by_bulge(corners[k].place, next, corners[k].bulge, tolerance))
            curve.points.push_back(point);
    }
    return curve;
}

PlaneCurve light_polyline(const Entity& entity, double tolerance) {
    std::vector<Corner> corners;
    std::size_t ys = 0;
    for (const Group& group : entity.groups) {
        const Entity one{entity.type, entity.line, {group}, {}};
        if (group.code == 10) {
            if (ys != corners.size()) entity.fail("has an x without its y");
            corners.push_back({Vec2(one.number(10), 0), 0});
        }
        if (group.code == 20) {
            if (++ys != corners.size()) entity.fail("has a y without its x");
            corners.back().place.y() = one.number(20);
        }
        if (group.code == 42 && !corners.empty()) corners.back().bulge = one.number(42);
    }
    if (ys != corners.size()) entity.fail("has an x without its y");
    const double count = entity.number(90, static_cast<double>(corners.size()));
    if (count != static_cast<double>(corners.size()))
        entity.fail(fmt::format("states {} vertices and holds {}", count, corners.size()));
    return bulged(corners, (entity.bits(70) & 1) != 0, tolerance);
}

PlaneCurve polyline(const Entity& entity, double tolerance) {
    const int bits = entity.bits(70);
    if ((bits & 80) != 0) entity.fail("is a mesh (group 70), expected a curve");
    std::vector<Corner> corners;
    std::vector<double> heights;
    for (const Entity& vertex : entity.vertices) {
        if ((vertex.bits(70) & 16) != 0) continue;  // of the frame that a smoothed curve was made of
        corners.push_back({Vec2(vertex.number(10), vertex.number(20)), vertex.number(42)});
        heights.push_back(vertex.number(30));
    }
    check_flat(entity, heights);
    return bulged(corners, (bits & 1) != 0, tolerance);
}

PlaneCurve line(const Entity& entity) {
    check_flat(entity, {entity.number(30), entity.number(31)});
    return {{{entity.number(10), entity.number(20)}, {entity.number(11), entity.number(21)}}, false, {}};
}

PlaneCurve arc(const Entity& entity, double tolerance) {
    const double radius = entity.number(40);
    if (!(radius > 0)) entity.fail(fmt::format("has the radius {}, expected a positive one", radius));
    const bool circle = entity.type == "CIRCLE";
    const double begin = circle ? 0 : entity.number(50), end = circle ? 360 : entity.number(51);
    double turn = std::fmod(end - begin, 360);
    if (turn <= 0) turn += 360;
    PlaneCurve curve;
    curve.closed = circle;
    curve.points = arc_by_angles({entity.number(10), entity.number(20)}, radius, begin * radian,
                                 turn * radian, tolerance);
    if (circle) curve.points.pop_back();
    return curve;
}

PlaneCurve spline(const Entity& entity, double tolerance) {
    Spline s;
    check_flat(entity, entity.numbers(30));
    s.degree = static_cast<std::size_t>(std::clamp(entity.number(71, 3), 0.0, 100.0));
    s.knots = entity.numbers(40);
    s.weights = entity.numbers(41);
    s.control = points_of(entity, 10, 20);
    for (const auto& [code, count, what] :
         {std::tuple(72, s.knots.size(), "knots"), std::tuple(73, s.control.size(), "control points")})
        if (const double stated = entity.number(code, static_cast<double>(count));
            stated != static_cast<double>(count))
            entity.fail(fmt::format("states {} {} and holds {}", stated, what, count));
    if (s.control.size() > most_points) entity.fail("has more control points than expected");
    try {
        return {chords_of(s, tolerance), false, {}};
    } catch (const InputError& error) {
        entity.fail(error.what());
    }
}

class Walk {
  public:
    Walk(const Drawing& drawing, const std::function<double(const std::string&)>& tolerance)
        : drawing_(drawing), tolerance_(tolerance) {}

    void draw(const std::vector<Entity>& entities, const Affine& frame, const std::string& inherited,
              int depth) {
        for (const Entity& entity : entities) {
            std::string layer = upper_case(entity.text(8).value_or("0"));
            if (layer == "0" && !inherited.empty()) layer = inherited;
            if (const std::string reason = why_hidden(entity, layer); !reason.empty())
                ++all_.left_out[entity.type + " " + reason];
            else if (entity.type == "INSERT")
                insert(entity, frame, layer, depth);
            else
                add(entity, frame, layer);
        }
    }

    DrawnCurves take() { return std::move(all_); }

  private:
    std::string why_hidden(const Entity& entity, const std::string& layer) const {
        if (entity.bits(67) == 1) return "of paper space";
        if ((entity.bits(60) & 1) != 0) return "invisible";
        const auto found = drawing_.layers.find(layer);
        if (found == drawing_.layers.end() || found->second == Layer::shown) return "";
        if (found->second == Layer::frozen) return "on a frozen layer";
        return entity.type == "INSERT" ? "" : "on a layer that is off";
    }

    void insert(const Entity& entity, const Affine& frame, const std::string& layer, int depth) {
        const std::string name = upper_case(entity.text(2).value_or(""));
        const auto block = drawing_.blocks.find(name);
        if (block == drawing_.blocks.end())
            entity.fail(fmt::format("names the block '{}', which the drawing does not hold", name));
        if (depth == deepest_insert) entity.fail("is inserted in itself, or too deep");
        const double turn = entity.number(50) * radian;
        Eigen::Matrix2d rotation;
        rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
        const double columns = entity.number(70, 1), rows = entity.number(71, 1);
        if (columns > 100 || rows > 100) entity.fail("repeats its block more often than expected");
        for (int row = 0; row < std::max(rows, 1.0); ++row)
            for (int column = 0; column < std::max(columns, 1.0); ++column) {
                const Vec2 step(column * entity.number(44), row * entity.number(45));
                Affine own;
                own.linear = rotation * Vec2(entity.number(41, 1), entity.number(42, 1)).asDiagonal();
                own.shift = Vec2(entity.number(10), entity.number(20)) + rotation * step -
                            own.linear * block->second.base;
                draw(block->second.entities, own.then(extrusion_of(entity)).then(frame), layer, depth + 1);
            }
    }

    void add(const Entity& entity, const Affine& frame, const std::string& layer) {
        const std::string& type = entity.type;
        const bool solid = type == "POLYLINE" && (entity.bits(70) & 8) != 0;
        const bool in_own_system =
            type == "LWPOLYLINE" || (type == "POLYLINE" && !solid) || type == "ARC" || type == "CIRCLE";
        const double tolerance = tolerance_(layer) / std::max(frame.linear.norm(), 1e-300);
        PlaneCurve curve;
        if (type == "LWPOLYLINE")
            curve = light_polyline(entity, tolerance);
        else if (type == "POLYLINE")
            curve = polyline(entity, tolerance);
        else if (type == "LINE")
            curve = line(entity);
        else if (type == "ARC" || type == "CIRCLE")
            curve = arc(entity, tolerance);
        else if (type == "SPLINE")
            curve = spline(entity, tolerance);
        else {
            if (type != "SEQEND") ++all_.left_out[type];
            return;
        }
        const Affine place = in_own_system ? extrusion_of(entity).then(frame) : frame;
        PlaneCurve drawn;
        drawn.closed = curve.closed;
        for (const Vec2& point : curve.points)
            if (const Vec2 there = place(point); drawn.points.empty() || drawn.points.back() != there)
                drawn.points.push_back(there);
        if (drawn.points.size() < 2) {
            ++all_.left_out[type + " without a length"];
            return;
        }
        if (drawn.closed && drawn.points.front() == drawn.points.back()) drawn.points.pop_back();
        points_ += drawn.points.size();
        if (all_.curves.size() == most_curves || points_ > 10 * most_points)
            entity.fail("is one more curve than a body plan is expected to have");
        all_.curves.push_back({std::move(drawn), layer, entity.source()});
    }

    const Drawing& drawing_;
    const std::function<double(const std::string&)>& tolerance_;
    DrawnCurves all_;
    std::size_t points_ = 0;
};

}  // namespace

DrawnCurves drawn_curves(const Drawing& drawing, double metres, double axis,
                         const std::function<double(const std::string& layer)>& tolerance) {
    Affine frame;
    frame.linear *= metres;
    frame.shift = {-axis, 0};
    Walk walk(drawing, tolerance);
    walk.draw(drawing.entities, frame, "", 0);
    return walk.take();
}

}  // namespace wetdeck::dxf
