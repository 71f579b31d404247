// SPDX-License-Identifier: BSD-3-Clause
// Free fall of a wedge and the bounds of a plate.
#include "validation/analytic/wedge_free_fall.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "validation/analytic/plate_bounds.hpp"

using namespace wetdeck;

namespace {

WedgeSimilarity thirty_degrees() {
    return wedge_similarity(std::numbers::pi / 6);
}

}  // namespace

TEST_CASE("Free fall of the drop test follows an independent integration", "[analytic]") {
    const WedgeFall fall = wedge_free_fall(thirty_degrees(), {241, 6.15}, 0.1012, 0.0025);
    // Velocity and force every 2.5 ms, computed with C_F = 14.024 and alpha = 8.304.
    const double velocity[] = {6.15, 6.13241, 6.03496, 5.87142, 5.66093, 5.42295, 5.17381, 4.92547};
    const double force[] = {0, 8063.92, 15228, 20719, 24276.8, 26072.1, 26498.6, 25987.8};
    REQUIRE(fall.time.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(fall.time[i] == Approx(0.0025 * static_cast<double>(i)).margin(1e-15));
        // alpha differs by 0.6 %: that moves V by 1 mm/s and F by 0.15 %.
        CHECK(fall.velocity[i] == Approx(velocity[i]).margin(2e-3));
        CHECK(fall.force[i] == Approx(force[i]).epsilon(2e-3));
    }
}

TEST_CASE("A wedge of endless mass falls as without water, a light one is stopped", "[analytic]") {
    const WedgeFall heavy = wedge_free_fall(thirty_degrees(), {1e12, 6.15}, 0.1, 1e-3);
    CHECK(heavy.velocity.back() == Approx(6.15 + 9.81 * heavy.time.back()).epsilon(1e-8));
    // 1 kg/m displaces its weight at 2.4 cm; the rows end where it stops, above the depth asked for.
    const WedgeFall light = wedge_free_fall(thirty_degrees(), {1, 0.1}, 1, 1e-3);
    CHECK(light.penetration.back() < 0.1);
    CHECK(light.velocity.back() > 0);
}

TEST_CASE("What the falling wedge loses in momentum is the impulse of the forces", "[analytic]") {
    const WedgeFall fall = wedge_free_fall(thirty_degrees(), {241, 6.15}, 0.1, 1e-5);
    double impulse = 0;
    for (std::size_t i = 1; i < fall.time.size(); ++i) {
        impulse +=
            (241 * 9.81 - 0.5 * (fall.force[i] + fall.force[i - 1])) * (fall.time[i] - fall.time[i - 1]);
    }
    CHECK(241 * (fall.velocity.back() - 6.15) ==
          Approx(impulse).epsilon(1e-6));  // trapezoidal rule, 1700 rows
}

TEST_CASE("Bounds of the flat impact of a plate", "[analytic]") {
    const PlateBounds plate = plate_bounds({0.25, 5.5, 128, 1000, 60});
    CHECK(plate.added_mass == Approx(24.544).epsilon(1e-4));  // rho pi 0.125^2/2
    CHECK(plate.plastic_impulse == Approx(113.27).epsilon(1e-4));
    CHECK(plate.plastic_speed_loss == Approx(0.88493).epsilon(1e-4));
    CHECK(plate.acoustic_pressure == Approx(330e3));
    CHECK(plate.acoustic_force == Approx(82.5e3));
    CHECK(plate.acoustic_relief_time == Approx(2.08333e-3).epsilon(1e-5));

    SECTION("plastic: plate and added mass share the momentum") {
        const double after = 5.5 - plate.plastic_speed_loss;
        CHECK((128 + plate.added_mass) * after == Approx(128 * 5.5));
    }
    SECTION("elastic: the energy of plate and added mass is that of the plate before") {
        const double after = 5.5 - plate.elastic_speed_loss;
        const double water = plate.elastic_impulse / plate.added_mass;
        CHECK(128 * after * after + plate.added_mass * water * water == Approx(128 * 5.5 * 5.5));
    }
    SECTION("a plate that is held gives the added mass its full speed") {
        const PlateBounds held =
            plate_bounds({0.25, 5.5, std::numeric_limits<double>::infinity(), 1000, 1450});
        CHECK(held.plastic_impulse == Approx(plate.added_mass * 5.5));
        CHECK(held.plastic_speed_loss == 0);
        CHECK(std::isfinite(held.elastic_impulse));
    }
}
