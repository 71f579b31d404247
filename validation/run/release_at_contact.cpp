// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/release_at_contact.hpp"

#include <cmath>

#include "solver/probes/front.hpp"
#include "validation/metrics/time_origin.hpp"

namespace wetdeck {

ReleaseAtContact::ReleaseAtContact(const Scene& scene) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        if (scene.bodies[b].release_at_contact) waiting_.push_back({b, scene.bodies[b].local_outline()});
}

void ReleaseAtContact::operator()(Simulation& simulation) const {
    for (const Waiting& each : waiting_) {
        const RigidBody& body = simulation.bodies()[each.body];
        if (!std::isinf(body.guide.release_time)) continue;
        Outline outline;
        for (const Vec2& corner : each.outline) outline.push_back(body.placed(corner));
        if (gap_around(simulation, outline) <= contact_gap * simulation.particle_spacing())
            simulation.release(each.body);
    }
}

}  // namespace wetdeck
