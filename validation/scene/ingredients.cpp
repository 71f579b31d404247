// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/ingredients.hpp"

#include <algorithm>

#include "solver/time/time_step.hpp"

namespace wetdeck {
namespace {

std::string dashed(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

constexpr const char *air = "air", *steps_of_the_air = "steps of the air";

}  // namespace

std::vector<Ingredient> ingredients_of(const Scene& scene) {
    const Model& m = scene.model;
    std::vector<Ingredient> all;
    const auto add = [&all](bool has, const char* name, std::vector<std::string> off) {
        if (has) all.push_back({name, std::move(off)});
    };
    const bool low_dissipation = m.dissipation == Dissipation::low_dissipation;
    add(scene.air, air, {"model.air=false", "model.background_pressure=0"});
    add(m.viscosity != Viscosity::none, "viscosity", {"model.viscosity=none"});
    add(m.hydrostatic_correction, "hydrostatic correction", {"model.hydrostatic_correction=false"});
    add(m.dissipation == Dissipation::riemann, "Riemann dissipation", {"model.dissipation=none"});
    // that of pairs with air must stay
    add(low_dissipation && m.dissipation_slope > 0, "water dissipation",
        {scene.air ? "model.dissipation_slope=0" : "model.dissipation=none"});
    add(low_dissipation && scene.air && m.air_dissipation > 0, "air dissipation",
        {"model.air_dissipation=0"});
    add(m.wall_dissipation > 0, "wall dissipation", {"model.wall_dissipation=0"});
    add(m.wall_velocity == WallVelocity::mirrored, "mirrored wall velocity", {"model.wall_velocity=normal"});
    add(m.wall_pressure != WallPressure::one_sided, "Shepard wall pressure",
        {"model.wall_pressure=one-sided"});
    // the harmonic mean of pressures is singular without
    add(m.water.eos.background_pressure > 0 && m.pressure_mean != Mean::harmonic, "background pressure",
        {"model.background_pressure=0"});
    add(m.pressure_diffusion > 0, "pressure diffusion", {"model.pressure_diffusion=0"});
    add(m.full_cover > 0, "density bound", {"model.full_cover=0"});
    // the switch needs the rates of each step of the air
    add(m.dissipation_switch, "switched dissipation",
        {"model.dissipation_switch=false", "model.air_substeps=1"});
    add(scene.air && air_substeps(m) > 1, steps_of_the_air, {"model.air_substeps=1"});
    return all;
}

AblationPlan ablation_plan(const Scene& scene) {
    AblationPlan plan;
    plan.runs.push_back({"full", {}});
    const auto add = [&plan](const std::string& name, std::vector<std::string> overrides) {
        plan.runs.push_back({dashed(name), std::move(overrides)});
        return plan.runs.size() - 1;
    };
    const std::vector<Ingredient> all = ingredients_of(scene);
    std::size_t without_switch = 0;  // what the switch is compared with
    for (const Ingredient& one : all) {
        const std::size_t off = add("without " + one.name, one.off);
        plan.pairs.push_back({one.name, 0, off});
        if (one.name == steps_of_the_air) without_switch = off;
    }
    if (!scene.model.dissipation_switch) {
        plan.pairs.push_back({"switched dissipation (added)",
                              add("with switched dissipation", {"model.dissipation_switch=true"}),
                              without_switch});
    }
    const auto minimal_but = [&all](const std::string& kept) {
        std::vector<std::string> overrides;
        for (const Ingredient& one : all) {
            if (one.name == air || one.name == kept) continue;
            overrides.insert(overrides.end(), one.off.begin(), one.off.end());
        }
        return overrides;
    };
    const std::size_t minimal = add("minimal", minimal_but(""));
    for (const Ingredient& one : all) {
        if (one.name == air) continue;
        plan.pairs.push_back({"minimal model and " + one.name,
                              add("minimal and " + one.name, minimal_but(one.name)), minimal});
    }
    return plan;
}

}  // namespace wetdeck
