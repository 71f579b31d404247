// SPDX-License-Identifier: BSD-3-Clause
// The list of hard cases, one stable run and one that becomes unstable.
#include "validation/stress/cases.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/schemes.hpp"
#include "validation/stress/scene_trial.hpp"

using namespace wetdeck;
using namespace wetdeck::stress;

TEST_CASE("Cases and their settings have names of their own", "[stress]") {
    std::set<std::string> names;
    for (const Case& member : all_cases()) {
        INFO(member.name);
        CHECK(names.insert(member.name).second);
        CHECK_FALSE(member.settings.empty());
        std::set<std::string> settings;
        for (const Setting& setting : member.settings) CHECK(settings.insert(setting.name).second);
        std::set<std::string> searches;
        for (const Search& search : member.searches)
            CHECK(searches.insert(search.name + search.quantity).second);
    }
    CHECK(cases_named({}).size() == all_cases().size());
    CHECK(cases_named({"skin", "courant"}).front().name == "courant");
    CHECK_THROWS_AS(cases_named({"courant", "kraken"}), InputError);
}

TEST_CASE("Time step, sound speed and spacing have limits searched in every scene", "[stress]") {
    for (const Case& member : cases_named({"courant", "sound_speed", "spacing"})) {
        std::set<std::string> scenes;
        for (const Search& search : member.searches) scenes.insert(search.name);
        INFO(member.name);
        CHECK(scenes ==
              std::set<std::string>{"dam_break", "wedge", "flat_plate", "catamaran", "sinking_rectangle"});
    }
}

TEST_CASE("Columns that squeeze trapped air to less than a third are not asked to survive", "[stress]") {
    const Case columns = cases_named({"falling_column"}).front();
    const auto beyond = [&](const std::string& name) {
        for (const Setting& setting : columns.settings)
            if (setting.name == name) return setting.beyond;
        return std::string("missing");
    };
    CHECK(beyond("0 m/s on air of 340 m/s").empty());
    CHECK(beyond("5 m/s on air of 340 m/s").empty());
    CHECK_THAT(beyond("10 m/s on air of 340 m/s"), Catch::Contains("to 0.26 of its volume"));
    CHECK_THAT(beyond("5 m/s on air of 170 m/s"), Catch::Contains("to 0.24 of its volume"));
    CHECK_THAT(beyond("8 m/s on air of 170 m/s"), Catch::Contains("to 0.1 of its volume"));
}

TEST_CASE("Every spacing that a search may try fits its scene", "[stress]") {
    const Case spacing = cases_named({"spacing"}).front();
    for (const Search& search : spacing.searches)
        for (const double share : {0.5, 0.63, 0.77, 0.9, 1.0}) {
            const double dx = search.from * std::pow(search.to / search.from, share);
            INFO(search.name << " at " << dx << " m");
            CHECK(search.build(dx).simulation.particle_spacing() == Approx(dx).epsilon(0.25));
        }
}

TEST_CASE("A coarse dam break is stable at the time step in use and becomes unstable at six times that",
          "[stress]") {
    SceneCase scene = dam_break(0.1);
    scene.end = 0.3;
    const Outcome calm = run_trial(trial_of(scene, default_scheme));
    CHECK(calm.survived());
    CHECK(calm.energy_gain < 0.01);
    const Outcome wild =
        run_trial(trial_of(scene, default_scheme, [](Model& model) { model.courant_number = 3; }));
    REQUIRE(wild.failure);
    CHECK(wild.steps < calm.steps);
    CHECK(wild.note().rfind("became unstable at t = ", 0) == 0);
    CHECK(wild.failure->surroundings.find(" particle among ") != std::string::npos);
    CHECK(wild.failure->frame.time <= wild.failure->instability.time);
    CHECK(picture_of(*wild.failure).size() > 1000);
}

TEST_CASE("A scheme applied to a model is the scheme of a variant that names it", "[stress]") {
    const Scene variant = read_scene(find_scene("dam_break"), "paper-literal");
    Scene applied = read_scene(find_scene("dam_break"), "two-phase",
                               {"model.background_pressure=1000", "execution.precision=double"});
    REQUIRE(variant.variants.back().scheme == "yang2020-literal");
    CHECK(parameters_of(applied) != parameters_of(variant));
    apply_scheme("yang2020-literal", applied.model);
    CHECK(parameters_of(applied) == parameters_of(variant));
    CHECK_THROWS_AS(apply_scheme("kraken", applied.model), InputError);
}
