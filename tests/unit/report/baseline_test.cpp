// SPDX-License-Identifier: BSD-3-Clause
// A committed baseline: who may write one, and what it notices.
#include "validation/commands/baseline.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/report/stored_samples.hpp"

using namespace wetdeck;

TEST_CASE("A run compared with its own baseline deviates in nothing", "[baseline]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    samples::store_sweep(folder);
    write_baseline(folder, folder / "kept/base.json", false);
    CHECK(compare_with_baseline(folder, folder / "kept/base.json").empty());
}

TEST_CASE("A baseline is refused from a changed or unknown program and never overwritten unasked",
          "[baseline]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    RunRecord run = samples::stored_run(0.02);
    const std::string commit = GENERATE("abc1234-dirty", "unknown");
    run.provenance["commit"] = commit;
    samples::store(folder / "runs/a", run);
    CHECK_THROWS_WITH(write_baseline(folder, folder / "base.json", false), Catch::Contains(commit));
    CHECK_FALSE(std::filesystem::exists(folder / "base.json"));
    samples::put_bytes(folder / "base.json", "kept");
    CHECK_THROWS_WITH(write_baseline(folder, folder / "base.json", false), Catch::Contains("--replace"));
    CHECK(samples::bytes_of(folder / "base.json") == "kept");
}

TEST_CASE("A value off by more than its tolerance is named, a smaller deviation is not", "[baseline]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder before, after;
    samples::store(before / "runs/a", samples::stored_run(0.02, 0));
    write_baseline(before, before / "base.json", false);
    const auto deviations_with = [&](double offset) {
        samples::store(after / "runs/a", samples::stored_run(0.02, offset / 4e-4));
        std::vector<std::string> deviations = compare_with_baseline(after, before / "base.json");
        std::erase_if(deviations, [](const std::string& text) {  // verdicts are another matter
            return text.find("the verdict on") != std::string::npos;
        });
        return deviations;
    };
    // 5 % of the mean 1.5, and 5 % of the range 1 of the curve
    CHECK(deviations_with(0.045).empty());
    CHECK(deviations_with(0.06).size() == 1);
    const auto both = deviations_with(0.08);
    REQUIRE(both.size() == 2);
    CHECK_THAT(both[0], Catch::Contains("front_mean was 1.5"));
    CHECK_THAT(both[1], Catch::Contains("curve front is off by 0.08 rms"));
}

TEST_CASE("A curve of another shape is noticed although its mean is the same", "[baseline]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder before, after;
    samples::store(before / "runs/a", samples::stored_run(0.02, 0));
    write_baseline(before, before / "base.json", false);
    RunRecord run = samples::stored_run(0.02, 0);
    Series& front = run.series["front"];
    for (std::size_t i = 0; i < front.value.size(); ++i) {
        const double scaled_time = front.time[i] / 0.1428;
        front.value[i] += 0.2 * 0.2 * std::sin(2 * 3.14159265358979 * (scaled_time - 0.2) / 0.6);
    }
    samples::store(after / "runs/a", run);
    const auto deviations = compare_with_baseline(after, before / "base.json");
    REQUIRE(deviations.size() == 1);
    CHECK_THAT(deviations[0], Catch::Contains("curve front"));
}

TEST_CASE("A run that is missing or became unstable deviates", "[baseline]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder before, after;
    samples::store_sweep(before);
    write_baseline(before, before / "base.json", false);
    samples::store(after / "runs/a", samples::stored_run(0.02));
    RunRecord unstable = samples::stored_run(0.01);
    unstable.status = RunStatus::unstable;
    samples::store(after / "runs/b", unstable);
    const auto deviations = compare_with_baseline(after, before / "base.json");
    REQUIRE(deviations.size() == 2);
    CHECK(deviations[0] == "small two-phase dx 0.04: missing");
    CHECK(deviations[1] == "small two-phase dx 0.01: did not reach its end");
}

TEST_CASE("A file that is no baseline is refused with its name", "[baseline]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    samples::store_sweep(folder);
    CHECK_THROWS_WITH(compare_with_baseline(folder, folder / "none.json"),
                      Catch::Contains("no such baseline"));
    samples::put_bytes(folder / "bad.json", "{}");
    CHECK_THROWS_AS(compare_with_baseline(folder, folder / "bad.json"), DataError);
}

TEST_CASE("A verdict that has turned is named", "[baseline]") {
    const samples::OwnReferences references;
    const samples::ScratchFolder folder;
    samples::store_sweep(folder);
    const std::string file = folder / "base.json";
    write_baseline(folder, file, false);
    std::string text = samples::bytes_of(file);
    const std::string key = "\"verdict\": \"";
    const std::size_t from = text.find(key);
    REQUIRE(from != std::string::npos);
    const std::size_t value = from + key.size(), end = text.find('"', value);
    const std::string now = text.substr(value, end - value);
    text.replace(value, end - value, "validated");
    samples::put_bytes(file, text);
    const auto deviations = compare_with_baseline(folder, file);
    REQUIRE(deviations.size() == 1);
    CHECK_THAT(deviations[0], Catch::Contains("the verdict on front"));
    CHECK_THAT(deviations[0], Catch::Contains("was 'validated', is '" + now + "'"));
}
