// SPDX-License-Identifier: BSD-3-Clause
// Two fluids further apart, or closer, than water and air.
#include <fmt/format.h>

#include <cmath>

#include "validation/stress/cases.hpp"
#include "validation/stress/scene_trial.hpp"

namespace wetdeck::stress {
namespace {

/// The air's sound speed follows the scene's rule, 0.4 of the equal-coefficient one, but sound in it is never
/// slower than in the water.
Setting density_ratio(double ratio) {
    SceneCase scene = dam_break();
    const double sound_speed = std::max(24.3, 137 * std::sqrt(ratio / 1000));
    scene.overrides.push_back(fmt::format("air.density={}", 1000 / ratio));
    scene.overrides.push_back(fmt::format("air.sound_speed={}", sound_speed));
    return {fmt::format("{:g}", ratio), [scene](const Scheme& s) { return trial_of(scene, s); }, ratio == 10};
}

Setting viscosities(double water, double air) {
    SceneCase scene = dam_break();
    scene.overrides.push_back("model.viscosity=symmetric");
    scene.overrides.push_back(fmt::format("water.viscosity={}", water));
    scene.overrides.push_back(fmt::format("air.viscosity={}", air));
    return {fmt::format("{:g} over {:g} Pa s", water, air),
            [scene](const Scheme& s) { return trial_of(scene, s); }};
}

}  // namespace

std::vector<Case> material_cases() {
    return {{"density_ratio",
             "dam break, density of the water over that of the air",
             {density_ratio(10), density_ratio(100), density_ratio(1000), density_ratio(1e4)}},
            {"viscosity_ratio",
             "dam break, viscosity of the water over that of the air",
             {viscosities(1e-3, 1e-5), viscosities(10, 1e-5), viscosities(1e-3, 0.1), viscosities(1e-3, 1)}}};
}

}  // namespace wetdeck::stress
