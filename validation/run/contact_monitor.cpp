// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/contact_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>

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
    double depth = 0;  ///< [m]
};

class ContactMonitor {
  public:
    explicit ContactMonitor(const Scene& scene) : law_(scene.model.contact.on()) {
        for (const BodySpec& spec : scene.bodies) {
            const RigidBody& body = spec.body;
            Hull hull{spec.name, spec.local_outline(), 0, body.free[0] || body.free[1] || body.free[2]};
            hull.moves = hull.moves || !body.velocity.isZero() || body.angular_velocity != 0;
            for (const Vec2& corner : hull.frame) hull.radius = std::max(hull.radius, corner.norm());
            hulls_.push_back(std::move(hull));
        }
    }

    bool needed() const {
        return std::any_of(hulls_.begin(), hulls_.end(), [](const Hull& hull) { return hull.moves; });
    }

    std::optional<Instability> operator()(const Simulation& simulation) const {
        const std::vector<RigidBody>& bodies = simulation.bodies();
        const double allowed = law_ ? simulation.particle_spacing() : 0;
        for (std::size_t b = 0; b < hulls_.size(); ++b) {
            std::optional<Touch> touch = with_tank(hulls_[b], bodies[b], simulation.domain(), allowed);
            for (std::size_t other = 0; other < b && !touch; ++other)
                touch = with_body(b, other, bodies, allowed);
            if (!touch) continue;
            const std::string text =
                law_ ? fmt::format(
                           "{} is {:.3g} m deep in {}, more than one spacing: contact.stiffness is too low",
                           hulls_[b].name, touch->depth, touch->what)
                     : fmt::format("{} touches {}, and the scene has no law of contact (table [contact])",
                                   hulls_[b].name, touch->what);
            return Instability{simulation.time(), simulation.steps(), std::nullopt, touch->position, text};
        }
        return std::nullopt;
    }

  private:
    static Outline placed(const Hull& hull, const RigidBody& body) {
        Outline outline;
        for (const Vec2& corner : hull.frame) outline.push_back(body.placed(corner));
        return outline;
    }

    static std::optional<Touch> with_tank(const Hull& hull, const RigidBody& body, const Box& tank,
                                          double allowed) {
        const double room =
            std::min((body.position - tank.low).minCoeff(), (tank.high - body.position).minCoeff());
        if (!hull.moves || room > hull.radius - allowed) return std::nullopt;
        std::optional<Touch> deepest;
        const auto consider = [&](Vec2 corner, const char* face, double depth) {
            if (depth >= allowed && (!deepest || depth > deepest->depth))
                deepest = {corner, fmt::format("the {}", face), depth};
        };
        for (const Vec2& corner : hull.frame) {
            const Vec2 place = body.placed(corner);
            consider(place, "floor", tank.low.y() - place.y());
            consider(place, "roof", place.y() - tank.high.y());
            consider(place, "left wall", tank.low.x() - place.x());
            consider(place, "right wall", place.x() - tank.high.x());
        }
        return deepest;
    }

    std::optional<Touch> with_body(std::size_t one, std::size_t two, const std::vector<RigidBody>& bodies,
                                   double allowed) const {
        const Hull &a = hulls_[one], &b = hulls_[two];
        const double distance = (bodies[one].position - bodies[two].position).norm();
        if ((!a.moves && !b.moves) || distance > a.radius + b.radius) return std::nullopt;
        const Outline outline = placed(a, bodies[one]), other = placed(b, bodies[two]);
        if (!overlap(outline, other)) return std::nullopt;
        Touch deepest{0.5 * (bodies[one].position + bodies[two].position), b.name, -1};
        for (const auto& [corners, surface] : {std::pair(&outline, &other), std::pair(&other, &outline)}) {
            for (const Vec2& corner : *corners) {
                const double depth = -distance_to(*surface, corner);
                if (depth > deepest.depth) deepest = {corner, b.name, depth};
            }
        }
        return deepest.depth >= allowed || !law_ ? std::optional(deepest) : std::nullopt;
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
