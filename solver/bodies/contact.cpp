// SPDX-License-Identifier: BSD-3-Clause
#include "solver/bodies/contact.hpp"

#include <limits>

#include "solver/core/cross.hpp"

namespace wetdeck {
namespace {

/// A corner behind a surface.
struct Touch {
    Vec2 at;           ///< [m]
    Vec2 normal;       ///< along the push on the first body of the pair
    double depth = 0;  ///< negative in front [m]
};
using Touches = std::vector<Touch>;

/// One side of an outline, placed.
struct Side {
    Vec2 from, to, outwards;

    double distance(Vec2 point) const {
        const Vec2 along = to - from;
        const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        return (point - from - t * along).norm();
    }
    /// Whether a ray from the point to the left crosses it.
    bool crosses_ray(Vec2 point) const {
        return (from.y() > point.y()) != (to.y() > point.y()) &&
               point.x() > from.x() + (point.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
    }
};

/// The sides of a body; side k begins at corner k.
std::vector<Side> sides_of(const RigidBody& body) {
    const std::size_t n = body.corners.size();
    const Eigen::Matrix2d axes = body.axes();
    double area = 0;
    for (std::size_t k = 0; k < n; ++k) area += cross(body.corners[k], body.corners[(k + 1) % n]);
    std::vector<Side> sides;
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 from = axes * body.corners[k], to = axes * body.corners[(k + 1) % n];
        const Vec2 right = Vec2((to - from).y(), (from - to).x()).normalized();
        sides.push_back({body.position + from, body.position + to, area > 0 ? right : Vec2(-right)});
    }
    return sides;
}

bool inside(const std::vector<Side>& sides, Vec2 point) {
    bool odd = false;
    for (const Side& side : sides) odd ^= side.crosses_ray(point);
    return odd;
}

/// The way out of a body for a corner.
struct WayOut {
    Vec2 normal = Vec2::Zero();  ///< of the side through which the corner came, or the mean of two
    double distance = std::numeric_limits<double>::infinity();  ///< [m]
};

/// A corner has come through a side that faces one of the two sides beside it, near and squarely: the least
/// distance over the cosine of the angle between their normals tells. Where two sides are as likely, at a
/// corner that meets a corner, the way leads between them.
WayOut way_out(const Side& before, const Side& after, const std::vector<Side>& other) {
    constexpr double parallel = 1e-9, alike = 1e-6;
    WayOut way;
    double least = std::numeric_limits<double>::infinity();
    for (const Side& side : other) {
        const double cosine =
            -std::min(side.outwards.dot(before.outwards), side.outwards.dot(after.outwards));
        if (cosine < parallel) continue;
        const double distance = side.distance(after.from), score = distance / cosine;
        if (score > (1 + alike) * least) continue;
        if (score < (1 - alike) * least) way = {Vec2::Zero(), distance};
        way.normal += side.outwards;
        least = std::min(least, score);
    }
    way.normal.normalize();
    return way;
}

/// Adds the corners of one outline that are inside another or closer to it than `margin`. `sign` turns the
/// push on the corner into that on the first body of the pair.
void add_corners(const std::vector<Side>& own, const std::vector<Side>& other, double margin, double sign,
                 Touches& touches) {
    for (std::size_t k = 0; k < own.size(); ++k) {
        const Side &after = own[k], &before = own[(k + own.size() - 1) % own.size()];
        const WayOut way = way_out(before, after, other);
        if (!std::isfinite(way.distance)) continue;
        // a corner on the line of a side is inside if the body behind the corner is
        const double nudge = 1e-9 * (after.to - after.from).norm();
        const bool behind = inside(other, after.from - nudge * (after.outwards + before.outwards));
        if (!behind && way.distance >= margin) continue;
        touches.push_back({after.from, sign * way.normal, (behind ? 1 : -1) * way.distance});
    }
}

/// All corners of either body that are inside the other, or closer to it than `margin` [m].
Touches touches_of(const RigidBody& body, const RigidBody& other, double margin) {
    const std::vector<Side> sides = sides_of(body), others = sides_of(other);
    Touches touches;
    add_corners(sides, others, margin, 1, touches);
    add_corners(others, sides, margin, -1, touches);
    return touches;
}

/// The same of the corners behind a face of the tank through the point `on`.
Touches touches_of(const RigidBody& body, Vec2 on, Vec2 normal, double margin) {
    const Eigen::Matrix2d axes = body.axes();
    Touches touches;
    for (const Vec2& corner : body.corners) {
        const Vec2 at = body.position + axes * corner;
        const double depth = (on - at).dot(normal);
        if (depth > -margin) touches.push_back({at, normal, depth});
    }
    return touches;
}

/// What a body does under a unit force, by degree of freedom.
struct Mobility {
    Vec2 linear = Vec2::Zero();  ///< 1/mass where free [m/kg]
    double angular = 0;          ///< 1/inertia about the turning point where free [1/(kg m)]

    explicit Mobility(const RigidBody& b) {
        for (int k = 0; k < 2; ++k)
            if (b.forced(k)) linear[k] = 1 / (b.mass + b.excess_mass());
        if (b.forced(2)) angular = 1 / (b.turning_inertia() + b.excess_inertia());
    }
    /// Acceleration along `normal` at the moment arm `lever` under a load, both about the turning point.
    double approach(Vec2 normal, double lever, const BodyLoad& load) const {
        return normal.dot(linear.cwiseProduct(load.force)) + angular * lever * load.torque;
    }
};

/// Of the farthest corner about the mass centre [m].
double reach_of(const RigidBody& body) {
    double reach2 = 0;
    for (const Vec2& corner : body.corners) reach2 = std::max(reach2, corner.squaredNorm());
    return std::sqrt(reach2);
}

/// Approach of a pair at a corner under one unit force there: 1/m of that corner alone [m/kg].
double approach_alone(const RigidBody& body, const RigidBody* other, const Touch& touch) {
    const auto of = [&](const RigidBody& b) {
        const double lever = cross(touch.at - b.turning_point(), touch.normal);
        return Mobility(b).approach(touch.normal, lever, {touch.normal, lever});
    };
    return of(body) + (other ? of(*other) : 0);
}

/// Adds the loads of the corners in touch to a body and, if there is one, to the other.
void push(RigidBody& body, RigidBody* other, const Touches& touches, const ContactLaw& law) {
    const double zeta = damping_ratio(law.restitution);
    BodyLoad unit, unit_other;  // of unit forces at all corners
    const auto add = [](BodyLoad& load, Vec2 about, Vec2 at, Vec2 force) {
        load.force += force;
        load.torque += cross(at - about, force);
    };
    for (const Touch& touch : touches) {
        add(unit, body.turning_point(), touch.at, touch.normal);
        if (other) add(unit_other, other->turning_point(), touch.at, -touch.normal);
    }
    for (const Touch& touch : touches) {
        const double alone = approach_alone(body, other, touch);
        if (!(alone > 0)) continue;  // neither can move
        const Vec2 arm = touch.at - body.position;
        double approach =
            Mobility(body).approach(touch.normal, cross(touch.at - body.turning_point(), touch.normal), unit);
        Vec2 speed = body.velocity_at(arm);
        if (other) {
            const Vec2 arm_of_other = touch.at - other->position;
            const double lever = cross(touch.at - other->turning_point(), touch.normal);
            approach -= Mobility(*other).approach(touch.normal, lever, unit_other);
            speed -= other->velocity_at(arm_of_other);
        }
        const double mass = 1 / (approach > 0 ? approach : alone);
        const Vec2 force = law.force(zeta, touch.depth, -speed.dot(touch.normal), mass) * touch.normal;
        add(body.contact, body.position, touch.at, force);
        if (other) add(other->contact, other->position, touch.at, -force);
    }
}

/// Calls visit(body, other or nullptr, touches) for each pair in touch or closer to it than `margin` [m].
template <class Bodies, class Visit>
void for_each_pair(Bodies& bodies, Box tank, double margin, const Visit& visit) {
    const std::pair<Vec2, Vec2> faces[] = {
        {tank.low, {0, 1}}, {tank.high, {0, -1}}, {tank.low, {1, 0}}, {tank.high, {-1, 0}}};
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        auto& body = bodies[b];
        const double reach = reach_of(body) + margin;
        for (const auto& [on, normal] : faces)
            if ((body.position - on).dot(normal) < reach)
                visit(body, nullptr, touches_of(body, on, normal, margin));
        for (std::size_t o = 0; o < b; ++o) {
            auto& other = bodies[o];
            if ((body.position - other.position).norm() < reach + reach_of(other))
                visit(body, &other, touches_of(body, other, margin));
        }
    }
}

}  // namespace

void set_contact_loads(std::vector<RigidBody>& bodies, Box tank, const ContactLaw& law) {
    for (RigidBody& body : bodies) body.contact = {};
    for_each_pair(bodies, tank, 0, [&](RigidBody& body, RigidBody* other, const Touches& touches) {
        push(body, other, touches, law);
    });
}

double contact_frequency(const std::vector<RigidBody>& bodies, Box tank, const ContactLaw& law,
                         double margin) {
    // the largest eigenvalue of K M^-1 is at most its trace
    double highest2 = 0;
    for_each_pair(bodies, tank, margin,
                  [&](const RigidBody& body, const RigidBody* other, const Touches& touches) {
                      for (const Touch& touch : touches)
                          highest2 += law.stiffness * approach_alone(body, other, touch);
                  });
    return std::sqrt(highest2);
}

}  // namespace wetdeck
