// SPDX-License-Identifier: BSD-3-Clause
#include "validation/import/imported_curve.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "import_support.hpp"
#include "validation/metrics/reference.hpp"

using namespace wetdeck;
using Catch::Matchers::Contains;

namespace {

CodeRecord record_of(const std::string& name, const std::string& unit) {
    CodeRecord record;
    record.code = "OpenFOAM";
    record.version = "v1912";
    record.phase = "two-phase";
    record.time_unit = "s";
    record.files = {"force.dat"};
    record.time = {0, 0.5, 1};
    record.columns = {{name, unit, "", "", {1, std::numeric_limits<double>::quiet_NaN(), 3}}};
    return record;
}

ImportChoices choices() {
    ImportChoices chosen;
    chosen.setup = "a wedge";
    chosen.sign = "upwards";
    return chosen;
}

Reference curve_of(const CodeRecord& record, const ImportChoices& chosen) {
    return parse_reference("curve.csv", imported_curve(record, chosen, "2026-01-31"));
}

std::string problem_of(const CodeRecord& record, const ImportChoices& chosen) {
    return message_of([&] { imported_curve(record, chosen, "2026-01-31"); });
}

}  // namespace

TEST_CASE(
    "An imported curve is a whole reference: nothing recommended is missing, missing values are empty") {
    const Reference curve = curve_of(record_of("x", "mm"), choices());
    CHECK(missing_recommended_keys(curve).empty());
    CHECK(curve.kind == ReferenceKind::peer_simulation);
    CHECK(curve.citation == "OpenFOAM v1912, a wedge");
    CHECK(curve.columns[1].empty_cells == 1);
    CHECK(curve.columns[1].given_unit == "m");
    CHECK(curve.columns[1].values[2] == Approx(0.003));
}

TEST_CASE("Loads are divided by the layer, which is asked for where the mesh does not tell") {
    CodeRecord record = record_of("force_y", "N");
    CHECK_THAT(problem_of(record, choices()), Contains("--layer"));
    ImportChoices chosen = choices();
    chosen.layer = 0.5;
    CHECK(curve_of(record, chosen).columns[1].values[2] == Approx(6));
    CHECK(curve_of(record, chosen).columns[1].given_unit == "N/m");
    record.layer = 0.25;
    CHECK_THAT(problem_of(record, chosen), Contains("the mesh of the case is 0.25 m thick"));
    chosen.layer.reset();
    chosen.factor = 2;
    CHECK(curve_of(record, chosen).columns[1].values[2] == Approx(24));
    CHECK(curve_of(record_of("moment_z", "N m"),
                   [] {
                       auto c = choices();
                       c.layer = 2;
                       return c;
                   }())
              .columns[1]
              .given_unit == "N");
}

TEST_CASE("Pressures need a datum, and absolute ones what is taken off") {
    CodeRecord record = record_of("p_0", "kPa");
    ImportChoices chosen = choices();
    CHECK_THAT(problem_of(record, chosen), Contains("--datum"));
    chosen.datum = "gauge";
    CHECK(curve_of(record, chosen).columns[1].values[2] == Approx(3000));
    chosen.datum = "absolute";
    CHECK_THAT(problem_of(record, chosen), Contains("--reference-pressure"));
    chosen.reference_pressure = 1000;
    CHECK(curve_of(record, chosen).columns[1].values[2] == Approx(2000));
    chosen.datum = "sea level";
    CHECK_THAT(problem_of(record, chosen), Contains("expected gauge or absolute"));
}

TEST_CASE("A pressure without rho g h is taken only where the user says so") {
    const CodeRecord record = record_of("p_rgh_0", "Pa");
    ImportChoices chosen = choices();
    chosen.datum = "gauge";
    CHECK_THAT(problem_of(record, chosen), Contains("--pressure"));
    chosen.pressure = "p";
    CHECK_THAT(problem_of(record, chosen), Contains("is p_rgh"));
    chosen.pressure = "p_rgh";
    CHECK_THAT(curve_of(record, chosen).keys.at("note"), Contains("p_rgh"));
}

TEST_CASE("All that the files do not say is asked for in one line") {
    CodeRecord record = record_of("Force", "");
    record.code = record.version = record.phase = record.time_unit = "";
    const std::string problem = problem_of(record, {});
    for (const char* option : {"--unit", "--time-unit", "--code ", "--code-version", "--phase", "--setup"})
        CHECK_THAT(problem, Contains(option));
}

TEST_CASE("A column is chosen by name where there are several") {
    CodeRecord record = record_of("a", "m");
    record.columns.push_back({"b", "m/s", "", "", {4, 5, 6}});
    ImportChoices chosen = choices();
    CHECK_THAT(problem_of(record, chosen), Contains("--column is missing: expected one of a, b"));
    chosen.columns = {"c"};
    CHECK_THAT(problem_of(record, chosen), Contains("--column c: no such column"));
    chosen.columns = {"b", "a"};
    const Reference curve = curve_of(record, chosen);
    CHECK(curve.columns[1].name == "b");
    CHECK(curve.columns[2].name == "a");
    record.columns[0].values.assign(3, std::numeric_limits<double>::quiet_NaN());
    CHECK_THAT(problem_of(record, chosen), Contains("--column a: holds no value"));
}
