// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace wetdeck {
namespace {

/// A side of an outline or of the tank.
struct Side {
    Vec2 from, to;

    Vec2 along() const { return (to - from).normalized(); }
    double length() const { return (to - from).norm(); }
    /// Length from the first end to the point of the side nearest to `point`.
    double foot(Vec2 point) const { return std::clamp((point - from).dot(along()), 0.0, length()); }
    double distance(Vec2 point) const { return (from + foot(point) * along() - point).norm(); }
};

Side side(const Outline& outline, std::size_t k) {
    return {outline[k % outline.size()], outline[(k + 1) % outline.size()]};
}

std::size_t nearest_side(const Outline& outline, Vec2 point) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < outline.size(); ++k)
        if (side(outline, k).distance(point) < side(outline, best).distance(point)) best = k;
    return best;
}

/// Length of the sides next to side `first`, in steps of `step` round the outline, that belong to its face.
double length_beside(const Outline& outline, std::size_t first, std::size_t step) {
    const double least_cosine = std::cos(10 * std::numbers::pi / 180);
    double length = 0;
    for (std::size_t k = 1; k < outline.size(); ++k) {
        const Side next = side(outline, first + k * step);
        if (next.along().dot(side(outline, first).along()) < least_cosine) break;
        length += next.length();
    }
    return length;
}

}  // namespace

double snapping_distance(const Scene& scene) {
    double finest = std::numeric_limits<double>::infinity();
    for (const auto& [tier, variants] : scene.tiers)
        for (const auto& [variant, spacings] : variants)
            for (const double dx : spacings) finest = std::min(finest, dx);
    return std::isinf(finest) ? 0 : finest;
}

Box extent_of(const Outline& outline) {
    Box extent{outline.front(), outline.front()};
    for (const Vec2& corner : outline) extend(extent, corner);
    return extent;
}

bool counter_clockwise(const Outline& outline) {
    double twice_area = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const auto [a, b] = side(outline, k);
        twice_area += a.x() * b.y() - a.y() * b.x();
    }
    return twice_area > 0;
}

FacePlace nearest_wall(const Box& tank, Vec2 point) {
    const Vec2 low = tank.low, high = tank.high;
    const std::array<std::pair<const char*, Side>, 4> walls = {
        {{"the floor", {low, {high.x(), low.y()}}},
         {"the roof", {{low.x(), high.y()}, high}},
         {"the left wall", {low, {low.x(), high.y()}}},
         {"the right wall", {{high.x(), low.y()}, high}}}};
    const auto nearer = [point](const auto& a, const auto& b) {
        return a.second.distance(point) < b.second.distance(point);
    };
    const auto& [name, wall] = *std::min_element(walls.begin(), walls.end(), nearer);
    const double foot = wall.foot(point);
    const Vec2 across(-wall.along().y(), wall.along().x()), inwards = 0.5 * (low + high) - wall.from;
    const Vec2 normal = across.dot(inwards) > 0 ? across : Vec2(-across);
    return {name, wall.distance(point), wall.from + foot * wall.along(), wall.along(), normal,
            foot, wall.length() - foot};
}

FacePlace nearest_face(const Outline& outline, Vec2 point) {
    const std::size_t nearest = nearest_side(outline, point);
    const Side found = side(outline, nearest);
    const double foot = found.foot(point);
    const Vec2 right(found.along().y(), -found.along().x());
    const Vec2 normal = counter_clockwise(outline) ? right : Vec2(-right);
    return {"the face",
            found.distance(point),
            found.from + foot * found.along(),
            found.along(),
            normal,
            foot + length_beside(outline, nearest, outline.size() - 1),
            found.length() - foot + length_beside(outline, nearest, 1)};
}

std::optional<std::string> covered_for_good(const Scene& scene, Vec2 point) {
    for (const BodySpec& body : scene.bodies)
        if (!body.body.moves() && distance_to(body.outline, point) < face_tolerance) return body.name;
    return std::nullopt;
}

}  // namespace wetdeck
