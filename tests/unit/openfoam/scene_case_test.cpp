// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/scene_case.hpp"

#include <catch2/catch.hpp>

#include "solver/core/cross.hpp"
#include "solver/core/errors.hpp"
#include "validation/openfoam/case_folder.hpp"
#include "validation/store/child_process.hpp"

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

namespace {

const FoamGauge& gauge_named(const SceneCase& written, const std::string& name) {
    for (const FoamGauge& gauge : written.gauges)
        if (gauge.series == name) return gauge;
    throw std::runtime_error("no gauge " + name);
}

const FoamProbes& probes_of(const SceneCase& written, const FoamGauge& gauge) {
    for (const FoamProbes& probes : written.foam.probes)
        if (probes.name == gauge.object) return probes;
    throw std::runtime_error("no probes " + gauge.object);
}

bool has_gmsh() {
    if (program_found("gmsh")) return true;
    WARN("not tested: gmsh is not installed");
    return false;
}

}  // namespace

TEST_CASE("Faces have pressures along them, films and surfaces are read along rays") {
    const SceneCase plate = scene_case(shipped("flat_plate", "constant-velocity"), 0.01);
    const FoamGauge& face = gauge_named(plate, "face_pressure");
    CHECK(face.kind == FoamGauge::Kind::profile);
    CHECK(face.abscissa.size() == 50);
    const std::vector<Vec2>& along = probes_of(plate, face).points;
    REQUIRE(along.size() == 50);
    CHECK(along.front().x() == Approx(along.back().x()));  // of the half that is computed
    for (const Vec2& point : along) CHECK(point.y() == Approx(0.42).margin(0.001));

    const FoamGauge& film = gauge_named(plate, "air_film");
    CHECK(film.kind == FoamGauge::Kind::film);
    CHECK(film.rays.size() >= 5);
    CHECK(film.places.size() == probes_of(plate, film).points.size());
    CHECK(film.places.front() == Approx(0.5 * 0.001).epsilon(0.1));  // half of the first cell under the plate

    const SceneCase wedge = scene_case(shipped("wedge", "constant-velocity"), 0.02);
    const FoamGauge& surface = gauge_named(wedge, "water_surface");
    CHECK(surface.rise == Approx(6.15));
    CHECK(surface.rays.size() == surface.abscissa.size());
    CHECK(surface.abscissa.size() == 50);
    CHECK(surface.places.size() == probes_of(wedge, surface).points.size());
    CHECK(probes_of(wedge, surface).interval > 0);
    for (const std::string& difference : wedge.differences) CHECK_THAT(difference, !Contains("Not written"));
}

TEST_CASE("What a case cannot hold is named with the reason") {
    const Scene scene = shipped("flat_plate", "constant-velocity",
                                {"probes.air_film.type=\"patch_pressure\"", "probes.air_film.length=0.05",
                                 "probes.air_film.points=40"});
    std::string all;
    for (const std::string& difference : scene_case(scene, 0.01).differences) all += difference + "\n";
    CHECK_THAT(all, Contains("Not written: the probes air_film (OpenFOAM has no mean over a patch"));
}

TEST_CASE("A heeled wedge and a cylinder become cases on meshes that follow them, with all of their water") {
    if (!has_gmsh()) return;
    for (const auto& [name, cell] :
         {std::pair("heeled_wedge", 0.02), std::pair("cylinder_slamming", 0.005)}) {
        const Scene scene = shipped(name, "constant-velocity");
        const SceneCase written = scene_case(scene, cell);
        CHECK(written.foam.solver() == "interFoam");
        CHECK(written.shape == "section");
        CHECK(written.force_factor == 1);
        CHECK(written.foam.slanted_correctors > 0);
        const PlaneMesh& mesh = written.foam.mesh;
        const std::vector<double> shares = shares_in(mesh, written.foam.water_boxes);
        double water = 0, all = 0, worst = 0;
        for (std::size_t c = 0; c < shares.size(); ++c) {
            water += shares[c] * mesh.area(c);
            all += mesh.area(c);
            worst = std::max(worst, slant(mesh, c));
        }
        const Box& box = scene.water_boxes.front();
        CHECK(water == Approx((box.high - box.low).prod()));
        const Vec2 size = scene.tank.high - scene.tank.low;
        double twice = 0;
        const Outline& outline = scene.bodies.front().outline;
        for (std::size_t k = 0; k < outline.size(); ++k)
            twice += cross(outline[k], outline[(k + 1) % outline.size()]);
        CHECK(size.prod() - all == Approx(0.5 * std::abs(twice)).epsilon(0.01));
        CHECK(worst > 0.1);  // so that a build with the fault is refused
        const auto files = foam_files(written.foam);
        CHECK(files.count("section.geo") == 1);
        CHECK(case_hash(written) == case_hash(scene_case(scene, cell)));
    }
    const SceneCase heeled = scene_case(shipped("heeled_wedge", "constant-velocity"), 0.02);
    CHECK(gauge_named(heeled, "left_face_pressure").abscissa.size() == 60);
    CHECK(gauge_named(heeled, "water_surface").abscissa.size() == 50);
}

TEST_CASE("Sections that are flat or shut in air are computed with compressible air, like a plate") {
    if (!has_gmsh()) return;
    const std::vector<std::string> heel{"body.angle=\"2 deg\"", "symmetry.x=\"none\""};
    for (const Scene& scene :
         {shipped("flat_plate", "constant-velocity", heel), shipped("catamaran", "constant-velocity")}) {
        const SceneCase written = scene_case(scene, 0.01);
        CHECK(written.shape == "section");
        CHECK(written.foam.solver() == "compressibleInterFoam");
        CHECK(written.foam.air_pressure > 0);
    }
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
    CHECK_THAT(refusal(shipped("oblique_wedge", "constant-velocity")), Contains("straight down"));
    CHECK_THAT(refusal(shipped("flat_plate", "constant-velocity", {"model.air=false"})), Contains("no air"));
    CHECK_THAT(refusal(shipped("heeled_wedge", "constant-velocity", {"body.angle=\"29 deg\""})),
               Contains("flat bottom and no air"));
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
