// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "../import/import_support.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/metrics/peer_result.hpp"
#include "validation/peer/foam_run.hpp"
#include "validation/peer/foam_series.hpp"
#include "validation/store/child_process.hpp"

using namespace wetdeck;
using Catch::Matchers::Contains;

namespace {

PeerResult peer_of(const std::vector<double>& values) {
    PeerResult peer{"wedge", "constant-velocity", "OpenFOAM v1912, interFoam", {"a difference"}, {}};
    std::vector<std::pair<double, double>> by_cell;
    for (std::size_t k = 0; k < values.size(); ++k)
        by_cell.emplace_back(0.04 / std::pow(2.0, static_cast<double>(k)), values[k]);
    PeerQuantity quantity{"-", convergence(by_cell), "curves/body_force_y.csv"};
    quantity.values.qoi = "force_slope";
    peer.quantities.push_back(quantity);
    return peer;
}

RunSummary run_of(double dx, double value) {
    RunSummary run;
    run.record.scene = "wedge";
    run.record.variant = "constant-velocity";
    run.record.particle_spacing = dx;
    run.quantities.push_back({"force_slope", "-", value, "", {}, {}, "", {}});
    return run;
}

}  // namespace

TEST_CASE("A result of another code is the same after writing and reading") {
    ImportFolder folder;
    const PeerResult peer = peer_of({10, 12, 13});
    std::filesystem::create_directories(folder.path("peer/wedge"));
    write_peer_result(folder.path("peer/wedge"), peer);
    const std::vector<PeerResult> read = read_peer_results(folder.path(""));
    REQUIRE(read.size() == 1);
    CHECK(read[0].code == peer.code);
    CHECK(read[0].differences == peer.differences);
    CHECK(read[0].quantities.at(0).values.value == std::vector<double>{10, 12, 13});
    CHECK(read[0].quantities.at(0).values.extrapolated == peer.quantities.at(0).values.extrapolated);
    folder.write("peer/other/peer.json", "{\"schema\": 1}");
    CHECK_THAT(message_of([&] { read_peer_results(folder.path("")); }), Contains("other/peer.json: not as"));
}

TEST_CASE("Codes agree within the sum of both uncertainties, and differ beyond it") {
    const std::vector<RunSummary> runs{run_of(0.04, 11), run_of(0.02, 13), run_of(0.01, 14)};  // u = 0.625
    const auto verdict = [&](const std::vector<double>& theirs, const std::vector<RunSummary>& ours) {
        const auto rows = peer_agreement({peer_of(theirs)}, ours);
        REQUIRE(rows.size() == 1);
        return rows[0].verdict;
    };
    CHECK(verdict({10, 12, 13}, runs) == "agree within");  // u = 0.625, difference 1
    CHECK(verdict({9, 11, 12}, runs) == "differ by more than both");
    CHECK(verdict({12, 13}, runs) == "unknown");
    CHECK(verdict({10, 12, 13}, {run_of(0.01, 14)}) == "unknown");
}

TEST_CASE("The agreement is that of the finest values; runs of other variants and dead ones do not count") {
    std::vector<RunSummary> runs{run_of(0.04, 11), run_of(0.01, 14), run_of(0.02, 13)};
    RunSummary dead = run_of(0.005, 99);
    dead.record.status = RunStatus::unstable;
    RunSummary other = run_of(0.0025, 77);
    other.record.variant = "two-phase";
    runs.push_back(dead);
    runs.push_back(other);
    const auto rows = peer_agreement({peer_of({10, 12, 13})}, runs);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].simulated == 14);
    CHECK(rows[0].reference == 13);
    CHECK(rows[0].error == Approx(1));
    CHECK(rows[0].against == "OpenFOAM v1912, interFoam");
}

namespace {

FoamGauge gauge_of(FoamGauge::Kind kind, const std::vector<double>& places,
                   const std::vector<double>& weights) {
    FoamGauge gauge;
    gauge.kind = kind;
    gauge.object = "gauge";
    gauge.places = places;
    gauge.weights = weights;
    return gauge;
}

double value_of(const FoamGauge& gauge, const std::vector<double>& probes) {
    const std::vector<double> values = gauge_values(gauge, probes, 0);
    REQUIRE(values.size() == 1);
    return values[0];
}

}  // namespace

TEST_CASE("Gauges: the front between cells, the depth of a column, the mean of a disc") {
    const FoamGauge front = gauge_of(FoamGauge::Kind::front, {0.5, 1.5, 2.5}, {1, 1, 1});
    CHECK(value_of(front, {1, 0.75, 0.25}) == Approx(2.0));
    CHECK(value_of(front, {1, 1, 1}) == Approx(3.0));
    CHECK(value_of(front, {0.6, 0, 0.9}) == Approx(3.0));
    const FoamGauge depth = gauge_of(FoamGauge::Kind::depth, {}, {0.1, 0.1, 0.2});
    CHECK(value_of(depth, {1, 0.5, 0.25}) == Approx(0.2));
    const FoamGauge pressure = gauge_of(FoamGauge::Kind::pressure, {}, {0.25, 0.5, 0.25});
    CHECK(value_of(pressure, {1, 2, 5}) == Approx(2.5));
    CHECK(std::isnan(value_of(pressure, {1, std::nan(""), 5})));
    CHECK_THROWS(gauge_values(pressure, {1, 2}, 0));
}

TEST_CASE("Gauges: a film is the least gap of its rays, whether or not each of them meets water") {
    FoamGauge film = gauge_of(FoamGauge::Kind::film, {0.5, 1.5, 2.5, 0.5, 1.5}, {});
    film.rays = {3, 2};
    CHECK(value_of(film, {0, 0.25, 0.75, 0, 0}) == Approx(2.0));
    CHECK(value_of(film, {0, 0.25, 0.75, 0, 1}) == Approx(1.0));
    CHECK(value_of(film, {0.5, 0, 0, 0, 0}) == Approx(0.5));
    CHECK(std::isnan(value_of(film, {0, 0, 0, 0, 0})));
    CHECK_THROWS(gauge_values(film, {0, 0, 0, 0}, 0));
}

TEST_CASE(
    "Gauges: a surface is the first water from above, in the frame of the scene; a profile has all probes") {
    FoamGauge surface = gauge_of(FoamGauge::Kind::surface, {3, 2, 1, 3, 1}, {});
    surface.rays = {3, 2};
    surface.abscissa = {0.1, 0.2};
    surface.rise = 5;
    // spray above the surface counts; the body has come down by 0.5 m
    CHECK(gauge_values(surface, {0, 1, 0, 0.25, 0.75}, 0.1) == std::vector<double>{2.5 - 0.5, 2 - 0.5});
    FoamGauge profile = gauge_of(FoamGauge::Kind::profile, {}, {1, 1});
    profile.abscissa = {0.1, 0.2};
    CHECK(gauge_values(profile, {7, 8}, 0.1) == std::vector<double>{7, 8});
    CHECK(gauge_values(profile, {7, std::nan("")}, 0.1).size() == 2);
    CHECK_THROWS(gauge_values(profile, {7}, 0.1));
}

TEST_CASE("The time of a log is that of its last step") {
    CHECK(last_time_in("") == 0);
    CHECK(last_time_in("\nTime = 0.1\n\nTime = 0.25\nCourant") == 0.25);
}

TEST_CASE("A mesh of slanted cells is refused where the build computes them wrongly") {
    SceneCase written;
    MeshGrid grid;
    grid.u = grid.v = even_lines(0, 1, 0.25);
    grid.patch = [](Vec2) { return "walls"; };
    written.foam.mesh = mesh_of(grid);
    CHECK_NOTHROW(check_cells(written, false));
    grid.place = [](Vec2 p) { return Vec2(p.x() + 0.5 * p.y(), p.y()); };
    written.foam.mesh = mesh_of(grid);
    CHECK_NOTHROW(check_cells(written, true));
    CHECK_THAT(message_of([&] { check_cells(written, false); }), Contains("slanted cells are wrong"));
}

TEST_CASE("The self-test tells the build of Debian 12 from a sound one") {
    if (!program_found("interFoam")) {
        WARN("not tested: interFoam is not installed");
        return;
    }
    ImportFolder folder;
    const bool sound = slanted_cells_are_sound(folder.path("self_test"));
    CHECK_FALSE(std::filesystem::exists(folder.path("self_test")));
    const std::string package = run_in_shell("dpkg-query -W -f '${Version}' openfoam").output;
    if (package == "1912.200626-1+b1") CHECK_FALSE(sound);
}
