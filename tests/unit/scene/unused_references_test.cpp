// SPDX-License-Identifier: BSD-3-Clause
// [[unused_references]]: reference files of a scene that no comparison uses; and the key that aligns peaks.
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/metrics/reference_use.hpp"

using namespace wetdeck;
using Catch::EndsWith;
using samples::refusal;
using samples::small_scene;

namespace {

std::string unused(const std::string& file, const std::string& reason) {
    return "\n[[unused_references]]\nfile = " + file + "\nreason = " + reason + "\n";
}

std::string aligned(const std::string& lines) {
    return samples::with("tolerance = 0.1\n", "tolerance = 0.1\n" + lines + "\n");
}

}  // namespace

TEST_CASE("Unused references are read with their reasons", "[unused_references]") {
    const Scene scene = parse_scene(small_scene + unused("\"one\"", "\"another shape\""), "small.toml");
    REQUIRE(scene.analysis.unused_references.size() == 1);
    CHECK(scene.analysis.unused_references[0].file == "one");
    CHECK(scene.analysis.unused_references[0].reason == "another shape");
}

TEST_CASE("A wrong entry of the unused references is named with its key", "[unused_references]") {
    using Row = std::tuple<std::string, std::string, std::string>;
    const auto [file, reason, expected] = GENERATE(table<std::string, std::string, std::string>(
        {Row{"1", "\"x\"", "[0].file': expected a text in quotes"},
         Row{"\"\"", "\"x\"",
             "[0].file': '' is no name of a reference file, expected the part before .csv, "
             "without folders"},
         Row{"\"a.csv\"", "\"x\"",
             "[0].file': 'a.csv' is no name of a reference file, expected the part before "
             ".csv, without folders"},
         Row{"\"small/a\"", "\"x\"",
             "[0].file': 'small/a' is no name of a reference file, expected the part "
             "before .csv, without folders"},
         Row{"\"nobody_front\"", "\"x\"",
             "[0].file': 'nobody_front' is a reference of this scene, expected one "
             "that no comparison or quantity uses"},
         Row{"\"a\"", "\"\"", "[0].reason': expected why no comparison uses the file"},
         Row{"\"a\"", "3", "[0].reason': expected a text in quotes"},
         Row{"\"a\"", "\"x\"\nnote = \"y\"", "[0].note': unknown, expected one of file, reason"}}));
    CHECK_THAT(refusal(small_scene + unused(file, reason)), EndsWith("key 'unused_references" + expected));
    const std::string once = unused("\"a\"", "\"x\"");
    CHECK_THAT(refusal(small_scene + once + once),
               EndsWith("key 'unused_references[1].file': 'a' is listed twice"));
}

TEST_CASE("A file that is neither compared with nor listed is found", "[unused_references]") {
    const samples::ScratchFolder folder;
    for (const char* name : {"nobody_front.csv", "listed.csv", "forgotten.csv", "README.md"})
        samples::put_bytes(folder / name, "");
    const Scene scene = parse_scene(small_scene + unused("\"listed\"", "\"x\""), "small.toml");
    CHECK(unmentioned_references({scene.analysis}, folder) == std::set<std::string>{"forgotten"});
    CHECK(unmentioned_references({scene.analysis}, folder / "nowhere").empty());
}

TEST_CASE("A comparison is aligned on the peak or not at all, without another origin", "[align]") {
    const auto reads = [](const std::string& text) {
        return parse_scene(text, "small.toml").analysis.comparisons.at(0).align_peaks;
    };
    CHECK(reads(aligned("align = \"peak\"")));
    CHECK_FALSE(reads(small_scene));
    const std::string why =
        "': expected none beside 'align = \"peak\"', which puts the origin at the largest value of each "
        "curve "
        "over time";
    CHECK_THAT(refusal(aligned("align = \"start\"")),
               EndsWith("key 'compare[0].align': is 'start', expected one of peak"));
    CHECK_THAT(refusal(aligned("align = true")),
               EndsWith("key 'compare[0].align': expected a text in quotes"));
    CHECK_THAT(refusal(aligned("align = \"peak\"\ninstant = 0.1")),
               EndsWith("key 'compare[0].instant" + why));
    CHECK_THAT(refusal(samples::replaced(aligned("align = \"peak\"\nx_origin = \"contact\""), "[scales]\n",
                                         "[time_origins]\ncontact = 0.1\n\n[scales]\n")),
               EndsWith("key 'compare[0].x_origin" + why));
}
