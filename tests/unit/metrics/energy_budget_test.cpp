// SPDX-License-Identifier: BSD-3-Clause
// Changes of made-up energies and sums.
#include "validation/metrics/energy_budget.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

namespace {

RunRecord budget(std::vector<double> potential) {
    const std::vector<double> time{0, 1, 2};
    RunRecord record;
    record.series["energy_kinetic"] = {"J/m", "", time, {0, 2, 1}, {}};
    record.series["energy_potential"] = {"J/m", "", time, std::move(potential), {}};
    record.series["energy_compression"] = {"J/m", "", time, {1, 1, 1.5}, {}};
    return record;
}

}  // namespace

TEST_CASE("Energies are changes since the start over the initial potential energy", "[energy_budget]") {
    const auto changes = energy_changes(budget({-4, -6, -6}));
    REQUIRE(changes.has_value());
    CHECK(changes->kinetic.x == std::vector<double>{0, 1, 2});
    CHECK(changes->kinetic.y == std::vector<double>{0, 0.5, 0.25});
    CHECK(changes->potential.y == std::vector<double>{0, -0.5, -0.5});
    CHECK(changes->compression.y == std::vector<double>{0, 0, 0.125});
    CHECK(changes->total.y == std::vector<double>{0, 0, -0.125});
}

TEST_CASE("There is no change of energy without all three, on one clock, from a height", "[energy_budget]") {
    RunRecord record = budget({4, 3, 2});
    CHECK(energy_changes(record).has_value());
    SECTION("a missing series") {
        record.series.erase("energy_kinetic");
    }
    SECTION("other instants") {
        record.series["energy_compression"].time[2] = 2.5;
    }
    SECTION("no initial potential energy") {
        record.series["energy_potential"].value[0] = 0;
    }
    CHECK_FALSE(energy_changes(record).has_value());
}

TEST_CASE("The drift of a sum is its largest deviation from the start, in either direction",
          "[energy_budget]") {
    RunRecord record;
    record.series["mass"] = {"kg/m", "", {0, 1, 2}, {2, 2.2, 1.5}, {}};
    CHECK(relative_drift(record, "mass").value() == Approx(0.25));
    CHECK(largest_value(record, "mass") == 2.2);
    record.series["mass"].value[0] = 0;
    CHECK_FALSE(relative_drift(record, "mass").has_value());
    CHECK_FALSE(relative_drift(record, "area").has_value());
    CHECK_FALSE(largest_value(record, "area").has_value());
}

TEST_CASE("The loss of energy is the change with the other sign, and a series like any other",
          "[energy_budget]") {
    RunRecord record = budget({-4, -6, -6});
    add_energy_loss(record);
    const Series& loss = record.series.at("energy_loss");
    CHECK(loss.unit == "-");
    CHECK(loss.time == std::vector<double>{0, 1, 2});
    CHECK(loss.value == std::vector<double>{0, 0, 0.125});
    record.series["energy_loss"].value = {1, 2, 3};
    add_energy_loss(record);
    CHECK(record.series.at("energy_loss").value == std::vector<double>{1, 2, 3});  // what is there stays
    RunRecord without = budget({0, 1, 2});
    add_energy_loss(without);
    CHECK(without.series.count("energy_loss") == 0);
}
