// SPDX-License-Identifier: BSD-3-Clause
#include "validation/stress/scene_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/physics/mixed_precision.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/penetration_monitor.hpp"
#include "validation/scene/schemes.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck::stress {
namespace {

Trial assembled(Scene scene, double particle_spacing, double end, const Scheme& scheme,
                const Change& change) {
    apply_scheme(scheme, scene.model);
    if (change) change(scene.model);
    scene.execution.precision = default_precision(scene.model);
    return Trial{assemble(scene, particle_spacing, 1), end, penetration_monitor(scene)};
}

std::string text_of(const Entry& e) {
    std::string corners;
    for (const auto& corner : e.outline) corners += fmt::format("[{}, {}], ", corner[0], corner[1]);
    return fmt::format(
        R"toml(schema = 1
name = "entry"
title = "Entry"
purpose = "to be survived"
source = "none"
gravity = [0.0, -9.81]
default_variant = "two-phase"
limits = []
variants.two-phase.description = "water and air"
tank.size = [{width}, {height}]
initial = {{ pressure = "hydrostatic", surface = {depth} }}
model = {{ air = true, background_pressure = {background} }}
run = {{ end_time = {end}, sample_interval = {end} }}
{resolution}
[water]
density = 1000.0
sound_speed = {sound_speed}
exponent = 7.0
viscosity = 1.0e-3
boxes = [[0.0, 0.0, {width}, {depth}]]
[air]
density = 1.0
exponent = 1.4
viscosity = 1.0e-5
law = "physical"
boxes = [[0.0, {depth}, {width}, {height}]]
[body]
outline = [{corners}]
position = [{middle}, {keel}]
free = {free}
mass = {mass}
velocity_y = {velocity}
)toml",
        fmt::arg("width", e.tank[0]), fmt::arg("height", e.tank[1]), fmt::arg("depth", e.depth),
        fmt::arg("background", e.background_pressure), fmt::arg("sound_speed", e.sound_speed),
        fmt::arg("corners", corners), fmt::arg("middle", 0.5 * e.tank[0]), fmt::arg("keel", e.depth + e.gap),
        fmt::arg("free", e.mass > 0 ? "['y']" : "[]"), fmt::arg("mass", e.mass),
        fmt::arg("velocity", -e.speed), fmt::arg("end", (e.gap + e.travel) / e.speed),
        fmt::arg("resolution", e.graded ? "resolution = { around = 'body', growth = 0.1 }" : ""));
}

/// The scene's own variant of a scheme, which knows the background pressure that its means need, or the
/// variant of the case.
std::string variant_for(const SceneCase& scene, const Scheme& scheme) {
    if (scheme.empty()) return scene.variant;
    for (const VariantInfo& variant : read_scene(find_scene(scene.scene)).variants)
        if (variant.scheme == scheme) return variant.name;
    return scene.variant;
}

/// The set-up alone. Probes, quantities and all else that stands behind it in the file as an array of tables
/// belong to the tank of the scene, which a case may change.
Scene set_up_of(const SceneCase& scene, const std::string& variant) {
    const std::filesystem::path path = find_scene(scene.scene);
    const std::string text = read_whole_file(path);
    std::vector<std::string> overrides = scene.overrides;
    overrides.emplace_back("error_quantity=\"\"");
    return parse_scene(text.substr(0, text.find("\n[[")) + "\n", path.string(), variant, overrides);
}

const char* const whole_tank = "symmetry.x=\"none\"";  ///< asymmetry may grow

}  // namespace

Trial trial_of(const SceneCase& scene, const Scheme& scheme, const Change& change) {
    return assembled(set_up_of(scene, variant_for(scene, scheme)), scene.particle_spacing, scene.end, scheme,
                     change);
}

SceneCase dam_break(double particle_spacing) {
    return {"dam_break",
            "two-phase",
            particle_spacing,
            1.2,
            {"tank.size=[3.6,1.8]", "air.boxes=[[1.2,0.0,3.6,0.6],[0.0,0.6,3.6,1.8]]"}};
}

SceneCase flat_plate(double particle_spacing) {
    const std::string outline = fmt::format("[[-0.125, 0], [0.125, 0], [0.125, {0}], [-0.125, {0}]]",
                                            std::max(0.02, 3 * particle_spacing));
    return {"flat_plate", "two-phase", particle_spacing, 0.0085, {"body.outline=" + outline, whole_tank}};
}

SceneCase catamaran(double particle_spacing) {
    const double outside = 0.28 + std::max(0.012, 3 * particle_spacing);
    const std::string outline = fmt::format(
        "[[0, 0], [0.28, 0.1305661], [0.28, -0.03], [{0}, -0.03], [{0}, 0.1605661], [-{0}, 0.1605661], "
        "[-{0}, -0.03], [-0.28, -0.03], [-0.28, 0.1305661]]",
        outside);
    return {"catamaran", "air-model-1", particle_spacing, 0.02, {"body.outline=" + outline, whole_tank}};
}

SceneCase sinking_rectangle(double particle_spacing) {
    return {"sinking_rectangle", "two-phase", particle_spacing, 4};
}

void Entry::scale_to(double new_speed) {
    const double ratio = new_speed / speed;
    speed = new_speed;
    sound_speed *= ratio;
    background_pressure *= ratio * ratio;
}

Entry wedge_entry(double deadrise_degrees) {
    constexpr double half_width = 0.25, side = 0.16;
    const double rise = half_width * std::tan(deadrise_degrees * std::numbers::pi / 180);
    Entry entry;
    if (rise > 0) entry.outline.push_back({0, 0});
    for (const auto& corner : {std::array{half_width, rise}, std::array{half_width, rise + side},
                               std::array{-half_width, rise + side}, std::array{-half_width, rise}})
        entry.outline.push_back(corner);
    entry.tank[1] = entry.depth + 0.2 * std::ceil((entry.gap + rise + side + 0.1) / 0.2);
    return entry;
}

Trial trial_of(const Entry& entry, const Scheme& scheme, const Change& change) {
    return assembled(parse_scene(text_of(entry), "entry.toml"), entry.particle_spacing,
                     entry.travel / entry.speed, scheme, change);
}

}  // namespace wetdeck::stress
