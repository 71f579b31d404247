// SPDX-License-Identifier: BSD-3-Clause
// Bodies that hit the water: fast and slow, blunt and sharp, thin, close to it, heavy and light.
#include <fmt/format.h>

#include "validation/stress/cases.hpp"
#include "validation/stress/scene_trial.hpp"

namespace wetdeck::stress {
namespace {

Setting setting(std::string name, const Entry& entry, bool quick = false) {
    return {std::move(name), [entry](const Scheme& s) { return trial_of(entry, s); }, quick};
}

Setting speed(double metres_per_second) {
    Entry entry = wedge_entry(30);
    entry.scale_to(metres_per_second);
    return setting(fmt::format("{:g} m/s", metres_per_second), entry, metres_per_second == 20);
}

Setting deadrise(double degrees) {
    return setting(fmt::format("{:g} degrees", degrees), wedge_entry(degrees));
}

constexpr double plate_spacing = 0.01;  // [m]

Entry box(double width, double height) {
    Entry entry;
    entry.outline = {{-0.5 * width, 0}, {0.5 * width, 0}, {0.5 * width, height}, {-0.5 * width, height}};
    entry.tank = {1.2, 0.7};
    entry.depth = 0.4;
    entry.particle_spacing = plate_spacing;
    entry.speed = 5.5;
    entry.sound_speed = 60;  // of the scene flat_plate
    entry.background_pressure = 2000;
    entry.travel = 0.05;
    return entry;
}

/// As thin as the kernel's support, three spacings, and less.
std::vector<Setting> thin_plates() {
    std::vector<Setting> settings;
    for (const double spacings : {3.1, 4.0, 6.0})
        settings.push_back(
            setting(fmt::format("flat, {:g} spacings", spacings), box(0.25, spacings * plate_spacing)));
    settings.push_back(setting("edge on, 3.1 spacings", box(3.1 * plate_spacing, 0.15)));
    return settings;
}

Setting film(double spacings) {
    Entry entry = box(0.25, 4 * plate_spacing);
    entry.gap = spacings * entry.particle_spacing;
    entry.travel = 0.03;
    return setting(fmt::format("{:g} spacings", spacings), entry);
}

Setting graded(std::string name, Entry entry, bool quick = false) {
    entry.graded = true;
    return setting(std::move(name), entry, quick);
}

Setting graded(std::string name, SceneCase scene) {
    scene.overrides.emplace_back("resolution.around=body");
    return {std::move(name), [scene](const Scheme& s) { return trial_of(scene, s); }};
}

/// Bodies among particles that grow away from them.
std::vector<Setting> graded_entries() {
    Entry fast = wedge_entry(30), film = box(0.25, 4 * plate_spacing);
    fast.scale_to(30);
    film.gap = film.particle_spacing;
    film.travel = 0.03;
    return {graded("wedge of 30 degrees, 6.15 m/s", wedge_entry(30), true),
            graded("wedge of 30 degrees, 30 m/s", fast),
            graded("wedge of 10 degrees, 6.15 m/s", wedge_entry(10)),
            graded("wedge of 60 degrees, 6.15 m/s", wedge_entry(60)),
            graded("box, 6.15 m/s", wedge_entry(0)),
            graded("plate, one spacing above the water", film),
            graded("plate edge on, 3.1 spacings", box(3.1 * plate_spacing, 0.15)),
            graded("flat_plate", flat_plate()),
            graded("catamaran", catamaran())};
}

/// The scene sinking_rectangle, of even density: it starts half submerged and turns where it is unstable.
Trial floating_box(const Scheme& scheme, double over_water) {
    const double mass = 0.5 * over_water, inertia = mass * (1 + 0.25) / 12;
    return trial_of(SceneCase{"sinking_rectangle",
                              "two-phase",
                              1.0 / 12,
                              2,
                              {"body.mass_centre=[0.0,0.0]", fmt::format("body.mass={}", mass),
                               fmt::format("body.inertia={}", inertia)}},
                    scheme);
}

Setting density(double over_water) {
    return {fmt::format("{:g} of the water", over_water),
            [=](const Scheme& s) { return floating_box(s, over_water); }, over_water == 20};
}

}  // namespace

std::vector<Case> entry_cases() {
    return {{"entry_speed",
             "wedge of 30 degrees, speed",
             {speed(1), speed(3), speed(6.15), speed(10), speed(20), speed(30)}},
            {"deadrise",
             "wedge at 6.15 m/s, deadrise",
             {deadrise(0), deadrise(4), deadrise(10), deadrise(30), deadrise(60)}},
            {"thin_plate", "plate at 5.5 m/s, thickness", thin_plates()},
            {"air_film", "plate at 5.5 m/s, air under it at the start", {film(4), film(2), film(1)}},
            {"graded", "entry among particles that grow away from the body", graded_entries()},
            {"body_density",
             "floating or sinking box, density",
             {density(0.02), density(0.1), density(0.5), density(2), density(20)},
             {{"floating box", "density over that of the water", 0.5, 0.02, 1.1,
               [](double over_water) { return floating_box(default_scheme, over_water); }}}}};
}

}  // namespace wetdeck::stress
