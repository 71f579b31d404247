// SPDX-License-Identifier: BSD-3-Clause
// Energy and momentum errors of made-up budgets.
#include "validation/metrics/conservation.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace wetdeck;

namespace {

RunRecord budget(std::vector<double> kinetic, std::vector<double> potential,
                 std::vector<double> compression) {
    const std::vector<double> time{0, 1, 2, 3};
    RunRecord record;
    record.series["energy_kinetic"] = {"J/m", "", time, std::move(kinetic), {}};
    record.series["energy_potential"] = {"J/m", "", time, std::move(potential), {}};
    record.series["energy_compression"] = {"J/m", "", time, std::move(compression), {}};
    return record;
}

}  // namespace

TEST_CASE("Energy that only falls has no error", "[conservation]") {
    CHECK(energy_error(budget({0, 4, 5, 3}, {10, 6, 4, 4}, {0, 0, 0, 0})) == 0.0);
}

TEST_CASE("The energy error is the largest rise above the lowest total so far over the potential energy",
          "[conservation]") {
    // totals 10, 8, 8.5, 7.9: the largest rise is 0.5 from the second instant
    CHECK(energy_error(budget({0, 2, 3, 3}, {10, 6, 5, 4.9}, {0, 0, 0.5, 0})).value() == Approx(0.5 / 10));
}

TEST_CASE("The scale of the energy error is the change of potential energy where that is larger",
          "[conservation]") {
    // the lowest point is the zero level here: E_potential(0) = 1, change 5; totals 1, 1, 2, 1
    CHECK(energy_error(budget({0, 2, 6, 4}, {1, -1, -4, -3}, {0, 0, 0, 0})).value() == Approx(1.0 / 5));
}

TEST_CASE("An energy budget with a hole has no error value", "[conservation]") {
    RunRecord record = budget({0, 1, 1, 1}, {10, 9, 9, 9}, {0, 0, 0, 0});
    SECTION("a missing series") {
        record.series.erase("energy_compression");
    }
    SECTION("other instants") {
        record.series["energy_kinetic"].time[2] = 2.5;
    }
    SECTION("a NaN") {
        record.series["energy_potential"].value[2] = std::numeric_limits<double>::quiet_NaN();
    }
    SECTION("no potential energy") {
        record.series["energy_potential"].value = {0, 0, 0, 0};
    }
    CHECK_FALSE(energy_error(record).has_value());
}

TEST_CASE("The momentum error is the largest magnitude of its series", "[conservation]") {
    RunRecord record;
    CHECK_FALSE(momentum_error(record).has_value());
    record.series["momentum_error"] = {"-", "", {0, 1, 2}, {0.1, -0.3, 0.2}, {}};
    CHECK(momentum_error(record) == 0.3);
    record.series["momentum_error"].value[0] = std::numeric_limits<double>::infinity();
    CHECK_FALSE(momentum_error(record).has_value());
}
