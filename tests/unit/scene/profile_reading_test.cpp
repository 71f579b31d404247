// SPDX-License-Identifier: BSD-3-Clause
// Profiles at an instant and over an interval, and comparisons with several references.
#include <array>
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"

using namespace wetdeck;
using Catch::Contains;
using Catch::EndsWith;
using samples::refusal;

TEST_CASE("a profile is taken at an instant, and nothing else is") {
    const std::string film =
        samples::with("[[quantities]]",
                      "[[probes]]\nname = \"film\"\ntype = \"free_surface\"\nlow = 0.0\nhigh = 1.0\n"
                      "points = 11\n\n[[quantities]]");
    const auto of_film = [&](const std::string& more) {
        return samples::replaced(film, "series = \"front\"\nx_scale = \"time\"", "series = \"film\"" + more);
    };
    CHECK(samples::refusal(of_film("\ninstant = 0.1")).empty());
    CHECK_THAT(
        samples::refusal(of_film("")),
        EndsWith(
            "key 'quantities[0].instant': missing: series 'film' is a profile, taken at one instant or as "
            "the mean of an interval"));
    for (const auto& [instant, message] : std::vector<std::array<std::string, 2>>{
             {"[0.05, 0.1]", ""},
             {"[0.1, 0.05]", "expected a begin below its end"},
             {"[0.1, 0.1]", "expected a begin below its end"},
             {"[0.1]", "expected a list of 2 numbers"},
             {"[0.05, 0.1, 0.15]", "expected a list of 2 numbers"},
             {"[\"a\", \"b\"]", "expected a list of 2 numbers"},
             {"\"0.1\"", "expected a list of 2 numbers"},
             {"true", "expected a list of 2 numbers"},
             {"nan", "finite number"},
             {"{ from = 0.05, to = 0.1 }", "expected a list of 2 numbers"}}) {
        CAPTURE(instant);
        const std::string said = samples::refusal(of_film("\ninstant = " + instant));
        if (message.empty())
            CHECK(said.empty());
        else
            CHECK_THAT(said, Contains("key 'quantities[0].instant': ") && EndsWith(message));
    }
    CHECK_THAT(samples::refusal(samples::with("metric = \"mean\"", "metric = \"mean\"\ninstant = 0.1")),
               EndsWith("key 'quantities[0].instant': expected none: series 'front' is no profile"));
    CHECK_THAT(samples::refusal(samples::with("reference = \"nobody_front\"",
                                              "reference = \"nobody_front\"\ninstant = 0.1")),
               EndsWith("key 'compare[0].instant': expected none: series 'front' is no profile"));
}

TEST_CASE("a list of references is compared with one by one") {
    const auto read = [](const std::string& references) {
        return samples::with("reference = \"nobody_front\"", references);
    };
    const Scene scene = parse_scene(read("references = [\"nobody_front\", \"another_front\"]"), "small.toml");
    const std::vector<ComparisonSpec>& comparisons = scene.analysis.comparisons;
    REQUIRE(comparisons.size() == 2);
    CHECK(comparisons[0].reference == "nobody_front");
    CHECK(comparisons[0].title == "front, nobody_front");
    CHECK(comparisons[1].reference == "another_front");
    CHECK(comparisons[1].title == "front, another_front");
    CHECK(comparisons[1].tolerance == comparisons[0].tolerance);
    CHECK_THAT(comparisons[1].units.place, EndsWith("key 'compare[0].references'"));
    const Scene beside =
        parse_scene(read("reference = \"nobody_front\"\nshown = [\"another_front\"]"), "small.toml");
    REQUIRE(beside.analysis.comparisons.size() == 2);
    CHECK(beside.analysis.comparisons[0].judged);
    CHECK(beside.analysis.comparisons[0].title == "front");
    CHECK_FALSE(beside.analysis.comparisons[1].judged);
    CHECK(beside.analysis.comparisons[1].title == "front, another_front");
    const std::vector<std::array<std::string, 3>> table = {
        {"references = []", "references", "expected at least one reference"},
        {"references = \"nobody_front\"", "references", "expected a list of texts"},
        {"references = [1.0]", "references", "expected a list of texts"},
        {"references = [\"a\"]\nreference = \"b\"", "references", "expected none beside 'reference'"},
        {"references = [\"analytic:nothing\"]", "references", "nothing"},
        {"reference = \"a\"\nshown = \"b\"", "shown", "expected a list of texts"},
        {"reference = \"a\"\nshown = [\"analytic:nothing\"]", "shown", "nothing"},
        {"shown = [\"b\"]", "reference", "missing, expected a text"}};
    for (const auto& [keys, key, message] : table) {
        CAPTURE(keys);
        CHECK_THAT(refusal(read(keys)), Contains("key 'compare[0]." + key + "': ") && Contains(message));
    }
}
