// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with an override or a variant, and what the user is told.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::refusal;
using samples::small_scene;

namespace {

std::string refused(const std::string& assignment) {
    return refusal(small_scene, std::nullopt, {assignment});
}

}  // namespace

TEST_CASE("an override without a key or a value is refused") {
    REQUIRE(refused("nokey") == "option --set nokey: expected KEY=VALUE");
    REQUIRE(refused("=3") == "option --set =3: expected KEY=VALUE");
    REQUIRE_THAT(refused(""), Contains("expected KEY=VALUE"));
}

TEST_CASE("an override of an unknown key is refused with the keys that would do") {
    REQUIRE_THAT(refused("run.end_tim=3"),
                 Contains("key 'run.end_tim': unknown, expected one of end_time, "));
}

TEST_CASE("an override of the wrong type or with an unknown word is refused") {
    REQUIRE_THAT(refused("run.end_time=soon"), Contains("key 'run.end_time': expected a finite number"));
    REQUIRE_THAT(refused("model.air=maybe"), Contains("key 'model.air': expected true or false"));
    REQUIRE_THAT(refused("model.dissipation=much"),
                 Contains("key 'model.dissipation': is 'much', expected one of none, "));
    REQUIRE_THAT(refused("run.end_time=nan"), Contains("key 'run.end_time': expected a finite number"));
}

TEST_CASE("an override whose value breaks the quoting is refused") {
    REQUIRE_THAT(refused("title=\"open"), Contains("option --set title=\"open: the value is not valid TOML"));
    REQUIRE_THAT(refused("title=a\nname=b"), Contains("expected KEY=VALUE"));
}

TEST_CASE("an override sets one key only") {
    REQUIRE_THAT(refused("title=\"a\"\nname=\"b\""), Contains("option --set"));
}

TEST_CASE("what is wrong with an override is placed at the option") {
    REQUIRE_THAT(refused("run.end_tim=3"),
                 Catch::StartsWith("option --set run.end_tim=3: key 'run.end_tim': "));
    REQUIRE_THAT(refused("run.end_time=soon"), Catch::StartsWith("option --set run.end_time=soon: "));
}

TEST_CASE("what is wrong with a variant is placed at its line") {
    const std::string text = samples::with("model.air = false", "model.ar = false");
    const std::string line =
        std::to_string(1 + std::count(text.begin(), text.begin() + long(text.find("model.ar ")), '\n'));
    REQUIRE_THAT(refusal(text, "single-phase"),
                 Catch::StartsWith("small.toml:" + line + ": key 'model.ar': unknown"));
}
