// SPDX-License-Identifier: BSD-3-Clause
// Reports from run stores alone.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/unit/report/stored_samples.hpp"
#include "validation/commands/publish.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/metrics/peer_result.hpp"
#include "validation/metrics/stored_tables.hpp"

using namespace wetdeck;
namespace fs = std::filesystem;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::map<std::string, std::string> files_below(const fs::path& directory) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(directory)) {
        if (entry.is_regular_file())
            files[fs::relative(entry.path(), directory).string()] = samples::bytes_of(entry.path());
    }
    return files;
}

}  // namespace

TEST_CASE("Stored runs of second order give order 2.00 and the exact index, value and curve",
          "[stored_report]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    samples::store_sweep(folder);
    const Summary summary = analyse_directory(folder);
    const auto json_free = summary.convergence.at(0);
    CHECK(json_free.qoi == "front_mean");
    CHECK(json_free.order.value() == Approx(2).epsilon(1e-6));
    CHECK(json_free.extrapolated.value() == Approx(1.5).epsilon(1e-9));
    CHECK(json_free.gci_fine.value() == Approx(1.25 * 3e-4).epsilon(1e-6));
    const CurveConvergenceRow& curve = summary.curve_convergence.at(0);
    CHECK(curve.order.value() == Approx(2).epsilon(1e-6));
    CHECK(curve.gci_fine.value() == Approx(1.25 * 3e-4).epsilon(1e-6));
    // measured mean of the curve over 0 < T < 1 is 1.5 with 1 %, the simulated one 3 dx^2 above
    const ValidationRow& row = summary.validation.at(0);
    CHECK(row.error == Approx(3e-4));
    CHECK(row.u_num.value() == Approx(0.5 * 1.25 * 3e-4).epsilon(1e-6));
    CHECK(row.u_data.value() == Approx(0.015));
}

TEST_CASE("The report is made again from the stores alone, byte for byte", "[stored_report]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder first, second;
    samples::store_sweep(first / "suite");
    fs::copy(first / "suite", second / "elsewhere", fs::copy_options::recursive);
    make_report(first / "suite");
    const auto once = files_below(first / "suite");
    make_report(first / "suite");
    CHECK(files_below(first / "suite") == once);
    make_report(second / "elsewhere");
    CHECK(files_below(second / "elsewhere") == once);
    CHECK(once.count("index.html") == 1);
    CHECK(once.count("summary.json") == 1);
    for (const auto& [name, bytes] : once) {
        const fs::path path = name;
        if (path.extension() != ".svg") continue;
        INFO(name);
        CHECK(once.count(fs::path(path).replace_extension(".csv").string()) == 1);
        CHECK(contains(bytes, "revision abc1234"));
    }
}

TEST_CASE("Beside a peer.json the report and summary.json show the agreement between codes",
          "[stored_report]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    samples::store_sweep(folder);
    const Summary runs = analyse_directory(folder);
    PeerResult peer{
        runs.runs[0].record.scene, runs.runs[0].record.variant, "OpenFOAM v1912, interFoam", {}, {}};
    PeerQuantity quantity{"-", convergence({{0.04, 1.6}, {0.02, 1.55}, {0.01, 1.5375}}), "curves/front.csv"};
    quantity.values.qoi = "front_mean";
    peer.quantities.push_back(quantity);
    fs::create_directories(folder / "peer/small");
    write_peer_result(folder / "peer/small", peer);
    make_report(folder);
    const auto json = nlohmann::json::parse(samples::bytes_of(folder / "summary.json"));
    const auto& row = json.at("agreement").back();
    CHECK(row.at("code") == "OpenFOAM v1912, interFoam");
    CHECK(row.at("quantity") == "front_mean");
    CHECK(row.at("theirs") == Approx(1.5375));
    CHECK(row.at("ours").get<double>() == Approx(1.5003).epsilon(1e-4));
    // 0.0372 apart; GCI / 2 is 0.5 * 1.25 * 0.0125/3 and 0.5 * 1.25 * 3e-4
    CHECK(row.at("verdict") == "differ by more than both");
    CHECK(contains(samples::bytes_of(folder / "index.html"), "Agreement between codes"));
    CHECK(contains(samples::bytes_of(folder / "index.html"), "differ by more than both"));
}

TEST_CASE("A planned run that is not there marks the stored report incomplete", "[stored_report]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    samples::store_sweep(folder);
    write_suite_plan(folder, "quick", {"runs/" + std::to_string(0.01), "runs/" + std::to_string(0.005)});
    const Summary summary = make_report(folder);
    CHECK(summary.missing == std::vector<std::string>{"runs/" + std::to_string(0.005)});
    CHECK(contains(samples::bytes_of(folder / "index.html"), "<h1>INCOMPLETE"));
}

TEST_CASE("Runs of the sensitivity study give the input uncertainty and are no rows of the suite",
          "[stored_report]") {
    const samples::OwnReferences references;
    const std::string scene = samples::small_scene +
                              "\n[[sensitivity]]\nkey = \"initial.surface\"\nlow = 0.1\nhigh = 0.3\n"
                              "uncertainty = 0.05\nsource = \"made up\"\n";
    const samples::ScratchFolder folder;
    samples::store_sweep(folder, 3, scene);
    for (const auto& [value, factor] : {std::pair("0.1", 0.0), std::pair("0.3", 100.0)}) {
        RunRecord varied = samples::stored_run(0.02, factor, scene);
        varied.provenance["overrides"] = std::string("initial.surface=") + value;
        samples::store(folder / (std::string("sensitivity/small/initial.surface=") + value), varied);
    }
    const Summary summary = analyse_directory(folder);
    CHECK(summary.runs.size() == 3);
    // the mean differs by 100 * 0.02^2 = 0.04 over a step of 0.2
    CHECK(summary.validation.at(0).u_input.value() == Approx(0.04 / 0.2 * 0.05));
    CHECK(summary.validation.at(0).u_val.has_value());
}

TEST_CASE("Runs at other sound speeds are shown beside the spacings and are no rows of the suite",
          "[stored_report]") {
    const samples::OwnReferences references;
    const std::string scene = samples::small_scene + "\n[sound_speed_study]\nvariants = [\"two-phase\"]\n";
    const samples::ScratchFolder folder;
    samples::store_sweep(folder, 3, scene);
    CHECK(contains((make_report(folder), samples::report_in(folder)), "does not hold them"));
    const double coarsest = analyse_directory(folder).convergence.at(0).dx.front();
    for (const char* value : {"7", "28"}) {
        RunRecord varied = samples::stored_run(coarsest, 1.0, scene);
        varied.provenance["overrides"] = std::string("water.sound_speed=") + value;
        samples::store(folder / (std::string("sound_speed/small/two-phase/water.sound_speed=") + value),
                       varied);
    }
    const Summary summary = make_report(folder);
    CHECK(summary.runs.size() == 3);
    REQUIRE_FALSE(summary.sound_speed.empty());
    CHECK(summary.sound_speed[0].sound_speed == std::vector<double>{7, 14, 28});
    CHECK(contains(samples::report_in(folder), "7 / 14 / 28"));
    const auto json = nlohmann::json::parse(samples::bytes_of(folder / "summary.json"));
    CHECK(json["sound_speed"][0]["sound_speed"].size() == 3);
}

TEST_CASE("Ablation and stress results come back as they were written and are shown", "[stored_report]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    samples::store_sweep(folder);
    write_ablation(folder,
                   {{"small", 0.02, "air", 0.4, 0.03, true}, {"small", 0.02, "switch", 1.0, {}, false}});
    write_stress(folder, {{"tiny drop", "no dissipation", false, "unstable at t = 1 s"}});
    const Summary summary = make_report(folder);
    REQUIRE(summary.ablation.size() == 2);
    CHECK(summary.ablation[0].core_s_ratio == 0.4);
    CHECK_FALSE(summary.ablation[1].error_change.has_value());
    const std::string page = samples::report_in(folder);
    CHECK(contains(page, "<td class=\"number\">0.4</td><td>+0.03</td>"));
    CHECK(contains(page, "unstable at t = 1 s"));
    const auto json = nlohmann::json::parse(samples::bytes_of(folder / "summary.json"));
    CHECK(json["ablation"][0]["ingredient"] == "air");
    CHECK(json["ablation"][1]["error_change"].is_null());
    CHECK(json["stress"][0]["case"] == "tiny drop");
    samples::put_bytes(folder / "stress.json", R"({"schema": 1, "rows": [{"case": "x"}]})");
    CHECK_THROWS_WITH(read_stress(folder), Catch::Contains("stress.json: row 1"));
    samples::put_bytes(folder / "ablation.json", "[]");
    CHECK_THROWS_AS(read_ablation(folder), DataError);
}

TEST_CASE("What is published is small, dated by its revision, and replaced whole", "[stored_report]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder, target;
    samples::store_sweep(folder);
    const Summary summary = make_report(folder);
    fs::create_directory(target / "single-runs");
    samples::put_bytes(target / "single-runs/suite-old.csv", "old");
    samples::put_bytes(target / "single-runs/notes.md", "mine");
    publish(summary, folder, target);
    const auto files = files_below(target);
    const std::string& readme = files.at("single-runs/README.md");
    CHECK(contains(readme, "revision abc1234"));
    CHECK(contains(readme, "## What was reached"));
    CHECK(contains(readme, "`index.html`, one page a scene and `statistics.html`"));
    for (const auto& [name, bytes] : files) {
        INFO(name);
        CHECK(bytes.size() < 100000);
        CHECK(fs::path(name).extension() != ".html");
    }
    CHECK(contains(files.at("single-runs/runs.csv"), "small,two-phase,0.01,ok"));
    CHECK(files.count("single-runs/small-speed-error.csv") == 1);
    CHECK(files.count("single-runs/suite-scatter-position.csv") == 1);
    CHECK(files.count("single-runs/suite-old.csv") == 0);
    CHECK(files.at("single-runs/notes.md") == "mine");
}
