// SPDX-License-Identifier: BSD-3-Clause
#include "solver/bodies/contact.hpp"

#include <limits>

namespace wetdeck {
namespace {

/// How far a point is behind a surface, and the surface's normal there.
struct Behind {
    double depth = 0;  ///< negative in front [m]
    Vec2 normal = Vec2::Zero();
};

/// A face of the tank: the points with (point - on).normal = 0.
struct Face {
    Vec2 on, normal;

    Behind of(Vec2 point) const { return {(on - point).dot(normal), normal}; }
};

double cross(Vec2 a, Vec2 b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The surface of a body as others meet it.
struct Surface {
    const RigidBody& body;

    Behind of(Vec2 point) const {
        const Vec2 local = body.local(point);
        double nearest2 = std::numeric_limits<double>::infinity(), area = 0;
        Vec2 foot = Vec2::Zero(), side = Vec2::Zero();
        bool inside = false;
        const std::vector<Vec2>& c = body.corners;
        for (std::size_t k = 0, before = c.size() - 1; k < c.size(); before = k++) {
            const Vec2 a = c[before], ab = c[k] - a;
            area += cross(a, c[k]);
            const Vec2 at = a + std::clamp((local - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) * ab;
            if ((c[k].y() > local.y()) != (a.y() > local.y()) &&
                local.x() < a.x() + (local.y() - a.y()) / ab.y() * ab.x())
                inside = !inside;
            if ((local - at).squaredNorm() >= nearest2) continue;
            nearest2 = (local - at).squaredNorm();
            foot = at;
            side = ab;
        }
        const Vec2 outwards = (area > 0 ? 1 : -1) * Vec2(side.y(), -side.x()).normalized();
        return {(inside ? 1 : -1) * (local - foot).norm(), body.axes() * outwards};
    }
};

/// What a body does under a unit force, by degree of freedom.
struct Mobility {
    Vec2 linear = Vec2::Zero();  ///< 1/mass where free [m/kg]
    double angular = 0;          ///< 1/inertia where free [1/(kg m)]

    explicit Mobility(const RigidBody& b) {
        for (int k = 0; k < 2; ++k)
            if (b.free[static_cast<std::size_t>(k)]) linear[k] = 1 / (b.mass + b.excess_mass());
        if (b.free[2]) angular = 1 / (b.inertia + b.excess_inertia());
    }
    /// Acceleration along `normal` at the moment arm `lever` under a load.
    double approach(Vec2 normal, double lever, const BodyLoad& load) const {
        return normal.dot(linear.cwiseProduct(load.force)) + angular * lever * load.torque;
    }
};

/// Visits each corner of `body` that is behind `surface` or closer to it than `margin`.
template <class SurfaceType, class Visit>
void for_each_corner(const RigidBody& body, const SurfaceType& surface, double margin, const Visit& visit) {
    for (const Vec2& corner : body.corners) {
        const Vec2 arm = body.axes() * corner;
        const Behind behind = surface.of(body.position + arm);
        if (behind.depth > -margin) visit(arm, behind);
    }
}

/// Of the farthest corner about the mass centre [m].
double reach_of(const RigidBody& body) {
    double reach2 = 0;
    for (const Vec2& corner : body.corners) reach2 = std::max(reach2, corner.squaredNorm());
    return std::sqrt(reach2);
}

/// Adds the loads of the corners of one body behind one surface; `other` is the body of that surface.
template <class SurfaceType>
void push(RigidBody& body, RigidBody* other, const SurfaceType& surface, const ContactLaw& law) {
    const double zeta = damping_ratio(law.restitution);
    const Mobility own(body);
    BodyLoad unit, unit_other;
    const auto arm_of_other = [&](Vec2 arm) { return Vec2(arm + body.position - other->position); };
    for_each_corner(body, surface, 0, [&](Vec2 arm, const Behind& at) {
        unit.force += at.normal;
        unit.torque += cross(arm, at.normal);
        if (!other) return;
        unit_other.force -= at.normal;
        unit_other.torque -= cross(arm_of_other(arm), at.normal);
    });
    if (unit.force.isZero() && unit.torque == 0) return;
    for_each_corner(body, surface, 0, [&](Vec2 arm, const Behind& at) {
        const double lever = cross(arm, at.normal);
        double approach = own.approach(at.normal, lever, unit);
        double alone = own.approach(at.normal, lever, {at.normal, lever});
        Vec2 speed = body.velocity_at(arm);
        if (other) {
            const Mobility others(*other);
            const double reach = cross(arm_of_other(arm), at.normal);
            approach -= others.approach(at.normal, reach, unit_other);
            alone += others.approach(at.normal, reach, {at.normal, reach});
            speed -= other->velocity_at(arm_of_other(arm));
        }
        if (!(alone > 0)) return;  // neither can move
        const double mass = 1 / (approach > 0 ? approach : alone);
        const Vec2 force = law.force(zeta, at.depth, -speed.dot(at.normal), mass) * at.normal;
        body.contact.force += force;
        body.contact.torque += cross(arm, force);
        if (!other) return;
        other->contact.force -= force;
        other->contact.torque -= cross(arm_of_other(arm), force);
    });
}

/// The largest eigenvalue of K M^-1 is at most its trace.
template <class SurfaceType>
double frequency2(const RigidBody& body, const RigidBody* other, const SurfaceType& surface, double stiffness,
                  double margin) {
    const Mobility own(body);
    double sum = 0;
    for_each_corner(body, surface, margin, [&](Vec2 arm, const Behind& at) {
        const double lever = cross(arm, at.normal);
        sum += own.approach(at.normal, lever, {at.normal, lever});
        if (!other) return;
        const double reach = cross(arm + body.position - other->position, at.normal);
        sum += Mobility(*other).approach(at.normal, reach, {at.normal, reach});
    });
    return stiffness * sum;
}

/// Calls visit(body, other or nullptr, surface) for each surface that a body may touch.
template <class Bodies, class Visit>
void for_each_pair(Bodies& bodies, Box tank, double margin, const Visit& visit) {
    const Face faces[] = {{tank.low, {0, 1}}, {tank.high, {0, -1}}, {tank.low, {1, 0}}, {tank.high, {-1, 0}}};
    for (auto& body : bodies) {
        const double reach = reach_of(body) + margin;
        for (const Face& face : faces)
            if (face.of(body.position).depth > -reach) visit(body, nullptr, face);
        for (auto& other : bodies) {
            const double distance = (body.position - other.position).norm();
            if (&other != &body && distance < reach + reach_of(other)) visit(body, &other, Surface{other});
        }
    }
}

}  // namespace

void set_contact_loads(std::vector<RigidBody>& bodies, Box tank, const ContactLaw& law) {
    for (RigidBody& body : bodies) body.contact = {};
    for_each_pair(bodies, tank, 0, [&](RigidBody& body, RigidBody* other, const auto& surface) {
        push(body, other, surface, law);
    });
}

double contact_frequency(const std::vector<RigidBody>& bodies, Box tank, const ContactLaw& law,
                         double margin) {
    double highest2 = 0;
    for_each_pair(bodies, tank, margin,
                  [&](const RigidBody& body, const RigidBody* other, const auto& surface) {
                      highest2 += frequency2(body, other, surface, law.stiffness, margin);
                  });
    return std::sqrt(highest2);
}

}  // namespace wetdeck
