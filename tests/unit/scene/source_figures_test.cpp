// SPDX-License-Identifier: BSD-3-Clause
// [[source_figures]]: figures of a scene's sources and where the report shows the same.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "reports/page/html.hpp"
#include "tests/unit/scene/scene_samples.hpp"

using namespace wetdeck;
using Catch::Contains;
using Catch::EndsWith;
using samples::refusal;
using samples::small_scene;

namespace {

std::string figure(const std::string& keys) {
    return "\n[[source_figures]]\n" + keys;
}

const std::string sound = "number = \"3a\"\nshows = \"the front\"\nplaces = [\"small-two-phase-front\"]\n";

}  // namespace

TEST_CASE("Figures of the source are read in the order of the file", "[source_figures]") {
    const std::string others =
        "number = \"3a\"\nshows = \"a photograph\"\nremark = \"not drawn\"\nsource = \"another author\"\n";
    const Scene scene = parse_scene(small_scene + figure(sound) + figure(others), "small.toml");
    REQUIRE(scene.analysis.source_figures.size() == 2);
    const SourceFigure& first = scene.analysis.source_figures[0];
    CHECK(first.number == "3a");
    CHECK(first.shows == "the front");
    CHECK(first.places == std::vector<std::string>{"small-two-phase-front"});
    CHECK(first.remark.empty());
    CHECK(first.source == "none");  // the scene's own
    const SourceFigure& second = scene.analysis.source_figures[1];
    CHECK(second.places.empty());
    CHECK(second.remark == "not drawn");
    CHECK(second.source == "another author");
}

TEST_CASE("A wrong entry of the figures is named with its line and key", "[source_figures]") {
    const auto refused = [](const std::string& keys) { return refusal(small_scene + figure(keys)); };
    const auto lines = static_cast<int>(std::count(small_scene.begin(), small_scene.end(), '\n'));
    CHECK(refused(sound + "colour = \"red\"\n") ==
          "small.toml:" + std::to_string(lines + 6) +
              ": key 'source_figures[0].colour': unknown, expected one of curves, number, places, remark, "
              "shows, source");
    CHECK_THAT(refused("shows = \"x\"\nremark = \"y\"\n"),
               EndsWith("key 'source_figures[0].number': missing, expected a text"));
    CHECK_THAT(refused("number = 3\nshows = \"x\"\nremark = \"y\"\n"),
               EndsWith("key 'source_figures[0].number': expected a text in quotes"));
    CHECK_THAT(refused("number = \"\"\nshows = \"x\"\nremark = \"y\"\n"),
               EndsWith("key 'source_figures[0].number': expected the number of a figure"));
    CHECK_THAT(refused("number = \"3\"\nremark = \"y\"\n"),
               EndsWith("key 'source_figures[0].shows': missing, expected a text"));
    CHECK_THAT(refused("number = \"3\"\nshows = \"x\"\n"),
               EndsWith("key 'source_figures[0].places': missing, expected a list of anchors of the report, "
                        "or a remark that says why there is no counterpart"));
    CHECK_THAT(refused("number = \"3\"\nshows = \"x\"\nplace = [\"a\"]\n"),
               Contains("key 'source_figures[0].place': unknown; 'places' is missing"));
    CHECK_THAT(refused("number = \"3\"\nshows = \"x\"\nplaces = []\n"),
               Contains("key 'source_figures[0].places': expected a list of anchors"));
    CHECK_THAT(refused("number = \"3\"\nshows = \"x\"\nplaces = \"a\"\n"),
               EndsWith("key 'source_figures[0].places': expected a list of texts"));
    CHECK_THAT(refused("number = \"3\"\nshows = \"x\"\nplaces = [\"#Front\"]\n"),
               EndsWith("key 'source_figures[0].places': '#Front' is no anchor of the report, expected "
                        "lower-case letters, digits and hyphens"));
    CHECK_THAT(refused(sound + figure(sound)),
               EndsWith("key 'source_figures[1].number': '3a' is used twice for one source"));
    CHECK_THAT(refusal(small_scene + "\n[source_figures]\nnumber = \"3\"\n"),
               Contains("key 'source_figures': expected an array of tables"));
}

TEST_CASE("Curves of a figure are references of the scene", "[source_figures]") {
    const auto with_curves = [](const std::string& curves) {
        return small_scene + figure(sound + "curves = " + curves + "\n");
    };
    const Scene scene = parse_scene(with_curves("[\"nobody_front\"]"), "small.toml");
    REQUIRE(scene.analysis.source_figures[0].curves.size() == 1);
    CHECK(scene.analysis.source_figures[0].curves[0].reference == "nobody_front");
    const auto [curves, expected] = GENERATE(table<std::string, std::string>(
        {{"[\"other\"]",
          "'other' is not the reference of any [[compare]], expected one that the report can show"},
         {"[\"nobody_front.csv\"]",
          "'nobody_front.csv' is no name of a reference file, expected the part before "
          ".csv, without folders"},
         {"[\"small/nobody_front\"]",
          "'small/nobody_front' is no name of a reference file, expected the part "
          "before .csv, without folders"},
         {"[\"\"]", "'' is no name of a reference file, expected the part before .csv, without folders"},
         {"\"nobody_front\"", "expected a list of texts"},
         {"[1]", "expected a list of texts"}}));
    CHECK_THAT(refusal(with_curves(curves)), EndsWith("key 'source_figures[0].curves': " + expected));
}

TEST_CASE("Figures of the shipped scenes are all of their source and point into the chapter of their scene",
          "[source_figures]") {
    std::set<int> numbers;
    for (const std::string& name : scene_names()) {
        const Scene scene = read_scene(find_scene(name));
        const std::string anchor = report::slug(name);
        for (const SourceFigure& source : scene.analysis.source_figures) {
            numbers.insert(std::stoi(source.number));
            INFO(name << " " << source.number);
            // the first draws the method and shows nothing of a scene
            CHECK(source.places.empty() == (source.number == "1"));
            for (const std::string& place : source.places) {
                INFO(place);
                const bool own = place.rfind(anchor + "-", 0) == 0 ||
                                 place.rfind("section-" + anchor + "-", 0) == 0 ||
                                 place == "set-up-" + anchor;
                CHECK(own);
            }
        }
    }
    CHECK(numbers.size() == 24);
    CHECK(*numbers.begin() == 1);
    CHECK(*numbers.rbegin() == 24);
}
