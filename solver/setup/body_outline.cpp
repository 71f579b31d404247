// SPDX-License-Identifier: BSD-3-Clause
#include "solver/setup/body_outline.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "solver/core/errors.hpp"
#include "solver/setup/lattice.hpp"

namespace wetdeck {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false, true>;  // counter-clockwise, closed
using MultiPolygon = bg::model::multi_polygon<Polygon>;

Polygon polygon_of(const Outline& outline) {
    Polygon polygon;
    for (const Vec2& corner : outline) bg::append(polygon.outer(), Point(corner.x(), corner.y()));
    if (!outline.empty()) bg::append(polygon.outer(), Point(outline[0].x(), outline[0].y()));
    bg::correct(polygon);
    return polygon;
}

/// The region grown by `distance`, or shrunk where it is negative, with mitred corners.
template <class Region>
MultiPolygon offset(const Region& region, double distance) {
    namespace strategy = bg::strategy::buffer;
    constexpr double sharpest_mitre = 100;
    MultiPolygon result;
    bg::buffer(region, result, strategy::distance_symmetric<double>(distance), strategy::side_straight(),
               strategy::join_miter(sharpest_mitre), strategy::end_flat(), strategy::point_square());
    return result;
}

/// A closed ring of distinct points, counter-clockwise.
std::vector<Vec2> distinct_points(const Polygon::ring_type& ring, double tolerance) {
    std::vector<Vec2> points;
    for (const Point& p : ring) {
        const Vec2 point(p.x(), p.y());
        if (points.empty() || (point - points.back()).norm() > tolerance) points.push_back(point);
    }
    while (points.size() > 1 && (points.front() - points.back()).norm() <= tolerance) points.pop_back();
    return points;
}

struct SurfacePoint {
    Vec2 position, normal;
};

Vec2 outward_normal(Vec2 from, Vec2 to) {
    const Vec2 along = (to - from).normalized();
    return {along.y(), -along.x()};
}

/// Where a thin part ends there is no normal that serves both faces: the mean of the two reverses half the
/// velocity.
bool is_edge(Vec2 before, Vec2 after) {
    constexpr double least_turn = 75 * std::numbers::pi / 180;
    const bool convex = before.x() * after.y() - before.y() * after.x() > 0;
    return before.dot(after) < std::cos(least_turn) && convex;
}

/// Points a spacing apart along the chain of corners first, first + 1, ..., last of a ring: at its beginning,
/// and evenly up to its end, which is left to the next chain.
void space_chain(const std::vector<Vec2>& ring, std::size_t first, std::size_t last, bool sharp_start,
                 double particle_spacing, std::vector<SurfacePoint>& out) {
    const auto corner = [&](std::size_t k) { return ring[k % ring.size()]; };
    double length = 0;
    for (std::size_t k = first; k < last; ++k) length += (corner(k + 1) - corner(k)).norm();
    const int count = std::max(1, static_cast<int>(std::lround(length / particle_spacing)));
    const double step = length / count;
    std::size_t side = first;
    double before = 0;  // length of the sides before this one
    for (int k = 0; k < count; ++k) {
        const double arc = k * step;
        while (side + 1 < last && before + (corner(side + 1) - corner(side)).norm() < arc) {
            before += (corner(side + 1) - corner(side)).norm();
            ++side;
        }
        const Vec2 along = (corner(side + 1) - corner(side)).normalized();
        Vec2 normal = outward_normal(corner(side), corner(side + 1));
        if (k == 0 && sharp_start) {
            const Vec2 previous = outward_normal(corner(first + ring.size() - 1), corner(first));
            normal = is_edge(previous, normal) ? Vec2(0, 0) : Vec2((normal + previous).normalized());
        }
        out.push_back({corner(side) + (arc - before) * along, normal});
    }
}

/// Points a spacing apart around a ring; its sharp corners have one each, with the mean of the two normals
/// or, at an edge, with none.
std::vector<SurfacePoint> spaced_points(const std::vector<Vec2>& ring, double particle_spacing) {
    constexpr double sharp = 0.35;  // [rad]: a curve drawn with straight pieces turns less at each of them
    std::vector<SurfacePoint> points;
    std::vector<std::size_t> corners;
    const std::size_t n = ring.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 a = outward_normal(ring[(k + n - 1) % n], ring[k]);
        const Vec2 b = outward_normal(ring[k], ring[(k + 1) % n]);
        if (std::acos(std::clamp(a.dot(b), -1.0, 1.0)) > sharp) corners.push_back(k);
    }
    if (corners.empty()) {
        space_chain(ring, 0, n, false, particle_spacing, points);
        return points;
    }
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::size_t next = c + 1 < corners.size() ? corners[c + 1] : corners[0] + n;
        space_chain(ring, corners[c], next, true, particle_spacing, points);
    }
    return points;
}

/// What is lost where the body is shrunk by half of `width` and grown back: its parts that are thinner.
/// Less than a tenth of the width squared does not count: rounding leaves it at corners. It is grown by a
/// thousandth of the width more: the difference of outlines that all but coincide may be the whole body
/// (Boost.Geometry 1.74, three of a thousand wedges). A body that vanishes is thin, however small it is.
MultiPolygon parts_thinner_than(const Polygon& polygon, double width) {
    constexpr double least_area = 0.1;
    const double depth = 0.5 * width * (1 - 1e-3);
    const MultiPolygon shrunk = offset(polygon, -depth);
    if (shrunk.empty()) return {polygon};
    MultiPolygon lost, parts;
    bg::difference(polygon, offset(shrunk, depth + 1e-3 * width), lost);
    std::copy_if(lost.begin(), lost.end(), std::back_inserter(parts),
                 [&](const Polygon& part) { return bg::area(part) >= least_area * width * width; });
    return parts;
}

void check_thickness(const Polygon& polygon, double particle_spacing, double support) {
    const MultiPolygon thin = parts_thinner_than(polygon, support);
    if (thin.empty()) return;
    Point place(0, 0);
    bg::centroid(thin.front(), place);
    double share = 0.95;
    while (share > 0.05 && !parts_thinner_than(polygon, share * support).empty()) share -= 0.05;
    char text[200];
    std::snprintf(
        text, sizeof text,
        "the body is thinner than the kernel's support of %.4g m near (%.4g, %.4g) m: fluid would act "
        "through it; expected a particle spacing of at most %.3g m",
        support, place.x(), place.y(), share * particle_spacing);
    throw InputError(text);
}

/// The layers of points of a body, as deep as the kernel's support or as the body is thick.
std::vector<SurfacePoint> layers_of(const Polygon& polygon, double particle_spacing, double support_radius) {
    check_thickness(polygon, particle_spacing, support_radius);
    const int layers = boundary_layers(support_radius, particle_spacing);
    const double tolerance = 1e-3 * particle_spacing;
    constexpr double closest = 0.6;  // spacings: where opposite faces meet, one layer serves both
    std::vector<SurfacePoint> all;
    for (int layer = 0; layer < layers; ++layer) {
        const std::size_t before = all.size();
        // A little less deep, so that a part of a whole number of layers keeps its middle one: what is left
        // of it must be wider than the rounding of the offset, which drops slivers and would leave the part
        // hollow.
        const double depth = (layer + 0.5) * particle_spacing * (1 - 1e-4);
        for (const Polygon& part : offset(polygon, -depth)) {
            const std::vector<Vec2> ring = distinct_points(part.outer(), tolerance);
            if (ring.size() < 2) continue;
            for (const SurfacePoint& point : spaced_points(ring, particle_spacing)) {
                const bool crowded = std::any_of(all.begin() + static_cast<std::ptrdiff_t>(before), all.end(),
                                                 [&](const SurfacePoint& other) {
                                                     return (other.position - point.position).norm() <
                                                            closest * particle_spacing;
                                                 });
                if (!crowded) all.push_back(point);
            }
        }
    }
    return all;
}

/// A solid with what lies beyond the faces of the tank that it touches, to a depth [m].
Polygon grown_beyond(Box tank, const Outline& outline, double depth) {
    constexpr double tolerance = 1e-9;
    MultiPolygon grown = {polygon_of(outline)};
    const auto join = [&grown](const Outline& part) {
        MultiPolygon sum;
        bg::union_(grown, polygon_of(part), sum);
        grown = std::move(sum);
    };
    // the way out of the tank at a corner of the outline, along each axis
    const auto way_out = [&](Vec2 corner) {
        Vec2 way(0, 0);
        for (int k = 0; k < 2; ++k) {
            if (corner[k] - tank.low[k] < tolerance) way[k] = -depth;
            if (tank.high[k] - corner[k] < tolerance) way[k] = depth;
        }
        return way;
    };
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()];
        for (int axis = 0; axis < 2; ++axis) {
            const double out = way_out(a)[axis];
            if (out == 0 || out != way_out(b)[axis]) continue;
            Vec2 step(0, 0);
            step[axis] = out;
            join({a, b, b + step, a + step});
        }
        const Vec2 out = way_out(a);
        if (out.x() != 0 && out.y() != 0) join(corners_of({a.cwiseMin(a + out), a.cwiseMax(a + out)}));
    }
    return *std::max_element(grown.begin(), grown.end(),
                             [](const Polygon& a, const Polygon& b) { return bg::area(a) < bg::area(b); });
}

}  // namespace

void check_outline(const Outline& outline) {
    if (outline.size() < 3) throw InputError("an outline needs at least three corners");
    for (const Vec2& corner : outline) {
        if (!corner.allFinite()) throw InputError("an outline needs finite corners");
    }
    const Polygon polygon = polygon_of(outline);
    bg::validity_failure_type failure = bg::no_failure;
    if (!bg::is_valid(polygon, failure)) {
        const bool crosses = failure == bg::failure_self_intersections;
        throw InputError(std::string("the outline is no simple polygon: it ") +
                         (crosses ? "crosses or touches itself" : "has a spike or no width"));
    }
    if (!(bg::area(polygon) > 0)) throw InputError("the outline has no area");
}

double distance_to(const Outline& outline, Vec2 point) {
    const Polygon polygon = polygon_of(outline);
    const Point p(point.x(), point.y());
    // as a line: a closed ring counts as filled, and what is filled is at no distance from a point in it
    const bg::model::linestring<Point> line(polygon.outer().begin(), polygon.outer().end());
    const double distance = bg::distance(p, line);
    return bg::within(p, polygon) ? -distance : distance;
}

bool overlap(const Outline& a, const Outline& b) {
    return bg::intersects(polygon_of(a), polygon_of(b));
}

double shared_area(const Outline& a, const Outline& b) {
    MultiPolygon shared;
    bg::intersection(polygon_of(a), polygon_of(b), shared);
    return bg::area(shared);
}

std::vector<Outline> parts_outside(Box box, const Outline& outline) {
    MultiPolygon parts;
    bg::difference(polygon_of(corners_of(box)), polygon_of(outline), parts);
    const bool encloses =
        std::any_of(parts.begin(), parts.end(), [](const Polygon& part) { return !part.inners().empty(); });
    if (encloses) {  // an outline has no holes: two halves around it have none
        parts.clear();
        const double middle = area_moments(outline).centroid.x();
        for (const Box& half : {Box{box.low, {middle, box.high.y()}}, Box{{middle, box.low.y()}, box.high}}) {
            MultiPolygon of_half;
            bg::difference(polygon_of(corners_of(half)), polygon_of(outline), of_half);
            parts.insert(parts.end(), of_half.begin(), of_half.end());
        }
    }
    std::vector<Outline> outlines;
    for (const Polygon& part : parts) outlines.push_back(distinct_points(part.outer(), 1e-9));
    return outlines;
}

void add_body_particles(WallParticles& walls, std::uint32_t body, const Outline& outline, Vec2 frame_origin,
                        double particle_spacing, double support_radius) {
    for (const SurfacePoint& point : layers_of(polygon_of(outline), particle_spacing, support_radius))
        walls.add_body_point(body, point.position - frame_origin, point.normal);
}

void add_solid_particles(WallParticles& walls, std::uint32_t body, const Outline& outline, Vec2 frame_origin,
                         double particle_spacing, double support_radius, Box tank) {
    const double inside = 0.25 * particle_spacing;  // of the faces, beyond which the tank has its own layers
    const Polygon grown = grown_beyond(tank, outline, 2 * support_radius);
    for (const SurfacePoint& point : layers_of(grown, particle_spacing, support_radius)) {
        const Vec2 low = point.position - tank.low, high = tank.high - point.position;
        if (std::min(low.minCoeff(), high.minCoeff()) > inside)
            walls.add_body_point(body, point.position - frame_origin, point.normal);
    }
}

AreaMoments area_left(Box box, const std::vector<Outline>& outlines) {
    MultiPolygon left = {polygon_of(corners_of(box))};
    for (const Outline& outline : outlines) {
        MultiPolygon rest;
        bg::difference(left, polygon_of(outline), rest);
        left = std::move(rest);
    }
    Point centroid(box.low.x(), box.low.y());
    const double area = bg::area(left);
    if (area > 0) bg::centroid(left, centroid);
    return {area, {centroid.x(), centroid.y()}, 0};
}

void clear_fluid(FluidParticles& fluid, const Outline& outline, double particle_spacing) {
    constexpr double clearance = 0.49;  // spacings: a lattice that fits the body keeps its half
    const Polygon polygon = polygon_of(outline);
    bg::model::box<Point> reach;
    bg::envelope(polygon, reach);
    FluidParticles kept;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        const Point place(p.x, p.y);
        const bool far = p.x < reach.min_corner().x() - particle_spacing ||
                         p.x > reach.max_corner().x() + particle_spacing ||
                         p.y < reach.min_corner().y() - particle_spacing ||
                         p.y > reach.max_corner().y() + particle_spacing;
        if (!far && (bg::covered_by(place, polygon) ||
                     bg::distance(place, polygon.outer()) < clearance * particle_spacing)) {
            continue;
        }
        kept.add(fluid.phase(i), p.position(), fluid.mass[i], p.density, p.fineness);
    }
    fluid = std::move(kept);
}

}  // namespace wetdeck
