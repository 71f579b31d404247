// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/unused_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "solver/core/errors.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {
namespace {

using Condition = std::function<bool(const Scene&)>;

/// A key, whether a scene reads its value, and why not.
struct Use {
    std::string table, key;
    Condition used;
    std::string reason;
};

bool viscous(const Scene& s) {
    return s.model.viscosity != Viscosity::none;
}
bool viscous_fluid(const Scene& s) {
    return s.model.water.viscosity > 0 || (s.air && s.model.air.viscosity > 0);
}
bool has_harmonic_mean(const Scene& s) {
    return s.model.velocity_mean == Mean::harmonic || s.model.pressure_mean == Mean::harmonic ||
           s.model.impedance_mean == ImpedanceMean::harmonic ||
           s.model.wall_pair_mean == WallPairMean::harmonic;
}
bool low_dissipation(const Scene& s) {
    return s.model.dissipation == Dissipation::low_dissipation;
}
bool switched(const Scene& s) {
    return s.model.dissipation_switch;
}
bool has_air(const Scene& s) {
    return s.air;
}

std::vector<Use> uses_of_fluids() {
    const Condition air_viscous = [](const Scene& s) { return s.air && viscous(s); };
    const Condition own_speed = [](const Scene& s) { return s.air && s.air_law == "sound-speed"; };
    const Condition drags = [](const Scene& s) { return viscous(s) && viscous_fluid(s); };
    const Condition moves_air = [](const Scene& s) { return s.air && low_dissipation(s); };
    const Condition sponge = [](const Scene& s) { return s.model.sponge_thickness > 0; };
    const Condition greco = [](const Scene& s) { return s.initial.law == InitialPressure::Law::greco; };
    const Condition contact = [](const Scene& s) { return s.model.contact.on(); };
    return {
        {"water", "viscosity", viscous, "model.viscosity is none"},
        {"air", "", has_air, "model.air is false"},
        {"air", "viscosity", air_viscous, "model.viscosity is none"},
        {"air", "sound_speed", own_speed, "air.law gives the sound speed"},
        {"model", "viscosity", viscous_fluid, "no fluid has a viscosity"},
        {"model", "wall_slip", drags, "it acts through the viscosity, and there is none"},
        {"model", "air_dissipation", moves_air, "there is no air, or model.dissipation has another form"},
        {"model", "air_substeps", has_air, "model.air is false"},
        {"model", "coarse_substeps", takes_coarse_substeps, "there is no [resolution], or there is air"},
        {"model", "dissipation_slope", low_dissipation, "model.dissipation has another form"},
        {"model", "switch_velocity", switched, "model.dissipation_switch is false"},
        {"model", "mean_guard", has_harmonic_mean, "no mean is harmonic"},
        {"model", "sponge_ramp", sponge, "model.sponge_thickness is 0"},
        {"initial", "released_face", greco, "initial.pressure is hydrostatic"},
        {"contact", "", [](const Scene& s) { return !s.bodies.empty(); }, "there is no body"},
        {"contact", "restitution", contact, "contact.stiffness is 0"},
    };
}

std::vector<Use> uses_of_body(const std::string& name) {
    const auto where = [name](const std::function<bool(const RigidBody&)>& condition) -> Condition {
        return [name, condition](const Scene& s) {
            return std::any_of(s.bodies.begin(), s.bodies.end(), [&](const BodySpec& spec) {
                return spec.name == name && condition(spec.body);
            });
        };
    };
    const auto turns = where([](const RigidBody& b) { return b.free[2]; });
    const auto moves = where([](const RigidBody& b) { return b.yields(); });
    const auto pushed = where([](const RigidBody& b) {
        return (b.free[0] && b.applied_force.x() != 0) || (b.free[1] && b.applied_force.y() != 0);
    });
    const auto not_given = [&](int degree) {
        return where([degree](const RigidBody& b) { return !b.motion_of(degree) && !b.guide.pivot; });
    };
    return {{name, "velocity_x", not_given(0), "a motion or a hinge is given"},
            {name, "velocity_y", not_given(1), "a motion or a hinge is given"},
            {name, "mass", moves, "the body keeps its velocity"},
            {name, "inertia", turns, "the body is not free to turn"},
            {name, "applied_torque", turns, "the body is not free to turn"},
            {name, "applied_force", pushed, "the body is not free to move that way"}};
}

/// The scene's own text with the variant and the overrides, without schemes.
TomlDocument own_document(const Scene& scene) {
    TomlDocument document(scene.text, scene.path);
    document.overlay({"variants", scene.variant});
    for (const std::string& assignment : scene.overrides) document.set(assignment);
    return document;
}

bool is_set(const TomlTable& table, const std::string& key) {
    if (!table.has(key)) return false;
    if (key == "viscosity" || key == "wall_slip") {  // that is what they are without the key
        try {
            return table.number(key) != 0;
        } catch (const InputError&) {
            return table.text(key) != "none" && table.text(key) != "free";
        }
    }
    return key != "applied_torque" || table.number(key) != 0;
}

/// All variants but the scene's own, as far as they can be read.
std::vector<Scene> other_variants(const Scene& scene) {
    std::vector<Scene> others;
    for (const VariantInfo& variant : scene.variants) {
        if (variant.name == scene.variant) continue;
        try {
            others.push_back(parse_scene(scene.text, scene.path, variant.name, scene.overrides));
        } catch (const InputError&) {  // told where that variant is checked
        }
    }
    return others;
}

bool is_thick(const Scene& scene) {
    const Material& water = scene.model.water;
    double height = 0;
    for (const Box& box : scene.water_boxes) height = std::max(height, box.high.y());
    return water.viscosity > 0 && water.impedance() * height / water.viscosity < 1e4;
}

}  // namespace

std::vector<std::string> unused_values(const Scene& scene) {
    const TomlDocument document = own_document(scene);
    const TomlTable root = document.root();
    std::vector<Use> uses = uses_of_fluids();
    for (const BodySpec& spec : scene.bodies)
        for (Use& use : uses_of_body(spec.name)) uses.push_back(std::move(use));
    std::vector<std::string> found;
    std::optional<std::vector<Scene>> others;
    std::string unused_table;
    for (const Use& use : uses) {
        const std::optional<TomlTable> table = root.optional_table(use.table);
        if (!table || use.table == unused_table || use.used(scene)) continue;
        if (!use.key.empty() && !is_set(*table, use.key)) continue;
        if (!others) others = other_variants(scene);
        const bool elsewhere = std::any_of(others->begin(), others->end(), use.used);
        const bool matters = use.table == "water" && use.key == "viscosity" && is_thick(scene);
        if (elsewhere && !matters) continue;
        if (use.key.empty()) unused_table = use.table;
        found.push_back(use.key.empty()
                            ? fmt::format("the table [{}] is not used: {}", use.table, use.reason)
                            : fmt::format("{}.{} is not used: {}", use.table, use.key, use.reason));
    }
    return found;
}

}  // namespace wetdeck
