// SPDX-License-Identifier: BSD-3-Clause
// Which ingredients a scene has, and what an ablation study runs.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/scene/ingredients.hpp"

using namespace wetdeck;

namespace {

Scene small(const std::string& variant, const std::vector<std::string>& overrides = {}) {
    return parse_scene(samples::small_scene, "small.toml", variant, overrides);
}

std::vector<std::string> names(const Scene& scene) {
    std::vector<std::string> all;
    for (const Ingredient& one : ingredients_of(scene)) all.push_back(one.name);
    return all;
}

}  // namespace

TEST_CASE("only what a scene has can be left out of it") {
    CHECK(names(small("two-phase")) ==
          std::vector<std::string>{"air", "hydrostatic correction", "water dissipation", "air dissipation",
                                   "wall dissipation", "mirrored wall velocity", "Shepard wall pressure",
                                   "background pressure", "pressure diffusion", "density bound",
                                   "steps of the air"});
    CHECK(names(small("single-phase")) ==
          std::vector<std::string>{"hydrostatic correction", "water dissipation", "wall dissipation",
                                   "mirrored wall velocity", "Shepard wall pressure", "pressure diffusion",
                                   "density bound", "wetting of walls"});
    CHECK(names(small("single-phase", {"model.dissipation=riemann", "model.viscosity=symmetric",
                                       "model.wall_dissipation=0", "model.dissipation_switch=true"})) ==
          std::vector<std::string>{"viscosity", "hydrostatic correction", "Riemann dissipation",
                                   "mirrored wall velocity", "Shepard wall pressure", "pressure diffusion",
                                   "density bound", "wetting of walls", "switched dissipation"});
    // the harmonic mean of pressures needs the background
    const auto harmonic = names(small("two-phase", {"model.pressure_mean=harmonic"}));
    CHECK(std::count(harmonic.begin(), harmonic.end(), "background pressure") == 0);
}

TEST_CASE("what is left out is gone from the scene, and nothing else") {
    for (const char* variant : {"two-phase", "single-phase"}) {
        const std::vector<std::string> before = names(small(variant));
        for (const Ingredient& one : ingredients_of(small(variant))) {
            if (one.name == "air") continue;  // takes with it what needs air
            CAPTURE(variant, one.name);
            std::vector<std::string> left = before;
            left.erase(std::find(left.begin(), left.end(), one.name));
            CHECK(names(small(variant, one.off)) == left);
        }
    }
    CHECK_FALSE(small("two-phase", ingredients_of(small("two-phase")).front().off).air);
}

TEST_CASE("the plan leaves out one at a time, and adds one at a time to the minimal model") {
    const Scene scene = small("two-phase");
    const AblationPlan plan = ablation_plan(scene);
    REQUIRE(plan.runs.front().name == "full");
    REQUIRE(plan.runs.front().overrides.empty());
    std::set<std::string> run_names;
    for (const AblationRun& run : plan.runs) run_names.insert(run.name);
    CHECK(run_names.size() == plan.runs.size());
    // eleven left out, the switch added, ten put into the minimal model
    REQUIRE(plan.pairs.size() == 11 + 1 + 10);
    REQUIRE(plan.runs.size() == 1 + 11 + 1 + 1 + 10);
    const auto of = [&](std::size_t run) { return names(small("two-phase", plan.runs[run].overrides)); };
    for (const AblationPair& pair : plan.pairs) {
        if (pair.ingredient == "air") continue;
        CAPTURE(pair.ingredient);
        // it takes the air's own steps along, so that it is compared with the model without them
        if (pair.ingredient == "switched dissipation (added)")
            CHECK(plan.runs[pair.without].overrides == std::vector<std::string>{"model.air_substeps=1"});
        CHECK(of(pair.with).size() == of(pair.without).size() + 1);
        const bool minimal = pair.ingredient.rfind("minimal model and ", 0) == 0;
        if (minimal) CHECK(of(pair.without) == std::vector<std::string>{"air"});
    }
}

TEST_CASE("a scene with the switched dissipation has it left out, not added") {
    const AblationPlan plan = ablation_plan(small("two-phase", {"model.dissipation_switch=true"}));
    const auto switches = std::count_if(plan.pairs.begin(), plan.pairs.end(), [](const AblationPair& pair) {
        return pair.ingredient.rfind("switched dissipation", 0) == 0;
    });
    CHECK(switches == 1);
    for (const AblationPair& pair : plan.pairs) CHECK(pair.ingredient != "switched dissipation (added)");
}

TEST_CASE("every run of the plan of every scene that comes with the program can be read") {
    for (const std::string& name : scene_names()) {
        for (const VariantInfo& variant : read_scene(find_scene(name)).variants) {
            const Scene scene = read_scene(find_scene(name), variant.name);
            for (const AblationRun& run : ablation_plan(scene).runs) {
                CAPTURE(name, variant.name, run.name);
                CHECK_NOTHROW(read_scene(find_scene(name), variant.name, run.overrides));
            }
        }
    }
}
