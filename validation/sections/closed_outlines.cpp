// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/closed_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "solver/core/cross.hpp"
#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

constexpr double same_point = 1e-6;  // of the extent

double extent_of_all(const std::vector<Outline>& curves) {
    Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
    for (const Outline& curve : curves)
        for (const Vec2& corner : curve) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    return curves.empty() ? 0 : (high - low).maxCoeff();
}

struct Side {
    Vec2 begin, end;
    bool near(const Side& other, double room) const {
        return (begin.cwiseMin(end) - other.begin.cwiseMax(other.end)).maxCoeff() <= room &&
               (other.begin.cwiseMin(other.end) - begin.cwiseMax(end)).maxCoeff() <= room;
    }
};

std::vector<Side> sides_of(const Outline& curve) {
    std::vector<Side> sides;
    for (std::size_t k = 0; k < curve.size(); ++k)
        if (const Vec2& next = curve[(k + 1) % curve.size()]; next != curve[k])
            sides.push_back({curve[k], next});
    return sides;
}

/// Where two sides cross, both beyond `room` from their ends.
std::optional<Vec2> crossing(const Side& a, const Side& b, double room) {
    if (!a.near(b, room)) return std::nullopt;
    const Vec2 u = a.end - a.begin, v = b.end - b.begin, w = b.begin - a.begin;
    const double turn = cross(u, v);
    if (std::abs(turn) <= 1e-12 * u.norm() * v.norm()) return std::nullopt;
    const double s = cross(w, v) / turn, t = cross(w, u) / turn;
    const double s_room = room / u.norm(), t_room = room / v.norm();
    if (s <= s_room || s >= 1 - s_room || t <= t_room || t >= 1 - t_room) return std::nullopt;
    return a.begin + s * u;
}

/// Points, each once; those closer than `room` are one.
class Points {
  public:
    explicit Points(double room) : room_(room) {}
    std::size_t add(Vec2 point) {
        const auto cell = cell_of(point);
        for (long dx = -1; dx <= 1; ++dx)
            for (long dy = -1; dy <= 1; ++dy)
                if (const auto found = cells_.find({cell.first + dx, cell.second + dy});
                    found != cells_.end() && (points_[found->second] - point).norm() <= room_)
                    return found->second;
        points_.push_back(point);
        cells_.emplace(cell, points_.size() - 1);
        return points_.size() - 1;
    }
    const Vec2& operator[](std::size_t k) const { return points_[k]; }
    std::size_t size() const { return points_.size(); }

  private:
    std::pair<long, long> cell_of(Vec2 point) const {
        return {std::lround(point.x() / (2 * room_)), std::lround(point.y() / (2 * room_))};
    }
    double room_;
    std::vector<Vec2> points_;
    std::multimap<std::pair<long, long>, std::size_t> cells_;
};

using Cut = std::pair<std::size_t, std::size_t>;  ///< from one point to another

/// All sides, cut at every point on them; each pair of points once, the smaller number first.
std::set<Cut> cut_sides(const std::vector<Side>& sides, Points& points, double room) {
    for (const Side& side : sides) {
        points.add(side.begin);
        points.add(side.end);
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size(); ++j)
            if (const auto at = crossing(sides[i], sides[j], room)) points.add(*at);
    std::set<Cut> cuts;
    for (const Side& side : sides) {
        const Vec2 way = side.end - side.begin;
        std::vector<std::pair<double, std::size_t>> on_side;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double along = (points[k] - side.begin).dot(way) / way.squaredNorm();
            const double beside = std::abs(cross(points[k] - side.begin, way)) / way.norm();
            const bool within = along * way.norm() > -room && (along - 1) * way.norm() < room;
            if (within && beside <= room) on_side.emplace_back(along, k);
        }
        std::sort(on_side.begin(), on_side.end());
        for (std::size_t k = 1; k < on_side.size(); ++k)
            if (const std::size_t a = on_side[k - 1].second, b = on_side[k].second; a != b)
                cuts.insert({std::min(a, b), std::max(a, b)});
    }
    return cuts;
}

bool in_any(const std::vector<Outline>& curves, Vec2 point) {
    return std::any_of(curves.begin(), curves.end(), [&](const Outline& c) { return contains(c, point); });
}

double clockwise_angle(Vec2 from, Vec2 to) {
    const double angle = std::atan2(-cross(from, to), from.dot(to));
    return angle > 1e-12 ? angle : angle + 2 * std::numbers::pi;
}

/// Joins cut sides, each with the inside on its left, into loops.
std::vector<Outline> loops_of(const std::vector<Cut>& cuts, const Points& points) {
    std::multimap<std::size_t, std::size_t> leaving;
    for (const Cut& cut : cuts) leaving.insert(cut);
    std::vector<Outline> loops;
    while (!leaving.empty()) {
        const std::size_t start = leaving.begin()->first;
        std::size_t before = start, at = leaving.begin()->second;
        leaving.erase(leaving.begin());
        Outline loop{points[start]};
        while (at != start) {
            loop.push_back(points[at]);
            const auto [first, last] = leaving.equal_range(at);
            if (first == last) throw InputError("has sides that do not close");
            const Vec2 back = points[before] - points[at];
            const auto next = std::min_element(first, last, [&](const auto& a, const auto& b) {
                return clockwise_angle(back, points[a.second] - points[at]) <
                       clockwise_angle(back, points[b.second] - points[at]);
            });
            before = at;
            at = next->second;
            leaving.erase(next);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// Without the corners at which the way goes straight on.
Outline without_straight(const Outline& loop, double room) {
    Outline out;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2& before = out.empty() ? loop.back() : out.back();
        const Vec2 way = loop[(k + 1) % loop.size()] - before;
        if (std::abs(cross(loop[k] - before, way)) > 0.01 * room * way.norm()) out.push_back(loop[k]);
    }
    return out;
}

/// A loop that meets a point twice, parted there.
void part_at_points(Outline loop, std::vector<Outline>& parts) {
    for (std::size_t i = 0; i < loop.size(); ++i)
        for (std::size_t j = i + 1; j < loop.size(); ++j) {
            if (loop[i] != loop[j]) continue;
            const auto at = [&](std::size_t k) { return loop.begin() + static_cast<std::ptrdiff_t>(k); };
            Outline inner(at(i), at(j));
            loop.erase(at(i), at(j));
            part_at_points(std::move(inner), parts);
            part_at_points(std::move(loop), parts);
            return;
        }
    if (loop.size() > 2) parts.push_back(std::move(loop));
}

bool is_simple(const Outline& curve) {
    try {
        check_outline(curve);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

double lowest(const Outline& curve) {
    return std::min_element(curve.begin(), curve.end(),
                            [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); })
        ->y();
}

void sort_from_below(std::vector<Outline>& outlines) {
    std::stable_sort(outlines.begin(), outlines.end(), [](const Outline& a, const Outline& b) {
        const double difference = lowest(a) - lowest(b);
        if (difference != 0) return difference < 0;
        return area_moments(a).centroid.x() > area_moments(b).centroid.x();  // starboard first
    });
}

}  // namespace

double signed_area(const Outline& curve) {
    double twice = 0;
    for (std::size_t k = 0; k < curve.size(); ++k) twice += cross(curve[k], curve[(k + 1) % curve.size()]);
    return twice / 2;
}

std::optional<Vec2> self_crossing(const Outline& curve) {
    const std::vector<Side> sides = sides_of(curve);
    const double room = same_point * extent_of_all({curve});
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size(); ++j)
            if (const auto at = crossing(sides[i], sides[j], room)) return at;
    return std::nullopt;
}

ClosedOutlines closed_outlines(const std::vector<Outline>& added, const std::vector<Outline>& taken_away) {
    ClosedOutlines all;
    if (added.size() == 1 && taken_away.empty() && is_simple(added.front())) {  // as it is written
        all.outlines = added;
        if (signed_area(added.front()) < 0)
            std::reverse(all.outlines.front().begin() + 1, all.outlines.front().end());
        return all;
    }
    std::vector<Outline> curves = added;
    curves.insert(curves.end(), taken_away.begin(), taken_away.end());
    std::vector<Side> sides;
    for (const Outline& curve : curves)
        for (const Side& side : sides_of(curve)) sides.push_back(side);
    const double extent = extent_of_all(curves), room = same_point * extent;
    if (!(extent > 0)) return all;
    Points points(room);
    std::vector<Cut> kept;
    const auto inside = [&](Vec2 point) { return in_any(added, point) && !in_any(taken_away, point); };
    for (const auto& [a, b] : cut_sides(sides, points, room)) {
        const Vec2 way = points[b] - points[a];
        const Vec2 beside = 5 * room * Vec2(-way.y(), way.x()) / way.norm();
        const Vec2 middle = 0.5 * (points[a] + points[b]);
        const bool left = inside(middle + beside), right = inside(middle - beside);
        if (left != right) kept.push_back(left ? Cut{a, b} : Cut{b, a});
    }
    for (const Outline& loop : loops_of(kept, points)) {
        std::vector<Outline> parts;
        part_at_points(without_straight(loop, room), parts);
        for (Outline& part : parts) {
            const double area = signed_area(part);
            if (std::abs(area) < 10 * room * extent) continue;
            (area > 0 ? all.outlines : all.holes).push_back(std::move(part));
        }
    }
    sort_from_below(all.outlines);
    return all;
}

}  // namespace wetdeck
