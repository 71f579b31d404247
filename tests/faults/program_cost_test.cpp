// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck bench` and `wetdeck ablate` as a user sees them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using nlohmann::json;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;

namespace {

json json_in(const std::filesystem::path& file) {
    return json::parse(samples::bytes_of(file));
}

std::vector<std::string> ablate(const std::string& scene, const ScratchFolder& folder, const char* dx) {
    return {"ablate", scene, "--variant", "single-phase", "--dx", dx, "--jobs", "1", "--out", folder / "out"};
}

}  // namespace

TEST_CASE("bench compares this build with another one, pair by pair", "[faults]") {
    const ScratchFolder folder;
    const std::string file = folder / "against.json";
    const Outcome done = run_program({"bench", "--against", WETDECK_PROGRAM, "--threads", "1", "--dx", "0.04",
                                      "--repeats", "2", "--json", file});
    REQUIRE(done.code == 0);
    CHECK_THAT(done.out, Contains("2 pairs of runs in turn") && Contains("two-phase"));
    const json against = json_in(file);
    for (const char* variant : {"two-phase", "single-phase"}) {
        // the same program: a machine that is busy may slow one run of a pair down, not by more
        CHECK(against.at("ratio").at(variant).get<double>() > 0.2);
        CHECK(against.at("ratio").at(variant).get<double>() < 5);
    }
    const Outcome missing = run_program({"bench", "--against", folder / "nothing"});
    CHECK(missing.code == 2);
    CHECK_THAT(missing.err, Contains("no such program"));
    const Outcome other = run_program({"bench", "--against", "/bin/false"});
    CHECK(other.code == 2);
    CHECK_THAT(other.err, Contains("--version ended with status 1"));
}

TEST_CASE("bench measures every stage, and no pass beats the limits of the machine", "[faults]") {
    const ScratchFolder folder;
    const std::string file = folder / "bench.json";
    const Outcome outcome =
        run_program({"bench", "--threads", "2", "--dx", "0.1", "--repeats", "3", "--json", file});
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.out, Contains("share of the limit"));
    const json bench = json_in(file);
    CHECK(bench.at("schema") == 1);
    CHECK(bench.at("dx") == 0.1);
    CHECK_FALSE(bench.at("machine").at("cpu").get<std::string>().empty());
    REQUIRE(bench.at("cases").size() == 4);  // one and two phases on one and two threads
    for (std::size_t n = 0; n < 4; ++n) {
        const json& one = bench.at("cases")[n];
        CAPTURE(one.dump());
        CHECK(one.at("phases") == (n < 2 ? 1 : 2));
        CHECK(one.at("threads") == 1 + n % 2);
        CHECK(one.at("particle_steps_per_s").at("median") > 0);
        CHECK(one.at("particle_steps_per_s").at("mad") >= 0);
        CHECK(one.at("particle_steps_per_core_s").at("median") > 0);
        CHECK(one.at("processor_share") > 0);
        for (const char* stage : {"density", "momentum", "walls", "neighbours", "integration"}) {
            // a stage alone is faster than the whole step
            CHECK(one.at("stages_particle_steps_per_s").at(stage).at("median") >
                  one.at("particle_steps_per_s").at("median"));
        }
        CHECK(one.at("stages_particle_steps_per_s").at("bodies").at("median") == 0);
        // pi (2 h / dx)^2 = 28.3 in the bulk, fewer at the surface
        CHECK(one.at("neighbours_per_particle") > 10);
        CHECK(one.at("neighbours_per_particle") < 35);
        CHECK(one.at("listed_per_cluster") > one.at("neighbours_per_particle"));
        CHECK(one.at("steps_per_list_build") >= 0.5);  // it may be built twice a step
        CHECK(one.at("bytes_per_particle") > 64);
        if (const json& counted = one.at("instructions_per_particle_step"); !counted.is_null())
            CHECK(counted > 100);
        for (const char* limit : {"density_neighbours_per_s", "momentum_neighbours_per_s",
                                  "triad_bytes_per_s", "triad_memory_bytes_per_s"})
            CHECK(one.at("limits").at(limit) > 0);
        // above 1 only by the noise of the machine and by how well the sample stands for all clusters
        const json& share = one.at("share_of_limit");
        for (const double s :
             {share.at("density").at("limit").get<double>(), share.at("momentum").at("limit").get<double>(),
              share.at("step").get<double>()}) {
            CHECK(s > 0);
            CHECK(s <= 1.2);
        }
    }
}

TEST_CASE("bench prints JSON alone where it is asked to, and refuses a spacing that does not fit",
          "[faults]") {
    const Outcome printed =
        run_program({"bench", "--threads", "1", "--dx", "0.1", "--repeats", "1", "--json"});
    REQUIRE(printed.code == 0);
    CHECK(json::parse(printed.out).at("cases").size() == 2);
    const Outcome refused = run_program({"bench", "--dx", "0.5"});
    CHECK(refused.code == 2);
    CHECK(refused.one_line());
}

TEST_CASE("ablate judges every ingredient, reuses its runs, and shows its table in the report", "[faults]") {
    const ScratchFolder folder;
    const std::string scene =
        put_scene(folder, samples::with("window = [0.2, 0.8]",
                                        "window = [0.2, 0.8]\nexpected = 2.5\ntolerance = "
                                        "0.5\nexpected_source = \"made up\""));
    const Outcome first = run_program(ablate(scene, folder, "0.04"));
    INFO(first.out << first.err);
    REQUIRE(first.code == 0);
    CHECK_THAT(first.out, Contains("hydrostatic correction") && Contains("needed: unstable without it"));

    const json rows = json_in(folder / "out/ablation.json").at("rows");
    REQUIRE(rows.size() == 8 + 1 + 8);
    const json summary = json_in(folder / "out/summary.json");
    CHECK(summary.at("ablation") == rows);
    REQUIRE(summary.at("runs").size() == 1);  // runs of the study are no runs of the scene
    const json& value = summary.at("runs")[0].at("qoi").at("front_mean").at("value");
    const json table = json_in(folder / "out/ablation/small/single-phase/dx0.04/table.json").at("rows");
    REQUIRE(table.size() == rows.size());
    for (std::size_t n = 0; n < rows.size(); ++n) {
        CAPTURE(table[n].dump());
        CHECK(rows[n].at("scene") == "small");
        CHECK(rows[n].at("dx") == 0.04);
        CHECK(table[n].at("needed") == rows[n].at("needed"));
        CHECK_FALSE(table[n].at("reason").get<std::string>().empty());
        if (n < 6 && table[n].at("values").size() > 0) CHECK(table[n].at("values")[0].at("with") == value);
    }
    const json& hydrostatic = table[0].at("values")[0];
    CHECK(hydrostatic.at("without") != hydrostatic.at("with"));
    CHECK_THAT(samples::report_in(folder / "out"), Contains("mirrored wall velocity, single-phase"));

    const auto full = folder / "out/runs/small/single-phase/dx0.04/run.h5";
    const std::string before = samples::bytes_of(full);
    CHECK_THAT(run_program(ablate(scene, folder, "0.04")).out, Contains("0 runs to do"));
    REQUIRE(run_program(ablate(scene, folder, "0.05")).code == 0);  // adds its rows
    CHECK(json_in(folder / "out/ablation.json").at("rows").size() == 2 * rows.size());

    std::vector<std::string> shorter = ablate(scene, folder, "0.04");
    shorter.insert(shorter.end(), {"--until", "0.05"});
    const Outcome refused = run_program(shorter);
    CHECK(refused.code == 2);
    CHECK(refused.one_line());
    CHECK_THAT(refused.err, Contains("holds a run of another length"));
    CHECK(samples::bytes_of(full) == before);
}

TEST_CASE("ablate refuses what it cannot run before it runs anything", "[faults]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder);
    for (const char* dx : {"-0.04", "0.3"}) {
        const Outcome outcome = run_program(ablate(scene, folder, dx));
        CHECK(outcome.code == 2);
        CHECK(outcome.one_line());
    }
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}
