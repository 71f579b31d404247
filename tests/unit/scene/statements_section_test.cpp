// SPDX-License-Identifier: BSD-3-Clause
// [[source_statements]] and [[side_by_side]] of a scene file.
#include <catch2/catch.hpp>
#include <limits>

#include "tests/unit/scene/scene_samples.hpp"

using namespace wetdeck;
using Catch::EndsWith;
using samples::refusal;
using samples::small_scene;

namespace {

const std::string statement = R"toml(
[[source_statements]]
says = "air does not matter"
variants = ["two-phase"]
against = ["single-phase"]
)toml";

const std::string beside = R"toml(
[[side_by_side]]
title = "With and without air"
variants = ["two-phase", "single-phase"]
)toml";

}  // namespace

TEST_CASE("A statement of the source is read with its measure and its limits", "[statements]") {
    const std::string text = small_scene + statement +
                             "measure = \"curve_difference\"\nseries = \"energy_kinetic\"\n"
                             "window = [0.1, 0.2]\nat_most = 0.05\n";
    const Scene scene = parse_scene(text, "small.toml");
    REQUIRE(scene.analysis.statements.size() == 1);
    const SourceStatement& s = scene.analysis.statements.front();
    CHECK(s.measure == SourceStatement::Measure::curve_difference);
    CHECK(s.quantity == "energy_kinetic");
    CHECK(s.against == std::vector<std::string>{"single-phase"});
    CHECK(s.low == -std::numeric_limits<double>::infinity());
    CHECK(s.high == 0.05);
    CHECK(s.window->begin == 0.1);
}

TEST_CASE("Variants side by side are read with a time or a series", "[statements]") {
    const Scene scene =
        parse_scene(small_scene + beside + "time = 0.1\n" + beside + "series = \"mass\"\n", "s");
    REQUIRE(scene.analysis.side_by_side.size() == 2);
    CHECK(scene.analysis.side_by_side[0].time == 0.1);
    CHECK(scene.analysis.side_by_side[1].series == "mass");
}

TEST_CASE("A wrong statement is named with its key", "[statements]") {
    const std::string sound = "measure = \"ratio\"\nquantity = \"front_mean\"\nat_least = 0.9\n";
    const auto refused = [](const std::string& keys) { return refusal(small_scene + statement + keys); };
    const auto [keys, end] = GENERATE(table<std::string, std::string>({
        {"measure = \"product\"\nquantity = \"front_mean\"\nat_least = 1\n",
         "expected one of difference, ratio, curve_difference"},
        {"measure = \"ratio\"\nquantity = \"fronts\"\nat_least = 1\n", "expected one of front_mean"},
        {"measure = \"ratio\"\nat_least = 1\n", "quantity': missing, expected a text"},
        {"measure = \"ratio\"\nquantity = \"front_mean\"\n",
         "at_least': missing, expected the limits within which the statement holds, 'at_least' or 'at_most' "
         "or "
         "both"},
        {"measure = \"ratio\"\nquantity = \"front_mean\"\nat_least = 2\nat_most = 1\n",
         "at_most': expected a number above 'at_least'"},
        {"measure = \"curve_difference\"\nseries = \"mass\"\nwindow = [0.2, 0.1]\nat_most = 1\n",
         "window': expected a low end below the high one"},
    }));
    INFO(keys);
    CHECK_THAT(refused(keys), Catch::Contains(end));
    CHECK_THAT(refused(sound + "colour = 1\n"), Catch::Contains("colour': unknown"));
    CHECK_THAT(refusal(small_scene + "\n[[source_statements]]\nsays = \"x\"\nvariants = [\"three-phase\"]\n" +
                       sound),
               EndsWith("variants': 'three-phase' is not a variant of this scene"));
    CHECK_THAT(
        refusal(small_scene + "\n[[source_statements]]\nsays = \"x\"\nvariants = [\"two-phase\"]\n" + sound),
        EndsWith("against': missing, expected the variants to compare with, or 'against_quantity'"));
}

TEST_CASE("Wrong variants side by side are named with their key", "[statements]") {
    CHECK_THAT(refusal(small_scene + beside), EndsWith("time': missing, expected a time [s], or 'series'"));
    CHECK_THAT(
        refusal(small_scene + "\n[[side_by_side]]\ntitle = \"x\"\nvariants = [\"two-phase\"]\ntime = 0.1\n"),
        EndsWith("variants': expected at least two variants"));
}
