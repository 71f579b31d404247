// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/contact_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace wetdeck {
namespace {

struct Hull {
    std::string name;
    Outline frame;      ///< corners in the frame of the body [m]
    double radius = 0;  ///< of the farthest [m]
    bool moves = false;
};

/// Where something touches, and what.
struct Touch {
    Vec2 position;
    std::string what;
    double depth = 0;      ///< [m]
    bool can_part = true;  ///< whether a force of contact can move either
};

class ContactMonitor {
  public:
    explicit ContactMonitor(const Scene& scene) : law_(scene.model.contact.on()) {
        for (const BodySpec& spec : scene.bodies) {
            const RigidBody& body = spec.body;
            Hull hull{spec.name, spec.local_outline(), 0, body.moves()};
            for (const Vec2& corner : hull.frame) hull.radius = std::max(hull.radius, corner.norm());
            hulls_.push_back(std::move(hull));
        }
    }

    bool needed() const {
        return std::any_of(hulls_.begin(), hulls_.end(), [](const Hull& hull) { return hull.moves; });
    }

    std::optional<Instability> operator()(const Simulation& simulation) const {
        const std::vector<RigidBody>& bodies = simulation.bodies();
        const double spacing = simulation.particle_spacing();
        for (std::size_t b = 0; b < hulls_.size(); ++b) {
            std::optional<Touch> touch = with_tank(hulls_[b], bodies[b], walled(simulation), spacing);
            for (std::size_t other = 0; other < b && !touch; ++other)
                touch = with_body(b, other, bodies, spacing);
            if (!touch) continue;
            return Instability{simulation.time(), simulation.steps(), std::nullopt, touch->position,
                               message(hulls_[b].name, *touch)};
        }
        return std::nullopt;
    }

  private:
    std::string message(const std::string& name, const Touch& touch) const {
        if (!law_)
            return fmt::format("{} touches {}, and the scene has no law of contact (table [contact])", name,
                               touch.what);
        if (!touch.can_part)
            return fmt::format("{} touches {}, and both move as given: no force of contact can part them",
                               name, touch.what);
        return fmt::format("{} is {:.3g} m deep in {}, more than one spacing: contact.stiffness is too low",
                           name, touch.depth, touch.what);
    }

    /// The depth from which on bodies touch: at rest on each other by the law they are not deeper than a
    /// spacing, and those that may slide along each other have their faces in line to rounding errors.
    double least_depth(bool can_part, double spacing) const {
        if (!law_) return 0;
        return can_part ? spacing : 1e-9;
    }

    static Outline placed(const Hull& hull, const RigidBody& body) {
        Outline outline;
        for (const Vec2& corner : hull.frame) outline.push_back(body.placed(corner));
        return outline;
    }

    /// The tank as far as it has walls: beyond a plane of symmetry a body goes on.
    static Box walled(const Simulation& simulation) {
        Box tank = simulation.domain();
        if (simulation.model().mirror_x) tank.low.x() = -std::numeric_limits<double>::infinity();
        return tank;
    }

    std::optional<Touch> with_tank(const Hull& hull, const RigidBody& body, const Box& tank,
                                   double spacing) const {
        const double room =
            std::min((body.position - tank.low).minCoeff(), (tank.high - body.position).minCoeff());
        if (!hull.moves || room > hull.radius) return std::nullopt;
        std::optional<Touch> deepest;
        const auto consider = [&](Vec2 corner, const char* face, std::size_t axis, double depth) {
            const bool can_part = body.free[axis] || body.free[2];
            if (depth >= least_depth(can_part, spacing) && (!deepest || depth > deepest->depth))
                deepest = {corner, fmt::format("the {}", face), depth, can_part};
        };
        for (const Vec2& corner : hull.frame) {
            const Vec2 place = body.placed(corner);
            consider(place, "floor", 1, tank.low.y() - place.y());
            consider(place, "roof", 1, place.y() - tank.high.y());
            consider(place, "left wall", 0, tank.low.x() - place.x());
            consider(place, "right wall", 0, place.x() - tank.high.x());
        }
        return deepest;
    }

    std::optional<Touch> with_body(std::size_t one, std::size_t two, const std::vector<RigidBody>& bodies,
                                   double spacing) const {
        const Hull &a = hulls_[one], &b = hulls_[two];
        const double distance = (bodies[one].position - bodies[two].position).norm();
        if ((!a.moves && !b.moves) || distance > a.radius + b.radius) return std::nullopt;
        const Outline outline = placed(a, bodies[one]), other = placed(b, bodies[two]);
        if (!overlap(outline, other)) return std::nullopt;
        Touch deepest{0.5 * (bodies[one].position + bodies[two].position), b.name, -1,
                      bodies[one].yields() || bodies[two].yields()};
        for (const auto& [mine, surface] : {std::pair(&outline, &other), std::pair(&other, &outline)}) {
            // the middles as well: the corners of two faces that lie in line stay on the other's outline
            for (std::size_t k = 0; k < mine->size(); ++k) {
                const Vec2 corner = (*mine)[k], middle = 0.5 * (corner + (*mine)[(k + 1) % mine->size()]);
                for (const Vec2& point : {corner, middle}) {
                    const double depth = -distance_to(*surface, point);
                    if (depth <= deepest.depth) continue;
                    deepest.position = point;
                    deepest.depth = depth;
                }
            }
        }
        const bool touches = !law_ || deepest.depth >= least_depth(deepest.can_part, spacing);
        return touches ? std::optional(deepest) : std::nullopt;
    }

    std::vector<Hull> hulls_;
    bool law_;
};

}  // namespace

Simulation::StabilityMonitor contact_monitor(const Scene& scene) {
    ContactMonitor monitor(scene);
    return monitor.needed() ? Simulation::StabilityMonitor(std::move(monitor))
                            : Simulation::StabilityMonitor{};
}

}  // namespace wetdeck
