// SPDX-License-Identifier: BSD-3-Clause
// The ingredients of a scene's model that can be left out, one at a time.
#pragma once

#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

struct Ingredient {
    std::string name;
    std::vector<std::string> off;  ///< KEY=VALUE that leave it out
};

/// Those that the scene has, air first.
std::vector<Ingredient> ingredients_of(const Scene& scene);

/// A run of an ablation study: the scene with some ingredients out, or one more in.
struct AblationRun {
    std::string name;  ///< "full", "without-air", "minimal", ...: that of its directory
    std::vector<std::string> overrides;
};

/// Two runs that differ in one ingredient.
struct AblationPair {
    std::string ingredient;
    std::size_t with = 0, without = 0;  ///< numbers of runs
};

struct AblationPlan {
    std::vector<AblationRun> runs;  ///< the full model first
    std::vector<AblationPair> pairs;
};

/// The full model less each ingredient; the full model and the same with the switched dissipation of Yang et
/// al. (2020), where the scene does without and has equal spacings, else with growth or coarsest spacing
/// halved; the minimal model, which has none of its ingredients but air (the scene would be another one
/// without), with each of them.
AblationPlan ablation_plan(const Scene& scene);

}  // namespace wetdeck
