// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the scheme away from where they are used: dam break and, for the limits, every body.
#include <fmt/format.h>

#include <cmath>

#include "validation/stress/cases.hpp"
#include "validation/stress/scene_trial.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::stress {
namespace {

using Parameter = void (*)(Model&, double);

Trial dam_break_with(const Scheme& scheme, Parameter set, double value) {
    return trial_of(dam_break(), scheme, [=](Model& model) { set(model, value); });
}

std::vector<Setting> dam_breaks(Parameter set, const std::vector<double>& values, double quick) {
    std::vector<Setting> settings;
    for (const double value : values)
        settings.push_back({fmt::format("{:g}", value),
                            [=](const Scheme& s) { return dam_break_with(s, set, value); }, value == quick});
    return settings;
}

std::vector<Setting> skins(const std::vector<double>& values, double quick) {
    std::vector<Setting> settings;
    for (const double value : values) {
        SceneCase scene = dam_break();
        scene.overrides.push_back(fmt::format("execution.skin={}", value));
        settings.push_back({fmt::format("{:g}", value),
                            [scene](const Scheme& s) { return trial_of(scene, s); }, value == quick});
    }
    return settings;
}

/// @param scene  a SceneCase or an Entry
template <typename Scene>
Search limit(std::string name, const Scene& scene, std::string quantity, Parameter set, double from,
             double to) {
    return {std::move(name), std::move(quantity), from, to, 1.1, [=](double value) {
                return trial_of(scene, default_scheme, [=](Model& model) { set(model, value); });
            }};
}

/// @param length  divides the sides of all boxes; spacings are whole fractions of it
template <typename Scene>
Search spacing_limit(std::string name, Scene (*with)(double), double length, double from, double to) {
    return {std::move(name), "spacing [m]", from, to, 1.2, [=](double dx) {
                return trial_of(with(length / std::round(length / dx)), default_scheme);
            }};
}

Entry wedge_with_spacing(double dx) {
    Entry entry = wedge_entry(30);
    entry.particle_spacing = entry.gap = dx;
    return entry;
}

void set_courant(Model& m, double value) {
    m.courant_number = value;
}
void set_sound_speed(Model& m, double value) {
    m.water.eos.sound_speed = value;
}
void set_smoothing(Model& m, double value) {
    m.smoothing_ratio = value;
}
void set_background(Model& m, double value) {
    m.water.eos.background_pressure = m.air.eos.background_pressure = value;
}

Case courant() {
    Case result{"courant", "dam break, factor of the time step",
                dam_breaks(set_courant, {0.1, 0.25, 0.5, 0.75}, 0)};
    result.settings.push_back({"3", [](const Scheme& s) { return dam_break_with(s, set_courant, 3); }, true,
                               "sound travels three smoothing lengths in a step"});
    const auto search = [&](std::string name, const auto& scene) {
        result.searches.push_back(limit(std::move(name), scene, "courant_number", set_courant, 0.5, 4));
    };
    search("dam_break", dam_break());
    search("wedge", wedge_entry(30));
    search("flat_plate", flat_plate());
    search("catamaran", catamaran());
    search("sinking_rectangle", sinking_rectangle());
    return result;
}

Case background() {
    Case result{"background_pressure",
                "dam break, background pressure [Pa]",
                dam_breaks(set_background, {0, 100, 300, 1000, 3000}, 0),
                {limit("dam_break", dam_break(), "background_pressure [Pa]", set_background, 300, 1e4)}};
    result.settings.push_back(
        {"10000", [](const Scheme& s) { return dam_break_with(s, set_background, 1e4); }, false,
         "more than the air's own stiffness of 7 kPa; `check` doubts more than half of it"});
    return result;
}

/// The air's sound speed stays.
Case sound_speed() {
    Case result{"sound_speed", "dam break, sound speed of the water [m/s]",
                dam_breaks(set_sound_speed, {100, 50, 24.26, 16}, 0)};
    result.settings.push_back({"8", [](const Scheme& s) { return dam_break_with(s, set_sound_speed, 8); },
                               false, "the water's speed of 4 m/s is Mach 0.5"});
    const auto search = [&](std::string name, const auto& scene, double from, double to) {
        const char* quantity = to < from ? "sound_speed [m/s]" : "higher sound_speed [m/s]";
        result.searches.push_back(limit(std::move(name), scene, quantity, set_sound_speed, from, to));
    };
    search("dam_break", dam_break(), 24.26, 2);
    search("wedge", wedge_entry(30), 120, 10);
    search("flat_plate", flat_plate(), 60, 5);
    search("catamaran", catamaran(), 15, 1.25);
    search("sinking_rectangle", sinking_rectangle(), 12.247, 1);
    search("flat_plate", flat_plate(), 60, 600);
    search("catamaran", catamaran(), 15, 150);
    search("sinking_rectangle", sinking_rectangle(), 12.247, 120);
    return result;
}

Case spacing() {
    Case result{"spacing",
                "dam break, spacing [m]",
                {},
                {spacing_limit("dam_break", dam_break, 0.6, 0.06, 0.3),
                 spacing_limit("wedge", wedge_with_spacing, 0.2, 0.02, 0.05),
                 spacing_limit("flat_plate", flat_plate, 0.1, 0.004, 0.02),
                 spacing_limit("catamaran", catamaran, 0.08, 0.004, 0.01),
                 spacing_limit("sinking_rectangle", sinking_rectangle, 1, 1.0 / 16, 1.0 / 6)}};
    for (const double dx : {0.12, 0.1, 0.04, 0.03})
        result.settings.push_back({fmt::format("{:g}", dx),
                                   [=](const Scheme& s) { return trial_of(dam_break(dx), s); }, dx == 0.1});
    return result;
}

Setting disorder(double share, std::string beyond = {}) {
    const auto build = [share](const Scheme& scheme) {
        const Trial even = trial_of(dam_break(), scheme);
        const Simulation& s = even.simulation;
        Dice dice(1);
        const double size = share * s.particle_spacing();
        FluidParticles fluid = s.fluid();
        for (FluidState& p : fluid.state) {
            p.x += dice.symmetric(size);
            p.y += dice.symmetric(size);
        }
        return Trial{
            Simulation({s.model(), fluid, s.walls(), s.particle_spacing(), s.domain(), {}, s.execution()}),
            even.end};
    };
    return {fmt::format("{:g} spacings", share), build, share == 0.2, std::move(beyond)};
}

}  // namespace

std::vector<Case> numerical_cases() {
    return {courant(),
            sound_speed(),
            spacing(),
            background(),
            {"smoothing_ratio", "dam break, smoothing length over spacing",
             dam_breaks(set_smoothing, {1, 1.25, 1.5, 2, 2.5}, 0)},
            {"skin", "dam break, skin of the neighbour list over smoothing length",
             skins({0.05, 0.1, 0.2, 0.5, 1}, 1)},
            {"disorder",
             "dam break, particles displaced at the start by up to",
             {disorder(0.1), disorder(0.2), disorder(0.3),
              disorder(0.45, "particles of neighbouring lattice points nearly coincide")}}};
}

}  // namespace wetdeck::stress
