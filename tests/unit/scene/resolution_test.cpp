// SPDX-License-Identifier: BSD-3-Clause
// [resolution] in scene files: what it makes of a scene, and what is refused.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/field_frame.hpp"
#include "validation/scene/identity.hpp"
#include "validation/scene/ingredients.hpp"
#include "validation/scene/resolution_section.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

/// A layer of water below a layer of air, with whatever else is asked for.
Scene layer(const std::vector<std::string>& more, const char* variant = "two-phase") {
    std::vector<std::string> overrides = {"water.boxes=[[0.0,0.0,1.0,0.2]]",
                                          "air.boxes=[[0.0,0.2,1.0,0.48]]"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return parse_scene(samples::small_scene, "scene.toml", variant, overrides);
}

std::string refused(const std::vector<std::string>& more) {
    try {
        layer(more);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

const std::vector<std::string> box_body = {"body.outline=[[-0.05,0.0],[0.05,0.0],[0.05,0.04],[-0.05,0.04]]",
                                           "body.position=[0.5,0.22]", "body.velocity_y=-1.0",
                                           "run.end_time=0.05", "run.frames=[]"};

std::vector<std::string> with_body(std::vector<std::string> more) {
    more.insert(more.begin(), box_body.begin(), box_body.end());
    return more;
}

}  // namespace

TEST_CASE("a resolution around a body holds it from its start to its end", "[resolution][scene]") {
    const Scene scene = layer(with_body({"resolution.around=body"}));
    REQUIRE(scene.resolution);
    const Box& box = scene.resolution->box;
    CHECK(box.low.y() < 0.22 - 0.05);
    CHECK(box.high.y() > 0.26);
    CHECK(box.low.x() < 0.45);
    CHECK(box.low.x() == Approx(1 - box.high.x()));
    CHECK(scene.resolution->growth == 0.05);
    CHECK(scene.resolution->coarsest == 8);
}

TEST_CASE("a graded scene has fewer particles, the same masses, and each its fineness",
          "[resolution][scene]") {
    const std::vector<std::string> more = {"resolution.around=[0.4,0.15,0.6,0.25]", "resolution.coarsest=4",
                                           "resolution.growth=0.1"};
    const Scene graded = layer(more), equal = layer({});
    const auto mass = [](const Simulation& simulation) {
        double sum = 0;
        for (std::size_t i = 0; i < simulation.fluid().water; ++i) sum += simulation.fluid().mass[i];
        return sum;
    };
    const Simulation coarse = assemble(graded, 0.01, 1), fine = assemble(equal, 0.01, 1);
    CHECK(coarse.graded());
    CHECK_FALSE(fine.graded());
    CHECK(coarse.fluid().size() < fine.fluid().size() / 2);
    CHECK(mass(coarse) == Approx(mass(fine)).epsilon(1e-5));
    CHECK(estimate_cost(graded, 0.01).fluid_particles == static_cast<double>(coarse.fluid().size()));
    CHECK(setup_identity(graded) != setup_identity(equal));
    CHECK(parameters_json(graded).at("resolution.coarsest") == 4);
    CHECK_FALSE(parameters_json(equal).contains("resolution.coarsest"));
    const FieldFrame frame = frame_of(coarse, "");
    REQUIRE(frame.spacing.size() == frame.x.size());
    CHECK(*std::max_element(frame.spacing.begin(), frame.spacing.end()) > 0.025F);
    CHECK(frame_of(fine, "").spacing.empty());
}

TEST_CASE("with a coarsest spacing of once the finest all spacings are equal", "[resolution][scene]") {
    const Scene equal = layer({"resolution.around=surface", "resolution.coarsest=1"});
    CHECK_FALSE(equal.resolution);
    CHECK(setup_identity(equal) == setup_identity(layer({})));
}

TEST_CASE("an ablation study halves growth and coarsest spacing, and does without", "[resolution][scene]") {
    const Scene graded = layer({"resolution.around=surface"});
    std::vector<std::string> names;
    for (const AblationRun& run : ablation_plan(graded).runs) {
        names.push_back(run.name);
        std::vector<std::string> overrides = {"resolution.around=surface"};
        overrides.insert(overrides.end(), run.overrides.begin(), run.overrides.end());
        CHECK_NOTHROW(layer(overrides));
    }
    CHECK_THAT(names, Catch::VectorContains(std::string("without-differing-spacings")) &&
                          Catch::VectorContains(std::string("half-the-growth")) &&
                          Catch::VectorContains(std::string("half-the-coarsest-spacing")));
}

TEST_CASE("a scene that cannot have differing spacings says why", "[resolution][scene]") {
    CHECK(refused({"resolution.around=surface"}) == "");
    CHECK_THAT(refused({"resolution.around=body"}), Contains("the scene has none"));
    CHECK_THAT(refused({"resolution.around=bodies"}), Contains("expected") && Contains("surface"));
    CHECK_THAT(refused({"resolution.around=[0.4]"}), Contains("a point [x, y] or a box"));
    CHECK_THAT(refused({"resolution.around=[0.4,0.1,0.3,0.2]"}), Contains("from its lower left corner"));
    CHECK_THAT(refused({"resolution.around=[0.4,0.1,1.3,0.2]"}), Contains("in the tank"));
    CHECK_THAT(refused({"resolution.around=[0.5,0.1]"}), Contains("does not reach the level at 0.2 m"));
    CHECK_THAT(refused({"resolution.around=surface", "resolution.growth=0.3"}), Contains("at most 0.2"));
    CHECK_THAT(refused({"resolution.around=surface", "resolution.growth=0"}), Contains("above 0"));
    CHECK_THAT(refused({"resolution.around=surface", "resolution.coarsest=0.5"}), Contains("from 1 (equal"));
    CHECK_THAT(refused({"resolution.around=surface", "resolution.coarsest=40"}), Contains("to 16"));
    CHECK_THAT(refused({"resolution.around=surface", "resolution.finest=-1"}), Contains("positive spacing"));
    CHECK_THAT(refused({"resolution.around=surface", "model.dissipation_switch=true"}),
               Contains("needs equal spacings: model.dissipation_switch"));
    CHECK_THAT(refused({"water.boxes=[[0.0,0.0,0.4,0.2]]", "air.boxes=[[0.4,0.0,1.0,0.2],[0.0,0.2,1.0,0.48]]",
                        "resolution.around=surface"}),
               Contains("not one layer from wall to wall"));
    CHECK_THAT(refused(with_body({"resolution.around=[0.5,0.2]"})), Contains("body is not in it"));
}

TEST_CASE("a long graded run is doubted for the currents that gravity drives", "[resolution][scene]") {
    CHECK_FALSE(doubtful_currents(layer(with_body({"resolution.around=body"}))));
    CHECK_FALSE(doubtful_currents(layer(with_body({"run.end_time=5"}))));
    const auto doubt = doubtful_currents(layer(with_body({"resolution.around=body", "run.end_time=5"})));
    REQUIRE(doubt);
    CHECK_THAT(*doubt, Contains("0.25 m/s by the end at 5 s"));
}

TEST_CASE("a gauge where particles are coarse is judged by their spacing there", "[resolution][scene]") {
    // 0.08 m on the right wall: eight spacings of the finest, less than one of the coarsest
    const std::vector<std::string> more = {"resolution.around=[0.1,0.2]", "resolution.growth=0.2",
                                           "resolution.coarsest=16"};
    CHECK_NOTHROW(check_spacing(layer({}), 0.01));
    CHECK_THROWS_WITH(check_spacing(layer(more), 0.01), Contains("smaller than the particle spacing"));
}

TEST_CASE("coarse water takes longer steps where there is no air", "[resolution][scene]") {
    const std::vector<std::string> around = {"resolution.around=[0.4,0.15,0.6,0.25]",
                                             "resolution.growth=0.2"};
    const auto with = [&](const char* variant, const char* more) {
        std::vector<std::string> overrides = around;
        if (more) overrides.emplace_back(more);
        return layer(overrides, variant);
    };
    const Scene alone = with("single-phase", nullptr),
                asked = with("single-phase", "model.coarse_substeps=5");
    CHECK(takes_coarse_substeps(alone));
    CHECK(assemble(alone, 0.01, 1).substeps() > 1);
    CHECK(assemble(asked, 0.01, 1).substeps() == 5);
    CHECK(assemble(with("single-phase", "model.coarse_substeps=1"), 0.01, 1).substeps() == 1);
    CHECK(setup_identity(alone) != setup_identity(asked));
    CHECK(estimate_cost(alone, 0.01).particle_steps <
          0.9 * estimate_cost(with("single-phase", "model.coarse_substeps=1"), 0.01).particle_steps);

    const Scene air = with("two-phase", "model.coarse_substeps=5");
    CHECK_FALSE(takes_coarse_substeps(air));
    CHECK(assemble(air, 0.01, 1).model().coarse_substeps == 1);
    CHECK(setup_identity(air) == setup_identity(with("two-phase", nullptr)));
    CHECK_FALSE(takes_coarse_substeps(layer({}, "single-phase")));
    std::vector<std::string> names;
    for (const AblationRun& run : ablation_plan(alone).runs) names.push_back(run.name);
    CHECK_THAT(names, Catch::VectorContains(std::string("without-longer-steps-of-coarse-water")));
}
