// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/body_mass.hpp"

namespace wetdeck {

void read_mass(const TomlTable& table, const AreaMoments& moments, BodySpec& spec) {
    RigidBody& body = spec.body;
    if (table.has("density")) {
        if (table.has("mass")) table.fail("density", "is given beside 'mass', expected one of the two");
        body.mass = table.positive("density") * moments.area;
    } else {
        body.mass = body.free[0] || body.free[1] ? table.positive("mass") : table.number_or("mass", 0);
    }
    const Vec2 beside = body.position - moments.centroid;
    spec.even_inertia = body.mass * (moments.second_moment / moments.area + beside.squaredNorm());
    body.inertia = table.number_or("inertia", spec.even_inertia);
    if (!body.free[2] || body.inertia > 0) return;
    if (table.has("inertia")) table.fail("inertia", "expected a positive number [kg m]");
    table.fail("mass", table.has("mass") ? "expected a positive number [kg/m]"
                                         : "missing: a body that is free to turn needs its mass [kg/m], from "
                                           "which its inertia follows, or its inertia [kg m]");
}

}  // namespace wetdeck
