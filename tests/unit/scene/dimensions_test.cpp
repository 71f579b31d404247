// SPDX-License-Identifier: BSD-3-Clause
// Series, columns, scales, origins and units of quantities: what agrees in dimension is compared, anything
// else is refused with both units named.
#include "validation/metrics/dimensions.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/metrics/reference_check.hpp"

using namespace wetdeck;
using Catch::Contains;
using Catch::EndsWith;
using samples::ScratchFolder;

namespace {

const std::string head =
    "# kind: experiment\n# citation: Someone (2000)\n# doi: none\n# figure: 1\n# obtained: tabulated\n"
    "# obtained_from: here\n# date: 2026-01-31\n# digitisation_error: none\n# u_data: 0.05\n"
    "# u_data_source: text\n# sensor: gauge\n# filter: none\n# sign: up\n# time_origin: release\n# note: "
    "none\n";

/// The small scene with more scales, and a comparison of a series with the columns of a.csv.
std::string compared(const std::string& series, const std::string& more = "") {
    const std::string scales =
        samples::replaced(samples::small_scene, "length = 0.2\n",
                          "length = 0.2\npressure = \"2 kPa\"\nheight = \"20 cm\"\nmoment = \"100 ms\"\n");
    return scales + "\n[[compare]]\ntitle = \"a\"\nquantity = \"" + series +
           "\"\nreference = \"a\"\nx_column = \"x\"\ny_column = \"y\"\ntolerance = 0.1\n" + more;
}

/// What is said against that comparison with a curve of these two columns; empty if nothing.
std::string refusal(const std::string& scene, const std::string& titles) {
    const ScratchFolder folder;
    samples::put_bytes(folder / "a.csv", head + titles + "\n0,1\n1,2\n");
    samples::put_bytes(folder / "s.toml", scene);
    try {
        const Scene read = read_scene(folder / "s.toml");
        ReferenceShelf shelf(folder / "none", read.analysis.folder);
        const std::set<std::string> missing = check_references(read.analysis, shelf);
        CHECK(missing == std::set<std::string>{"nobody_front"});
    } catch (const InputError& error) {
        CHECK_THAT(error.what(), Contains("s.toml:"));
        return error.what();
    }
    return {};
}

std::string with_quantity(const std::string& lines) {
    return samples::small_scene + "\n[[quantities]]\nname = \"q\"\nwindow = [0.01, 0.1]\n" + lines;
}

std::string unit_of_quantity(const std::string& lines) {
    const Scene scene = parse_scene(with_quantity(lines), "s.toml");
    return scene.analysis.quantities.back().unit;
}

}  // namespace

TEST_CASE("A series is compared with a column of its dimension, or a scaled one", "[dimensions]") {
    const std::string t = "x_scale = \"time\"\n", l = "y_scale = \"length\"\n";
    const auto [series, more, titles] = GENERATE_COPY(table<std::string, std::string, std::string>({
        {"front", "", "x [s],y [m]"},
        {"front", "", "x [ms],y [mm]"},
        {"front", t + l, "x [s],y [m]"},
        {"front", t + l, "x [-],y [-]"},
        {"front", l, "x [ms],y [-]"},
        {"front", "x_scale = \"moment\"\ny_scale = \"height\"\n", "x [-],y [-]"},
        {"front", "y_scale = \"pressure\"\n", "x [s],y [m]"},  // divides both alike
        {"gauge", "y_scale = \"pressure\"\n", "x [s],y [-]"},
        {"gauge", "", "x [s],y [kPa]"},
        {"density_error_max", "", "x [s],y [%]"},
        {"density_error_max", "", "x [min],y [-]"},
        {"energy_kinetic", "", "x [s],y [kJ/m]"},
        {"momentum_x", "", "x [s],y [kN s/m]"},
    }));
    INFO(series << " " << more << " " << titles);
    CHECK(refusal(compared(series, more), titles).empty());
}

TEST_CASE("A comparison of different dimensions is refused with both named", "[dimensions]") {
    const std::string t = "x_scale = \"time\"\n", l = "y_scale = \"length\"\n";
    const auto [series, more, titles, message] =
        GENERATE_COPY(table<std::string, std::string, std::string, std::string>({
            {"front", "", "x [s],y [Pa]", "series 'front' is in m, column 'y' in Pa, expected the same"},
            {"front", t + l, "x [s],y [kPa]", "series 'front' is in m, column 'y' in kPa"},
            {"front", "", "x [m],y [m]", "the abscissa of series 'front' is in s, column 'x' in m"},
            {"front", "", "x [Hz],y [m]", "the abscissa of series 'front' is in s, column 'x' in Hz"},
            {"front", "", "x [-],y [m]",
             "the abscissa of series 'front' is in s, column 'x' in - (scaled "
             "already), expected a 'x_scale' in s or a column in s"},
            {"front", t, "x [s],y [-]", "expected a 'y_scale' in m or a column in m"},
            {"front", t + "y_scale = \"pressure\"\n", "x [-],y [-]",
             "series 'front' is in m, scale 'pressure' in Pa, expected the same dimension"},
            {"front", "x_scale = \"height\"\n" + l, "x [-],y [-]",
             "the abscissa of series 'front' is in s, scale 'height' in m"},
            {"gauge", "", "x [s],y [N/m]", "series 'gauge' is in Pa, column 'y' in N/m"},
            {"gauge", l, "x [s],y [-]", "scale 'length' is taken in m here and in Pa before"},
            {"momentum_x", "", "x [s],y [N/m]", "series 'momentum_x' is in N s/m, column 'y' in N/m"},
            {"mass", "", "x [s],y [g]", "series 'mass' is in kg/m, column 'y' in g"},
            {"density_error_max", "", "x [s],y [kg/m^3]", "is in -, column 'y' in kg/m^3"},
        }));
    INFO(series << " " << more << " " << titles);
    const std::string also = series == "gauge" && more == l
                                 ? "\n[[compare]]\ntitle = \"b\"\nquantity = \"front\"\nreference = \"a\"\n"
                                   "x_column = \"x\"\ny_column = \"y\"\ntolerance = 0.1\n" +
                                       l
                                 : "";
    CHECK_THAT(refusal(compared(series, more) + also, titles),
               Contains(also.empty() ? message : "scale 'length'"));
}

TEST_CASE("The abscissa of a profile is a length", "[dimensions]") {
    const std::string scene =
        compared("surface", "instant = 0.1\n") +
        "\n[[probes]]\nname = \"surface\"\ntype = \"free_surface\"\nlow = 0.1\nhigh = 0.9\npoints = 5\n";
    CHECK(refusal(scene, "x [cm],y [mm]").empty());
    CHECK_THAT(refusal(scene, "x [s],y [m]"),
               Contains("the abscissa of series 'surface' is in m, column 'x' in s"));
}

TEST_CASE("The unit of a quantity follows from its metric, series and scales", "[dimensions]") {
    const std::string front = "series = \"front\"\n", gauge = "series = \"gauge\"\n";
    const std::string t = "x_scale = \"time\"\n", l = "y_scale = \"length\"\n";
    const auto [lines, unit] = GENERATE_COPY(table<std::string, std::string>({
        {front + "metric = \"maximum\"\n", "m"},
        {front + "metric = \"maximum\"\nunit = \"m\"\n", "m"},
        {front + "metric = \"maximum\"\n" + l, "-"},
        {front + "metric = \"maximum\"\nunit = \"-\"\n" + l, "-"},
        {front + "metric = \"slope\"\n", "m/s"},
        {front + "metric = \"slope\"\nunit = \"m/s\"\n", "m/s"},
        {front + "metric = \"slope\"\nunit = \"-\"\n" + t + l, "-"},
        {gauge + "metric = \"integral\"\n", "Pa s"},
        {gauge + "metric = \"integral\"\nunit = \"N s/m^2\"\n", "N s/m^2"},
        {gauge + "metric = \"time_of_maximum\"\n", "s"},
        {gauge + "metric = \"time_of_maximum\"\n" + l, "s"},
        {"series = \"momentum_x\"\nmetric = \"slope\"\n", "N/m"},
        {"series = \"density_error_max\"\nmetric = \"maximum\"\n", "-"},
    }));
    INFO(lines);
    CHECK(unit_of_quantity(lines) == unit);
}

TEST_CASE("A unit that a quantity does not have is refused with both named", "[dimensions]") {
    const std::string front = "series = \"front\"\n", gauge = "series = \"gauge\"\n";
    const std::string t = "x_scale = \"time\"\n", l = "y_scale = \"length\"\n";
    const auto [lines, message] = GENERATE_COPY(table<std::string, std::string>({
        {front + "metric = \"maximum\"\nunit = \"Pa\"\n",
         "is 'Pa', but the metric maximum of series 'front' gives m"},
        {front + "metric = \"maximum\"\nunit = \"mm\"\n",
         "is 'mm', but the metric maximum of series 'front' gives m"},
        {front + "metric = \"maximum\"\nunit = \"-\"\n",
         "is '-', but the metric maximum of series 'front' gives m"},
        {front + "metric = \"maximum\"\nunit = \"m\"\n" + l,
         "is 'm', but the metric maximum of series 'front' gives "
         "units of 0.2 m"},
        {front + "metric = \"slope\"\nunit = \"m\"\n", "gives m/s"},
        {front + "metric = \"slope\"\nunit = \"km/h\"\n", "gives m/s"},
        {gauge + "metric = \"time_of_maximum\"\nunit = \"Pa\"\n", "gives s"},
        {gauge + "metric = \"time_of_maximum\"\nunit = \"ms\"\n", "gives s"},
        {gauge + "metric = \"time_of_maximum\"\nunit = \"s\"\n" + t, "gives units of 0.1428 s"},
        {gauge + "metric = \"integral\"\nunit = \"Pa\"\n", "gives Pa s"},
        {gauge + "metric = \"mean\"\nunit = \"bar\"\n", "gives Pa"},
        {gauge + "metric = \"mean\"\nunit = \"pascals!\"\n", "unknown unit 'pascals!'"},
        {"series = \"mass\"\nmetric = \"change\"\nunit = \"kg\"\n", "gives kg/m"},
    }));
    INFO(lines);
    CHECK_THAT(samples::refusal(with_quantity(lines)),
               Contains("key 'quantities[1].unit': ") && Contains(message));
}

TEST_CASE("A scale of one unit gives numbers in that unit", "[dimensions]") {
    const std::string scene =
        samples::replaced(with_quantity("series = \"gauge\"\nmetric = \"mean\"\nunit = \"kPa\"\ny_scale = "
                                        "\"kilopascal\"\n"),
                          "length = 0.2\n", "length = 0.2\nkilopascal = 1000.0\n");
    CHECK(parse_scene(scene, "s.toml").analysis.quantities.back().unit == "kPa");
    CHECK(parse_scene(samples::replaced(scene, "= 1000.0\n", "= \"1 kPa\"\n"), "s.toml")
              .analysis.quantities.back()
              .unit == "kPa");
}

TEST_CASE("Scales and origins may be written with their units", "[dimensions]") {
    const auto scene = [](const std::string& scale, const std::string& origin) {
        return samples::replaced(compared("front", "x_scale = \"one\"\nx_origin = \"start\"\n"), "[scales]\n",
                                 "[time_origins]\nstart = " + origin + "\n[scales]\none = " + scale + "\n");
    };
    const auto [scale, origin, value, offset] = GENERATE(table<std::string, std::string, double, double>({
        {"0.5", "0.01", 0.5, 0.01},
        {"\"0.5 s\"", "\"10 ms\"", 0.5, 0.01},
        {"\"500 ms\"", "\"1e4 us\"", 0.5, 0.01},
        {"\"+0.5 s\"", "\"-10 ms\"", 0.5, -0.01},
        {"\"3 min\"", "\"0 s\"", 180, 0},
        {"\"0.5  s\"", "0", 0.5, 0},
    }));
    const ComparisonSpec c = parse_scene(scene(scale, origin), "s.toml").analysis.comparisons.back();
    CHECK(c.x_scale == Approx(value).epsilon(1e-14));
    CHECK(c.x_offset == Approx(offset).epsilon(1e-14));
    CHECK_THAT(samples::refusal(scene("0.5", "\"10 mm\"")),
               EndsWith(".x_origin': is in m, but the abscissa of series 'front' in s"));
    CHECK_THAT(samples::refusal(scene("\"half a second\"", "0")),
               EndsWith("expected a number, or a number and a unit as in \"0.6 m\""));
    CHECK_THAT(samples::refusal(scene("\"0.5s\"", "0")), Contains("is '0.5s', expected a number"));
    CHECK_THAT(samples::refusal(scene("\"0.5 parsnips\"", "0")), Contains("unknown unit 'parsnips'"));
    CHECK_THAT(samples::refusal(scene("\"-0.5 s\"", "0")), EndsWith("expected a positive number"));
}

TEST_CASE("The reference of a metric has the dimension of its series", "[dimensions]") {
    const std::string lines =
        "series = \"gauge\"\nmetric = \"rms_difference\"\nreference = \"a\"\ny_column = \"y\"\n";
    CHECK(refusal(with_quantity(lines), "x [s],y [kPa]").empty());
    CHECK_THAT(refusal(with_quantity(lines), "x [s],y [m]"),
               Contains("key 'quantities[1].reference': series 'gauge'"));
    CHECK_THAT(refusal(with_quantity(lines), "x [m],y [Pa]"),
               Contains("the abscissa of series 'gauge' is in s"));
}
