// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/plane_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

constexpr double most_pieces = 5000;

/// Pieces of an arc whose sagitta r (1 - cos(angle / 2)) is within the tolerance; none spans more than 30
/// degrees.
int pieces_of(double radius, double turn, double tolerance) {
    const double ratio = std::clamp(tolerance / radius, 1e-12, 0.5);
    const double angle = std::min(2 * std::acos(1 - ratio), std::numbers::pi / 6);
    return static_cast<int>(std::clamp(std::ceil(std::abs(turn) / angle), 1.0, most_pieces));
}

/// Points between a and b on the arc around a centre.
std::vector<Vec2> between(Vec2 a, Vec2 centre, double turn, double tolerance) {
    const Vec2 arm = a - centre;
    const int pieces = pieces_of(arm.norm(), turn, tolerance);
    std::vector<Vec2> points;
    for (int k = 1; k < pieces; ++k) {
        const double angle = turn * k / pieces, c = std::cos(angle), s = std::sin(angle);
        points.push_back(centre + Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y()));
    }
    return points;
}

void check(const Spline& spline) {
    const std::size_t n = spline.control.size(), p = spline.degree;
    if (p < 1 || p > 10) throw InputError(fmt::format("is of degree {}, expected 1 to 10", p));
    if (n < p + 1)
        throw InputError(
            fmt::format("has {} control points, expected {} or more (fit points alone do not "
                        "say what the curve is)",
                        n, p + 1));
    if (spline.knots.size() != n + p + 1)
        throw InputError(fmt::format("has {} knots, expected {}", spline.knots.size(), n + p + 1));
    if (!spline.weights.empty() && spline.weights.size() != n)
        throw InputError(fmt::format("has {} weights, expected {}", spline.weights.size(), n));
    if (!std::is_sorted(spline.knots.begin(), spline.knots.end())) throw InputError("has knots that fall");
    if (!(spline.knots[p] < spline.knots[n])) throw InputError("has knots that span nothing");
    for (const double weight : spline.weights)
        if (!(weight > 0)) throw InputError("has a weight that is not positive");
}

double off_chord(Vec2 point, Vec2 a, Vec2 b) {
    const Vec2 way = b - a;
    if (way.squaredNorm() == 0) return (point - a).norm();
    const double along = std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (point - a - along * way).norm();
}

struct Stretch {
    double begin, end;
    Vec2 first, last;
};

void add_chords(const Spline& spline, const Stretch& s, double tolerance, int depth, std::vector<Vec2>& out) {
    bool near = depth > 0;  // each stretch is halved at least once
    for (const double share : {0.25, 0.5, 0.75})
        near = near && off_chord(point_on(spline, s.begin + share * (s.end - s.begin)), s.first, s.last) <=
                           0.5 * tolerance;
    if (near || depth >= 12) {
        out.push_back(s.last);
        return;
    }
    const double middle = 0.5 * (s.begin + s.end);
    const Vec2 point = point_on(spline, middle);
    add_chords(spline, {s.begin, middle, s.first, point}, tolerance, depth + 1, out);
    add_chords(spline, {middle, s.end, point, s.last}, tolerance, depth + 1, out);
}

}  // namespace

std::vector<Vec2> arc_by_radius(Vec2 a, Vec2 b, double radius, double tolerance) {
    const Vec2 way = b - a;
    const double half = way.norm() / 2, size = std::abs(radius);
    if (half == 0) return {};
    if (half > 1.001 * size)
        throw InputError(
            fmt::format("two points {:.4g} m apart cannot lie on an arc of radius {:.4g} m", 2 * half, size));
    const double share = std::min(1.0, half / size);
    const double to_centre = std::sqrt(std::max(0.0, size * size - half * half));
    const double hand = radius > 0 ? 1 : -1;
    const Vec2 left(-way.y(), way.x());
    const Vec2 centre = a + way / 2 + hand * to_centre * left / left.norm();
    return between(a, centre, hand * 2 * std::asin(share), tolerance);
}

std::vector<Vec2> arc_by_bulge(Vec2 a, Vec2 b, double bulge, double tolerance) {
    const Vec2 way = b - a, left(-way.y(), way.x());
    if (bulge == 0 || way.squaredNorm() == 0) return {};
    // the centre lies at (1 - bulge^2) / (4 bulge) chords to the left of the middle
    const Vec2 centre = a + way / 2 + (1 - bulge * bulge) / (4 * bulge) * left;
    return between(a, centre, 4 * std::atan(bulge), tolerance);
}

std::vector<Vec2> arc_by_angles(Vec2 centre, double radius, double begin, double turn, double tolerance) {
    const auto at = [&](double angle) -> Vec2 {
        return centre + radius * Vec2(std::cos(angle), std::sin(angle));
    };
    std::vector<Vec2> points{at(begin)};
    for (const Vec2& point : between(points.front(), centre, turn, tolerance)) points.push_back(point);
    points.push_back(at(begin + turn));
    return points;
}

Vec2 point_on(const Spline& spline, double parameter) {
    const std::size_t n = spline.control.size(), p = spline.degree;
    const auto& t = spline.knots;
    std::size_t span = p;
    while (span + 1 < n && t[span + 1] <= parameter) ++span;
    std::vector<Eigen::Vector3d> d;
    for (std::size_t j = span - p; j <= span; ++j) {
        const double weight = spline.weights.empty() ? 1 : spline.weights[j];
        d.emplace_back(weight * spline.control[j].x(), weight * spline.control[j].y(), weight);
    }
    for (std::size_t r = 1; r <= p; ++r)
        for (std::size_t j = p; j >= r; --j) {
            const std::size_t k = j + span - p;
            const double width = t[k + p - r + 1] - t[k];
            const double share = width > 0 ? (parameter - t[k]) / width : 0;
            d[j] = (1 - share) * d[j - 1] + share * d[j];
        }
    return d[p].head<2>() / d[p].z();
}

std::vector<Vec2> chords_of(const Spline& spline, double tolerance) {
    check(spline);
    const std::size_t n = spline.control.size(), p = spline.degree;
    std::vector<Vec2> points{point_on(spline, spline.knots[p])};
    for (std::size_t k = p; k < n; ++k) {
        const double begin = spline.knots[k], end = spline.knots[k + 1];
        if (!(begin < end)) continue;
        const Vec2 last = point_on(spline, k + 1 == n ? end : std::nextafter(end, begin));
        add_chords(spline, {begin, end, points.back(), last}, tolerance, 0, points);
    }
    return points;
}

}  // namespace wetdeck
