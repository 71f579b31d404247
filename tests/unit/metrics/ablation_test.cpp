// SPDX-License-Identifier: BSD-3-Clause
// When an ingredient counts as needed.
#include <catch2/catch.hpp>

#include "validation/metrics/ablation.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

AblationValue expected_one(double with, double without) {
    return {"peak", with, without, 2.0, 0.4, {}};
}

AblationValue free_one(double with, double without, std::optional<double> spread) {
    return {"front", with, without, {}, {}, spread};
}

bool needed(const AblationValue& value) {
    return ablation_verdict(true, true, {value}).needed;
}

}  // namespace

TEST_CASE("a change is one of the error where something is expected, else of the value") {
    CHECK(*expected_one(2.5, 1.9).change() == Approx(-0.4));
    CHECK(*expected_one(2.1, 1.7).change() == Approx(0.2));
    CHECK(*free_one(2.5, 1.9, {}).change() == Approx(-0.6));
    CHECK_FALSE(AblationValue{"front", 1.0, {}, {}, {}, {}}.change());
}

TEST_CASE("stability comes before numbers") {
    CHECK(ablation_verdict(true, false, {}).needed);
    CHECK_THAT(ablation_verdict(true, false, {}).reason, Contains("unstable without it"));
    const std::vector<AblationValue> worse = {expected_one(2, 9)};
    CHECK_FALSE(ablation_verdict(false, true, worse).needed);
    CHECK_FALSE(ablation_verdict(false, false, worse).needed);
    CHECK_FALSE(ablation_verdict(true, true, {}).needed);
    CHECK_THAT(ablation_verdict(true, true, {}).reason, Contains("nothing to compare"));
}

TEST_CASE("an error that grows by more than a quarter of the tolerance makes an ingredient needed") {
    CHECK_FALSE(needed(expected_one(2.0, 2.09)));
    CHECK(needed(expected_one(2.0, 2.11)));
    CHECK(needed(expected_one(2.0, 1.89)));
    CHECK_FALSE(needed(expected_one(2.5, 2.0)));  // better without
    CHECK_FALSE(needed(expected_one(2.3, 1.7)));  // as wrong as before, on the other side
}

TEST_CASE("without an expected value the spread over the spacings decides") {
    CHECK(needed(free_one(1.0, 1.3, 0.2)));
    CHECK(needed(free_one(1.0, 0.7, 0.2)));
    CHECK_FALSE(needed(free_one(1.0, 1.1, 0.2)));
    CHECK_FALSE(needed(free_one(1.0, 9.0, {})));  // nothing is known
}

TEST_CASE("an ingredient without which a quantity is not reached is needed") {
    const AblationValue lost{"arrival", 2.4, {}, {}, {}, {}}, gained{"arrival", {}, 2.4, {}, {}, {}};
    CHECK(needed(lost));
    CHECK_FALSE(needed(gained));
}

TEST_CASE("values of two runs: quantities by name, curves against zero, what is not available left out") {
    RunSummary with, without;
    with.quantities = {{"a", "-", 1.0, "", 1.5, 0.1, "", {}},
                       {"b", "-", 2.0, "", {}, {}, "", {}},
                       {"c", "-", {}, "", {}, {}, "", {}}};
    without.quantities = {{"b", "-", 5.0, "", {}, {}, "", {}},
                          {"a", "-", 3.0, "", 1.5, 0.1, "", {}},
                          {"c", "-", {}, "", {}, {}, "", {}}};
    ComparisonResult curve;
    curve.title = "force";
    curve.nrmse = 0.1;
    curve.tolerance = 0.2;
    with.comparisons = {curve};
    curve.nrmse = 0.3;
    without.comparisons = {curve};
    curve.title = "missing";
    curve.available = false;
    with.comparisons.push_back(curve);
    const std::vector<AblationValue> values = ablation_values(with, without, {{"b", 0.5}});
    REQUIRE(values.size() == 3);
    CHECK(values[0].name == "a");
    CHECK(*values[0].change() == Approx(1.0));
    CHECK_FALSE(values[0].spread);
    CHECK(*values[1].change() == Approx(3.0));
    CHECK(*values[1].spread == 0.5);
    CHECK(*values[2].change() == Approx(0.2));
}

TEST_CASE("the spread of a quantity is its range over the spacings of its variant") {
    ConvergenceRow row;
    row.scene = "tank";
    row.variant = "plain";
    row.qoi = "peak";
    row.value = {1.0, 1.4, 1.1};
    ConvergenceRow other = row;
    other.variant = "other";
    other.value = {1.0, 9.0};
    ConvergenceRow single = row;
    single.qoi = "front";
    single.value = {3.0};
    const auto spreads = discretisation_spreads({row, other, single}, "tank", "plain");
    REQUIRE(spreads.size() == 1);
    CHECK(spreads.at("peak") == Approx(0.4));
}
