// SPDX-License-Identifier: BSD-3-Clause
// The similarity flow of a wedge against an independent solution, against itself and against momentum theory.
#include "validation/analytic/wedge_similarity.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"
#include "validation/analytic/wagner.hpp"

using namespace wetdeck;

namespace {

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// An independent numerical solution of the same problem (1200 to 1500 nodes), angles in degrees.
struct Known {
    double deadrise, force, maximum_pressure, height, apex_pressure, tip_x, tip_z, contact_angle;
};

}  // namespace

TEST_CASE("The similarity solution of a wedge agrees with an independent one", "[analytic]") {
    const Known known = GENERATE(Known{10, 212.972, 77.7288, 0.554877, 16.4371, 17.5717, 2.09836, 0.240002},
                                 Known{20, 42.2833, 17.7405, 0.508276, 7.52496, 8.22505, 1.99367, 0.859184},
                                 Known{25, 23.5778, 10.6748, 0.472021, 5.76336, 6.26230, 1.92016, 1.28411},
                                 Known{30, 14.0240, 6.89632, 0.425808, 4.60022, 4.90773, 1.83348, 1.78053},
                                 Known{40, 5.44785, 3.25294, 0.290199, 3.17079, 3.12698, 1.62385, 2.99046},
                                 Known{60, 0.804609, 1.80418, -1, 1.80418, 1.20332, 1.08421, 6.46248});
    CAPTURE(known.deadrise);
    const WedgeSimilarity wedge = wedge_similarity(radians(known.deadrise));
    // The other solution states about 0.1 % for force, pressure and lengths, 0.001 for the height of a flat
    // maximum.
    CHECK(wedge.force_coefficient == Approx(known.force).epsilon(0.001));
    CHECK(wedge.maximum_pressure == Approx(known.maximum_pressure).epsilon(0.001));
    CHECK(wedge.maximum_pressure_height == Approx(known.height).margin(0.001));
    CHECK(wedge.apex_pressure == Approx(known.apex_pressure).epsilon(0.001));
    CHECK(wedge.tip_x == Approx(known.tip_x).epsilon(0.001));
    CHECK(wedge.tip_z == Approx(known.tip_z).epsilon(0.001));
    CHECK(wedge.contact_angle == Approx(radians(known.contact_angle)).epsilon(0.001));
    // Two expressions for the wetted length that only the right contact angle brings together: 5e-6 and less
    // here.
    CHECK(std::abs(wedge.closure) < 1e-5);
}

TEST_CASE("Towards a flat bottom the force becomes that of Wagner, by a first-order term", "[analytic]") {
    // (1 - F/F_Wagner) / deadrise, which has a limit: the solution between 2 and 8 degrees is no stranger
    const auto defect = [](double degrees) {
        const double b = radians(degrees),
                     wagner = std::pow(std::numbers::pi, 3) / (4 * std::pow(std::tan(b), 2));
        const WedgeSimilarity wedge = wedge_similarity(b);
        CAPTURE(degrees);
        CHECK(std::abs(wedge.closure) < 1e-5);
        return (1 - wedge.force_coefficient / wagner) / b;
    };
    const double at_8 = defect(8), at_7_5 = defect(7.5), at_4 = defect(4), at_2 = defect(2);
    CHECK(at_8 < at_7_5);
    CHECK(at_7_5 < at_4);
    CHECK(at_4 < at_2);
    CHECK(at_2 - at_4 == Approx((at_4 - at_8) / 2).epsilon(0.15));  // nearly straight
    CHECK(wedge_similarity(radians(4)).force_coefficient == Approx(1489.92).epsilon(1e-5));
    CHECK(wedge_similarity(radians(7.5)).force_coefficient == Approx(397.695).epsilon(1e-5));
}

TEST_CASE("Curves of the similarity solution fit its numbers and conserve the volume of water",
          "[analytic]") {
    const double deadrise = radians(30);
    const WedgeSimilarity wedge = wedge_similarity(deadrise);
    const Curve& pressure = wedge.pressure;
    CHECK(pressure.x.front() == -1);
    CHECK(pressure.x.back() == wedge.tip_z);
    CHECK(std::is_sorted(pressure.x.begin(), pressure.x.end(), std::less_equal<>{}));
    double integral = 0;
    for (std::size_t i = 1; i < pressure.x.size(); ++i) {
        integral += 0.5 * (pressure.y[i] + pressure.y[i - 1]) * (pressure.x[i] - pressure.x[i - 1]);
    }
    // F = 2 cot(beta) times the integral of Cp/2 over the height; linear interpolation between 547 points.
    CHECK(integral / std::tan(deadrise) == Approx(wedge.force_coefficient).epsilon(1e-3));

    // What the wedge displaces stands above the level: the area between surface and face (x counted along z)
    // is zero in all. The far surface falls off as c/x^2, which leaves c/x beyond the last point.
    double above = 0;
    for (std::size_t i = 1; i < wedge.surface_x.size(); ++i) {
        above += 0.5 * (wedge.surface_z[i] + wedge.surface_z[i - 1]) *
                 (wedge.surface_x[i] - wedge.surface_x[i - 1]);
    }
    above += wedge.surface_x.back() * wedge.surface_z.back();
    const double face = 0.5 * wedge.tip_x * (wedge.tip_z - 1);  // integral of z dx from the apex to the tip
    CHECK(above + face ==
          Approx(0).margin(2e-3));  // of 0.87 displaced: the other solution's far level is off 3e-4
}

TEST_CASE("Between von Karman and Wagner at a small deadrise, nearer to Wagner", "[analytic]") {
    // Both are expansions for a flat wedge: the error of Wagner's grows with the deadrise, 15 % at 8 degrees.
    double gap = 0;
    for (const double degrees : {30.0, 20.0, 8.0}) {
        const WedgeSimilarity wedge = wedge_similarity(radians(degrees));
        const double ratio = wedge.force_coefficient / wagner_force_coefficient(wedge.deadrise);
        CHECK(ratio > gap);
        CHECK(ratio < 1);
        CHECK(wedge.maximum_pressure < wagner_maximum_pressure(wedge.deadrise));
        CHECK(wedge.maximum_pressure_height < wagner_rise());
        gap = ratio;
    }
    const WedgeSimilarity flat = wedge_similarity(radians(8));
    CHECK(flat.force_coefficient > von_karman_force_coefficient(flat.deadrise));
}

TEST_CASE("Wagner and von Karman: the published closed forms", "[analytic]") {
    const double cot = 1 / std::tan(radians(30));
    CHECK(wagner_force_coefficient(radians(30)) == Approx(23.2547).epsilon(1e-5));  // (pi^3/4) cot^2
    CHECK(wagner_maximum_pressure(radians(30)) == Approx(7.4022).epsilon(1e-5));    // (pi^2/4) cot^2
    CHECK(von_karman_force_coefficient(radians(30)) == Approx(std::numbers::pi * cot * cot));
}

TEST_CASE("The added mass of the wetted wedge, against another quadrature and against a plate",
          "[analytic]") {
    // An independent quadrature of the same map gives 8.304 at 30 and 13.41 at 25 degrees, 0.6 and 0.7 % less
    // than here; which of the two is nearer is not settled. Ours does not move by 1e-6 when the tip is cut
    // off elsewhere.
    CHECK(wedge_similarity(radians(30)).added_mass_coefficient == Approx(8.304).epsilon(0.01));
    CHECK(wedge_similarity(radians(25)).added_mass_coefficient == Approx(13.41).epsilon(0.01));
    // A plate as wide as the wetted wedge (x of the spray root) has (pi/2) c^2; the wedge, with a face that
    // is not flat, has less, and comes near to it as the deadrise falls.
    double ratio = 0;
    for (const double degrees : {20.0, 10.0, 8.0}) {
        const WedgeSimilarity wedge = wedge_similarity(radians(degrees));
        const double c = (1 + wedge.maximum_pressure_height) / std::tan(wedge.deadrise);
        const double now = wedge.added_mass_coefficient / (std::numbers::pi / 2 * c * c);
        CHECK(now > ratio);
        CHECK(now < 1);
        ratio = now;
    }
    CHECK(ratio > 0.85);
}

TEST_CASE("The chine is wet when the pressure maximum reaches it", "[analytic]") {
    // 0.25 m at 30 degrees: (1 + 0.4258) z cot(30) = 0.25 m.
    CHECK(chine_wetting_penetration(wedge_similarity(radians(30)), 0.25) == Approx(0.1012).epsilon(0.001));
}

TEST_CASE("A deadrise outside of the covered range is refused", "[analytic]") {
    CHECK_THROWS_AS(wedge_similarity(radians(1.5)), InputError);
    CHECK_THROWS_AS(wedge_similarity(radians(80)), InputError);
    CHECK_THROWS_AS(wedge_similarity(std::nan("")), InputError);
}

TEST_CASE("a wedge whose largest pressure is at the keel does not tell when its chines are wet",
          "[analytic]") {
    const auto wetting = [](double degrees) {
        return chine_wetting_penetration(wedge_similarity(degrees * std::numbers::pi / 180), 0.25);
    };
    CHECK(wetting(40) > 0);
    CHECK_THROWS_AS(wetting(50), InputError);
}
