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

TEST_CASE("an override reaches into a list by the name of an entry and by a number") {
    const auto with = [](const std::string& override_) {
        return parse_scene(small_scene, "small.toml", "two-phase", {override_});
    };
    const auto height = [](const Scene& scene) { return scene.probes[1].place->begin.y(); };
    CHECK(height(with("probes.gauge.centre.1=0.12")) ==
          Approx(height(with("probes.gauge.diameter=0.08")) + 0.02));
    CHECK(with("probes.gauge.centre.1=0.12").probes.size() == 3);
    CHECK(with("tank.size.1=0.48").tank.high == Vec2(1.0, 0.48));
    const auto [override_, message] = GENERATE(table<const char*, const char*>(
        {{"probes.gage.diameter=0.1", "no entry 'gage', expected the name of one"},
         {"probes.1.diameter=0.1", "no entry '1', expected the name of one"},
         {"probes.gauge.centre.2=0.1", "no entry '2', expected a number from 0 to 1"},
         {"probes.gauge.centre.y=0.1", "no entry 'y', expected a number from 0 to 1"},
         {"tank.size.-1=0.1", "no entry '-1'"},
         {"tank.size.99999999999999999999=0.1", "no entry"},
         {"probes.gauge.size=0.1", "size"},
         {"probes.gauge.centre.1=high", "centre"}}));
    CHECK_THROWS_WITH(with(override_), Catch::Contains(message));
}
