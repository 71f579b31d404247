// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/ingredients.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "validation/scene/model_keys.hpp"

namespace wetdeck {
namespace {

std::string dashed(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

constexpr const char *air = "air", *steps_of_the_air = "steps of the air",
                     *differing_spacings = "differing spacings";

}  // namespace

std::vector<Ingredient> ingredients_of(const Scene& scene) {
    std::vector<Ingredient> all;
    for (const ModelKey& row : model_keys()) {
        if (row.removal && row.removal->present(scene))
            all.push_back({row.removal->ingredient, row.removal->overrides(scene)});
    }
    if (scene.resolution) all.push_back({differing_spacings, {"resolution.coarsest=1"}});
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
    if (const auto& resolution = scene.resolution) {
        const auto halved = [&](const char* key, double value) {
            return std::vector<std::string>{fmt::format("resolution.{}={}", key, 0.5 * value)};
        };
        plan.pairs.push_back(
            {"growth of spacings (halved)", 0, add("half the growth", halved("growth", resolution->growth))});
        plan.pairs.push_back(
            {"coarsest spacing (halved)", 0,
             add("half the coarsest spacing", halved("coarsest", std::max(2.0, resolution->coarsest)))});
    } else if (!scene.model.dissipation_switch) {
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
