// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/identity.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "solver/physics/wetting.hpp"
#include "solver/scheme_revision.hpp"
#include "solver/time/time_step.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/store/hash.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

json vector_json(const Vec2& v) {
    return {v.x(), v.y()};
}

json boxes_json(const std::vector<Box>& boxes) {
    json all = json::array();
    for (const Box& box : boxes) all.push_back({vector_json(box.low), vector_json(box.high)});
    return all;
}

json body_json(const BodySpec& spec) {
    const RigidBody& body = spec.body;
    json outline = json::array();
    for (const Vec2& corner : spec.outline) outline.push_back(vector_json(corner));
    json all = {{"outline", outline},
                {"position", vector_json(body.position)},
                {"angle", body.angle},
                {"mass", body.mass},
                {"inertia", body.inertia},
                {"free", body.free},
                {"velocity", vector_json(body.velocity)},
                {"angular_velocity", body.angular_velocity},
                {"applied_force", vector_json(body.applied_force)},
                {"applied_torque", body.applied_torque}};
    // bodies of before there were such keys stay the same
    if (!spec.guide.empty()) all["guide"] = spec.guide;
    if (spec.solid) all["solid"] = true;
    return all;
}

}  // namespace

json parameters_json(const Scene& scene) {
    json parameters = {{"gravity_x", scene.model.gravity.x()}, {"gravity_y", scene.model.gravity.y()}};
    for (const auto& [key, value] : parameters_of(scene))
        std::visit([&parameters, &name = key](const auto& v) { parameters[name] = v; }, value);
    if (const auto& resolution = scene.resolution) {
        parameters["resolution.around"] = boxes_json({resolution->box}).at(0);
        parameters["resolution.growth"] = resolution->growth;
        parameters["resolution.coarsest"] = resolution->coarsest;
    }
    return parameters;
}

json setup_json(const Scene& scene) {
    Scene resolved = scene;
    resolved.model.air_substeps = scene.air ? air_substeps(scene.model) : 1;
    resolved.model.wall_wetting = wets_walls(scene.model, scene.air);
    resolved.execution.threads = 0;
    json parameters = parameters_json(resolved);
    // runs of before there was a choice stay the same set-up
    if (scene.execution.precision == Precision::double_precision) parameters.erase("execution.precision");
    if (!takes_coarse_substeps(scene)) parameters.erase("model.coarse_substeps");
    json bodies = json::array();
    for (const BodySpec& body : scene.bodies) bodies.push_back(body_json(body));
    json setup = {{"scheme_revision", scheme_revision},
                  {"parameters", std::move(parameters)},
                  {"tank", vector_json(scene.tank.high)},
                  {"water_boxes", boxes_json(scene.water_boxes)},
                  {"air_boxes", boxes_json(scene.air ? scene.air_boxes : std::vector<Box>{})},
                  {"bodies", bodies},
                  {"initial",
                   {static_cast<int>(scene.initial.law), scene.initial.surface, scene.initial.released_face}},
                  {"probes", scene.probe_text},
                  {"end_time", scene.end_time},
                  {"sample_interval", scene.sample_interval},
                  {"force_filter", scene.force_filter},
                  {"frame_times", scene.frame_times}};
    if (scene.symmetry) setup["symmetry"] = *scene.symmetry;
    if (!scene.tank_guide.empty()) setup["tank_motion"] = scene.tank_guide;
    if (!scene.water_velocities.empty()) {
        setup["water_velocities"] = json::array();
        for (const Vec2& velocity : scene.water_velocities)
            setup["water_velocities"].push_back(vector_json(velocity));
    }
    if (scene.arrangement != 0) setup["arrangement"] = scene.arrangement;
    return setup;
}

std::string setup_identity(const Scene& scene) {
    return fmt::format("{:016x}", fnv1a(setup_json(scene).dump()));
}

}  // namespace wetdeck
