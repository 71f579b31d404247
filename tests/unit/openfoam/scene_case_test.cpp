// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/scene_case.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "validation/openfoam/case_folder.hpp"

using namespace wetdeck;
using Catch::Matchers::Contains;

namespace {

Scene shipped(const std::string& name, const std::string& variant,
              const std::vector<std::string>& overrides = {}) {
    return read_scene(find_scene(name), variant, overrides);
}

}  // namespace

TEST_CASE("The dam break becomes a closed tank with all of its water and the gauges") {
    const SceneCase written = scene_case(shipped("dam_break", "two-phase"), 0.04);
    CHECK(written.foam.solver() == "interFoam");
    const std::vector<double> shares = shares_in(written.foam.mesh, written.foam.water_boxes);
    double water = 0;
    for (std::size_t c = 0; c < shares.size(); ++c) water += shares[c] * written.foam.mesh.area(c);
    CHECK(water == Approx(1.2 * 0.6));
    CHECK(written.foam.reference.has_value());
    std::vector<std::string> names;
    for (const FoamGauge& gauge : written.gauges) names.push_back(gauge.series);
    for (const char* name : {"front", "pressure_gauge", "level_1"})
        CHECK(std::count(names.begin(), names.end(), name) == 1);
    for (const FoamGauge& gauge : written.gauges)
        for (const FoamProbes& probes : written.foam.probes)
            if (probes.name == gauge.object) CHECK(probes.points.size() == gauge.weights.size());
}

TEST_CASE("A plate of constant speed is at rest in a stream, half of it, with compressible air") {
    const SceneCase written = scene_case(shipped("flat_plate", "constant-velocity"), 0.01);
    CHECK(written.foam.solver() == "compressibleInterFoam");
    CHECK(written.foam.stream.y() == Approx(5.5));
    CHECK(written.force_factor == 2);
    CHECK(written.foam.air_pressure == Approx(101325).epsilon(1e-3));
    const auto files = foam_files(written.foam);
    CHECK_THAT(files.at("constant/thermophysicalProperties.water"), Contains("gamma 7"));
    CHECK(files.count("0/T") == 1);
}

TEST_CASE("A wedge of constant speed becomes a conformal mesh until its chine is wet") {
    const SceneCase written = scene_case(shipped("wedge", "constant-velocity"), 0.02);
    CHECK(written.foam.solver() == "interFoam");
    CHECK(written.foam.stream.y() == Approx(6.15));
    CHECK(written.foam.end_time == Approx(0.0182).epsilon(0.01));
    CHECK_THAT(foam_differences(shipped("wedge", "constant-velocity"), written), Contains("water alone"));
}

TEST_CASE("A flat wedge has an open boundary above its side, too") {
    const Scene scene = shipped(
        "wedge", "constant-velocity",
        {"body.outline=[[0.0, 0.0], [0.25, 0.03], [-0.25, 0.03]]", "probes.face_pressure.to=[0.25, 0.03]"});
    const SceneCase written = scene_case(scene, 0.02);
    std::size_t open = 0;
    for (const PlaneMesh::Side& side : written.foam.mesh.boundary) open += side.patch == "atmosphere" ? 1 : 0;
    CHECK(open > 2);
}

TEST_CASE("Scenes that fit no mesh are refused with the reason and what is supported") {
    const auto refusal = [](const Scene& scene) {
        try {
            scene_case(scene, 0.01);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    CHECK_THAT(refusal(shipped("wedge", "two-phase")),
               Contains("constant speed") && Contains("supported are"));
    CHECK_THAT(refusal(shipped("sinking_rectangle", "two-phase")), Contains("constant speed"));
    CHECK_THAT(refusal(shipped("catamaran", "constant-velocity")), Contains("supported are"));
    CHECK_THAT(refusal(shipped("flat_plate", "constant-velocity", {"model.air=false"})), Contains("no air"));
    CHECK_THROWS_AS(scene_case(shipped("dam_break", "two-phase"), 1.0), InputError);
    CHECK_THROWS_AS(scene_case(shipped("dam_break", "two-phase"), 1e-4), InputError);
}

TEST_CASE("What every case needs: precise times, slip, a clean start, an empty layer") {
    for (const auto& [scene, variant] :
         {std::pair("dam_break", "two-phase"), std::pair("wedge", "constant-velocity"),
          std::pair("flat_plate", "constant-velocity")}) {
        const auto files =
            foam_files(scene_case(shipped(scene, variant), 0.02 * (scene[0] == 'f' ? 0.5 : 1)).foam);
        CHECK_THAT(files.at("system/controlDict"),
                   Contains("timePrecision 10") && Contains("writePrecision 10"));
        CHECK_THAT(files.at("run.sh"), Contains("rm -rf postProcessing") && Contains("WM_PROJECT_DIR"));
        CHECK_THAT(files.at("constant/polyMesh/boundary"), Contains("sides { type empty"));
        CHECK_THAT(files.at("0/U"), Contains("slip"));
        CHECK_THAT(files.at("0/alpha.water"), Contains("nonuniform"));
    }
}

TEST_CASE("The hash of a case changes with what decides its results") {
    const Scene scene = shipped("dam_break", "two-phase");
    const std::string hash = case_hash(scene_case(scene, 0.04));
    CHECK(hash == case_hash(scene_case(scene, 0.04)));
    CHECK(hash != case_hash(scene_case(scene, 0.05)));
    CHECK(hash != case_hash(scene_case(scene, 0.04, 0.5)));
}
