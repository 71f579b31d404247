// SPDX-License-Identifier: BSD-3-Clause
// From runs to summary: grouping, error against cost, and the JSON that comes out.
#include "validation/metrics/analysis.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/unit/store/store_samples.hpp"
#include "validation/metrics/speed_error.hpp"
#include "validation/metrics/summary_json.hpp"

using namespace wetdeck;

namespace {

const std::filesystem::path references = std::filesystem::path(WETDECK_SOURCE_DIR) / "reference_data";

AnalysisSpec scene() {
    AnalysisSpec spec;
    spec.scene = "dam_break";
    spec.error_quantity = "top";
    QuantitySpec top;
    top.name = "top";
    top.metric = &metric_named("maximum");
    top.series = "front";
    top.unit = "m";
    QuantitySpec late = top;
    late.name = "late";
    late.metric = &metric_named("value_at");
    late.threshold = 99;
    spec.quantities = {top, late};
    ComparisonSpec front;
    front.title = "Front";
    front.quantity = "front";
    front.reference = "ritter_front";
    front.x_column = "T";
    front.y_column = "x_over_h";
    front.tolerance = 0.1;
    ComparisonSpec missing = front;
    missing.reference = "buchner2002_front";
    spec.comparisons = {front, missing};
    return spec;
}

/// A run whose front goes from 2 at the speed 2, raised by `error`.
RunSummary run(const std::string& variant, double dx, double core_s, double error) {
    RunSummary result;
    result.record.scene = "dam_break";
    result.record.variant = variant;
    result.record.particle_spacing = dx;
    result.record.particles = 20;
    result.record.cost.core_s = core_s;
    result.record.cost.wall_s = 2;
    result.record.cost.steps = 50;
    result.record.cost.particle_steps = 500;
    result.record.series["front"] = {"m", "", {0, 1, 2}, {2 + error, 4 + error, 6 + error}, {}};
    result.directory = "runs/dam_break/" + variant;
    return result;
}

std::vector<RunSummary> sweep() {
    return {run("a", 0.04, 1, 0.16), run("a", 0.02, 8, 0.04), run("a", 0.01, 64, 0.01),
            run("b", 0.02, 9, 0.05)};
}

const ConvergenceRow& row_of(const Summary& summary, const std::string& variant) {
    for (const ConvergenceRow& row : summary.convergence) {
        if (row.variant == variant && row.qoi == "top") return row;
    }
    throw std::runtime_error("no such row");
}

}  // namespace

TEST_CASE("Runs of one variant form one convergence row per quantity that has values", "[analysis]") {
    const Summary summary = analyse({scene()}, sweep(), references);
    REQUIRE(summary.convergence.size() == 2);  // `late` is never reached
    CHECK(row_of(summary, "a").order.value() == Approx(2));
    CHECK(row_of(summary, "a").extrapolated.value() == Approx(6));
    CHECK(row_of(summary, "b").verdict == "too few spacings");
}

TEST_CASE("Runs that did not end well stay out of convergence and of error against cost", "[analysis]") {
    auto runs = sweep();
    runs[2].record.status = RunStatus::unstable;
    const Summary summary = analyse({scene()}, runs, references);
    CHECK(row_of(summary, "a").verdict == "too few spacings");
    REQUIRE(summary.speed_error.size() == 4);
    CHECK_FALSE(summary.speed_error[2].error.has_value());
    CHECK_FALSE(summary.speed_error[2].pareto);
    CHECK(summary.runs[2].quantities.size() == 2);
}

TEST_CASE("A curve beyond the time at which a run was asked to stop is not judged", "[analysis]") {
    AnalysisSpec spec = scene();
    spec.comparisons[0].window = Window{0.5, 1.5};
    RunSummary stopped = run("a", 0.04, 1, 0);
    stopped.record.series["front"] = {"m", "", {0, 0.1}, {2, 3}, {}};
    CHECK(analyse({spec}, {stopped}, references).runs[0].comparisons[0].available);
    stopped.record.parameters["run.until"] = 0.1;
    CHECK_FALSE(analyse({spec}, {stopped}, references).runs[0].comparisons[0].available);
}

TEST_CASE("An error is the distance from the expected value, over that value", "[analysis]") {
    AnalysisSpec spec = scene();
    spec.quantities[0].expected = 5;
    spec.quantities[0].expected_source = "a tank";
    const auto points =
        analyse({spec}, {run("a", 0.04, 1, -3), run("a", 0.02, 8, 0.5)}, references).speed_error;
    REQUIRE(points.size() == 2);
    CHECK(points[0].error.value() == Approx(2.0 / 5));  // a front of 3 m
    CHECK(points[1].error.value() == Approx(1.5 / 5));  // and of 6.5 m
    CHECK(points[1].against == "a tank");
}

TEST_CASE("Where nothing is expected the error is the distance from what the spacings converge to",
          "[analysis]") {
    const auto points = analyse({scene()}, sweep(), references).speed_error;
    REQUIRE(points.size() == 4);
    CHECK(points[0].error.value() == Approx(0.16 / 6));
    CHECK(points[2].error.value() == Approx(0.01 / 6));
    CHECK_FALSE(points[3].error.has_value());  // one spacing converges to nothing
}

TEST_CASE("A run that another beats in cost and error is not on the Pareto front", "[analysis]") {
    AnalysisSpec spec = scene();
    spec.quantities[0].expected = 6;
    const Summary summary = analyse({spec}, sweep(), references);
    REQUIRE(summary.speed_error.size() == 4);
    CHECK(summary.speed_error[0].pareto);
    CHECK(summary.speed_error[1].pareto);
    CHECK(summary.speed_error[2].pareto);
    CHECK_FALSE(summary.speed_error[3].pareto);  // dearer and worse than "a" at 0.02
}

TEST_CASE("Two runs with the same cost and error are both on the Pareto front", "[analysis]") {
    AnalysisSpec spec = scene();
    spec.quantities[0].expected = 6;
    const Summary summary = analyse({spec}, {run("a", 0.02, 8, 0.04), run("b", 0.02, 8, 0.04)}, references);
    CHECK(summary.speed_error[0].pareto);
    CHECK(summary.speed_error[1].pareto);
}

TEST_CASE("The variants of a scene make one specification, with what any of them asks for, once",
          "[analysis]") {
    AnalysisSpec air = scene(), alone = scene(), other = scene();
    air.variant = "air";
    alone.variant = "alone";
    air.default_variant = alone.default_variant = "alone";
    air.quantities[0].unit = "not the one that is kept";
    air.quantities[1].name = "of the air";
    air.comparisons[1].title = "of the air";
    other.scene = "another";
    const std::vector<AnalysisSpec> scenes = analyse({air, other, alone}, {}, references).scenes;
    REQUIRE(scenes.size() == 2);
    CHECK(scenes[0].scene == "another");
    REQUIRE(scenes[1].quantities.size() == 3);
    CHECK(scenes[1].quantities[0].unit == "m");
    CHECK(scenes[1].quantities[2].name == "of the air");
    REQUIRE(scenes[1].comparisons.size() == 3);
    CHECK(scenes[1].comparisons[2].title == "of the air");
}

TEST_CASE("A peer's curve is as far from the measured one as it was made, and its cost is what its file says",
          "[analysis]") {
    const samples::ScratchFolder folder;
    const auto put = [&](const std::string& stem, const std::string& kind, double shift) {
        std::string text =
            "# kind: " + kind + "\n# citation: Someone (2000)\n# doi: none\n# figure: 1\n" +
            "# obtained: tabulated\n# obtained_from: here\n# date: 2026-01-31\n" +
            "# digitisation_error: 0.01\n# u_data: 0.05\n# u_data_source: text\n" +
            "# sensor: gauge\n# filter: none\n# sign: up\n# time_origin: release\n# note: none\n";
        if (shift > 0) text += "# cost_core_s: 90\n# cost_conditions: one core\n";
        text += "T [-],p [-]\n";
        for (int t = 0; t <= 4; ++t) text += std::to_string(t) + "," + std::to_string(t * t + shift) + "\n";
        samples::put_bytes(folder / (stem + ".csv"), text);
    };
    put("measured", "experiment", 0);
    put("peer", "peer-simulation", 0.25);
    put("also_measured", "experiment", 0.5);
    AnalysisSpec spec;
    spec.scene = "made_up";
    spec.error_quantity = "rms";
    spec.folder = folder;
    QuantitySpec rms;
    rms.name = "rms";
    rms.metric = &metric_named("rms_difference");
    rms.series = "gauge";
    rms.reference = "measured";
    rms.y_column = "p";
    rms.window = Window{1, 3};
    spec.quantities = {rms};
    for (const char* reference : {"measured", "peer", "also_measured", "nowhere"}) {
        ComparisonSpec comparison;
        comparison.title = std::string("against ") + reference;
        comparison.quantity = "gauge";
        comparison.reference = reference;
        comparison.x_column = "T";
        comparison.y_column = "p";
        spec.comparisons.push_back(comparison);
    }
    const std::vector<PeerPoint> peers = analyse({spec}, {}, references).peers;
    REQUIRE(peers.size() == 1);
    CHECK(peers[0].name == "against peer");
    CHECK(peers[0].error == Approx(0.25));
    CHECK(peers[0].core_s == 90);
    CHECK(peers[0].conditions == "one core");
}

TEST_CASE("A run of a scene without specification is kept without quantities", "[analysis]") {
    auto runs = sweep();
    runs[3].record.scene = "own_scene";
    const Summary summary = analyse({scene()}, runs, references);
    REQUIRE(summary.runs.size() == 4);
    CHECK(summary.runs[3].quantities.empty());
    CHECK(summary.runs[3].comparisons.empty());
    CHECK(summary.speed_error.size() == 3);
}

TEST_CASE("The JSON holds every key of schema 2", "[summary_json]") {
    Summary summary = analyse({scene()}, sweep(), references);
    summary.tier = "quick";
    const auto json = summary_json(summary, {"0.1.0", "abc", "g++", "avx2", 2, "a processor", 4});
    CHECK(json["schema"] == 2);
    CHECK(json["tier"] == "quick");
    CHECK(json["program"] ==
          nlohmann::json::parse(
              R"({"version":"0.1.0","commit":"abc","compiler":"g++","simd":"avx2","threads":2})"));
    CHECK(json["machine"] == nlohmann::json::parse(R"({"cpu":"a processor","cores":4})"));
    for (const char* key : {"verification", "ablation", "stress"})
        CHECK(json.at(key) == nlohmann::json::array());

    const auto& first = json["runs"][0];
    for (const char* key :
         {"scene", "variant", "dx", "particles", "steps", "wall_s", "core_s", "particle_steps_per_s",
          "peak_rss_mb", "status", "energy_error", "momentum_error", "qoi", "comparisons"}) {
        CHECK(first.contains(key));
    }
    CHECK(first["particle_steps_per_s"] == 250);
    CHECK(first["status"] == "ok");
    CHECK(first["energy_error"].is_null());
    CHECK(first["qoi"]["top"]["value"] == Approx(6.16));
    CHECK(first["qoi"]["top"]["unit"] == "m");
    CHECK(first["qoi"]["late"]["value"].is_null());

    const auto& front = first["comparisons"][0];
    for (const char* key :
         {"quantity", "reference", "kind", "metric", "reference_uncertainty", "tolerance", "within"}) {
        CHECK(front.contains(key));
    }
    CHECK(front["kind"] == "analytic");
    CHECK(front["metric"]["nrmse"] == Approx(0.16 / 3.4));
    CHECK(front["metric"]["peak_error"].is_number());
    CHECK(front["metric"]["time_error"].is_null());
    CHECK(front["within"] == true);

    for (const char* key :
         {"scene", "variant", "qoi", "dx", "value", "order", "extrapolated", "gci_fine", "monotone"}) {
        CHECK(json["convergence"][0].contains(key));
    }
    for (const char* key : {"scene", "variant", "dx", "core_s", "error", "pareto"}) {
        CHECK(json["speed_error"][0].contains(key));
    }
}

TEST_CASE("A comparison without a curve is null in the JSON and not a failure", "[summary_json]") {
    const auto json = summary_json(analyse({scene()}, sweep(), references), {});
    const auto& missing = json["runs"][0]["comparisons"][1];
    CHECK(missing["within"].is_null());
    CHECK(missing["kind"].is_null());
    CHECK(missing["metric"]["nrmse"].is_null());
    CHECK_THAT(missing["note"].get<std::string>(), Catch::StartsWith("curve not available"));
}

TEST_CASE("Numbers that are not finite become null", "[summary_json]") {
    auto runs = sweep();
    runs[0].record.cost.wall_s = 0;
    runs[1].record.cost.peak_rss_mb = std::numeric_limits<double>::quiet_NaN();
    const auto json = summary_json(analyse({scene()}, runs, references), {});
    CHECK(json["runs"][0]["particle_steps_per_s"].is_null());
    CHECK(json["runs"][1]["peak_rss_mb"].is_null());
}

TEST_CASE("A summary without runs is a full document of empty lists", "[summary_json]") {
    const auto json = summary_json(analyse({}, {}, references), {});
    for (const char* key : {"runs", "convergence", "speed_error", "verification", "ablation", "stress"}) {
        CHECK(json.at(key) == nlohmann::json::array());
    }
}
