// SPDX-License-Identifier: BSD-3-Clause
// Units of columns and scales: what each is in the SI, and which texts are no units of mechanics.
#include "validation/metrics/units.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solver/core/errors.hpp"

using namespace wetdeck;
using Catch::Contains;

TEST_CASE("Units are converted to those of the SI", "[units]") {
    const double pi = std::acos(-1.0);
    const auto [text, factor, name] = GENERATE_COPY(table<std::string, double, std::string>({
        {"-", 1.0, "-"},
        {"1", 1.0, "-"},
        {"%", 0.01, "-"},
        {"mm", 1e-3, "m"},
        {"cm", 1e-2, "m"},
        {"km", 1e3, "m"},
        {"ft", 0.3048, "m"},
        {"ms", 1e-3, "s"},
        {"us", 1e-6, "s"},
        {"µs", 1e-6, "s"},
        {"min", 60.0, "s"},
        {"h", 3600.0, "s"},
        {"Hz", 1.0, "Hz"},
        {"kHz", 1e3, "Hz"},
        {"1/s", 1.0, "Hz"},
        {"kPa", 1e3, "Pa"},
        {"MPa", 1e6, "Pa"},
        {"mbar", 100.0, "Pa"},
        {"bar", 1e5, "Pa"},
        {"psi", 6894.757293168, "Pa"},
        {"N/mm^2", 1e6, "Pa"},
        {"kN", 1e3, "N"},
        {"kN/m", 1e3, "N/m"},
        {"N/cm", 100.0, "N/m"},
        {"kN s/m", 1e3, "N s/m"},
        {"N·s/m", 1.0, "N s/m"},
        {"kgf", 9.80665, "N"},
        {"cm/s", 1e-2, "m/s"},
        {"km/h", 1 / 3.6, "m/s"},
        {"knots", 1852.0 / 3600, "m/s"},
        {"m s-1", 1.0, "m/s"},
        {"m/s2", 1.0, "m/s^2"},
        {"m/s²", 1.0, "m/s^2"},
        {"m/s**2", 1.0, "m/s^2"},
        {"g", 9.80665, "m/s^2"},
        {"g0", 9.80665, "m/s^2"},
        {"g/cm^3", 1e3, "kg/m^3"},
        {"t/m", 1e3, "kg/m"},
        {"l/min", 1e-3 / 60, "m^3/s"},
        {"l/s", 1e-3, "m^3/s"},
        {"deg", pi / 180, "rad"},
        {"°", pi / 180, "rad"},
        {"mrad", 1e-3, "rad"},
        {"deg/s", pi / 180, "rad/s"},
        {"deg/s^2", pi / 180, "rad/s^2"},
        {"rpm", pi / 30, "rad/s"},
        {"kg m/s^2", 1.0, "N"},
        {"m^2/s^3", 1.0, "m^2 s^-3"},
    }));
    INFO(text);
    const Unit unit = unit_named(text);
    CHECK(unit.factor == Approx(factor).epsilon(1e-12));
    CHECK(si_name(unit.powers) == name);
    CHECK(unit.text == text);
}

TEST_CASE("Texts that name no unit of mechanics are refused", "[units]") {
    const std::string text =
        GENERATE("", "furlongs per eternity", "x", "kpa", "Nm", "G", "1000 N", "0.5", "1e3", "degC", "°C",
                 "K", "V", "mS", "A", "cd", "mol", "s since 2026-01-01", "lg(re 1 mW)", "dB", "m;s");
    INFO(text);
    CHECK_THROWS_AS(unit_named(text), InputError);
    CHECK_THROWS_WITH(unit_named(text),
                      Contains("unknown unit '" + text + "'") && Contains("expected -, or a"));
}

TEST_CASE("A rate of angle is no frequency, and a time no frequency turned round", "[units]") {
    CHECK_FALSE(same_dimension(unit_named("rad/s"), unit_named("Hz")));
    CHECK_FALSE(same_dimension(unit_named("s"), unit_named("Hz")));
    CHECK_FALSE(same_dimension(unit_named("rad"), unit_named("-")));
    CHECK_FALSE(same_dimension(unit_named("mg"), unit_named("m/s^2")));
    CHECK(same_dimension(unit_named("km/h"), unit_named("m/s")));
    CHECK((unit_named("N/m") / unit_named("kg/m")).text == "m/s^2");
    CHECK((unit_named("N/m") * unit_named("s")).text == "N s/m");
}

TEST_CASE("units at sea that would be read as other ones are refused by name", "[units]") {
    for (const char* text : {"nmi", "nmi/h", "nmi h-1", "fm", "fm^2"})
        CHECK_THROWS_WITH(unit_named(text), Contains("in full"));
    for (const char* text : {"ton", "tons", "ton/m", "kg ton-1"})
        CHECK_THROWS_WITH(unit_named(text), Contains("expected t (1000 kg), short_ton or long_ton"));
    CHECK_THROWS_WITH(unit_named("ton_force"), Contains("expected a force in kN"));
    for (const char* text : {"mH2O", "mH2O/s"}) CHECK_THROWS_WITH(unit_named(text), Contains("'m H2O'"));
    CHECK(unit_named("m H2O").factor == Approx(9806.65));
    CHECK(unit_named("cmH2O").factor == Approx(98.0665));
    CHECK(same_dimension(unit_named("m H2O"), unit_named("Pa")));
    CHECK(unit_named("t/m3").factor == Approx(1000));
    CHECK(unit_named("long_ton").factor == Approx(1016.0469));
    CHECK(unit_named("nautical_mile").factor == Approx(1852));
    CHECK(unit_named("fathom").factor == Approx(1.8288).epsilon(1e-4));
    CHECK(unit_named("knot").factor == Approx(1852 / 3600.0));
    CHECK(unit_named("nm").factor == Approx(1e-9));
}
