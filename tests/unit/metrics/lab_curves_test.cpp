// SPDX-License-Identifier: BSD-3-Clause
// Reference curves as measuring computers and spreadsheets write them: what is read, to the same numbers, and
// what is refused with its reason.
#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "validation/metrics/reference.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

const std::string head =
    "# kind: experiment\n# citation: Someone (2000)\n# doi: none\n# figure: 1\n# obtained: tabulated\n"
    "# obtained_from: here\n# date: 2026-01-31\n# digitisation_error: none\n# u_data: 0.05\n"
    "# u_data_source: text\n# sensor: gauge\n# filter: none\n# sign: up\n# time_origin: release\n# note: "
    "none\n";

std::string with_line_ends(std::string text, const std::string& end) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
        text.replace(at, 1, end);
    return text;
}

std::string replaced_all(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(parse_reference("a.csv", text));
    } catch (const DataError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("A curve is the same whatever wrote it", "[reference][lab]") {
    const std::string text = GENERATE_COPY(values<std::string>({
        head + "t [s],vy [m/s]\n0,-2.93\n0.004,2.5\n",
        head + "t [s];vy [m/s]\n0;-2.93\n0.004;2.5\n",
        head + "t [s]\tvy [m/s]\n0\t-2.93\n0.004\t2.5\n",
        "\xEF\xBB\xBF" + with_line_ends(head + "t [s];vy [m/s]\n0;-2.93\n0.004;2.5\n", "\r\n"),
        with_line_ends(head + "t [s],vy [m/s]\n0,-2.93\n0.004,2.5\n", "\r\r\n"),
        head + "t [s],vy [m/s],\n0,-2.93,\n0.004,2.5,\n",
        head + "t [s],vy [m/s],,,\n0,-2.93,,,\n0.004,2.5,,,\n,,,,\n",
        head + "t [s]\tvy [m/s]\t\n0\t-2.93\t\n0.004\t2.5\t\n",
        head + "t [s],vy [m/s]\n+0,-2.93\n+4e-3,+2.5\n",
        head + "t [s],vy [m/s]\n0,-2.93 # first\n# sensor saturated\n\n0.004,2.5# last\n  # end\n",
        head + "# a comment without a key\n#\nt [s],vy [m/s] # names\n0,-2.93\n0.004,2.5\n",
        head + "\"t [s]\",\"vy [m/s]\"\n\"0\",\"-2.93\"\n0.004,2.5\n",
        with_line_ends(head, ",,\n") + "t [s],vy [m/s],,\n0,-2.93,,\n0.004,2.5,,\n",
        head + "t [ms],vy [m/s]\n0,-2.93\n4,2.5\n",
        head + "t [us];vy [cm/s]\n0;-293\n4000;250\n",
        head + "t [s],vy [km/h]\n0,-10.548\n0.004,9\n",
    }));
    INFO(text.substr(text.size() > 80 ? text.size() - 80 : 0));
    const Reference read = parse_reference("a.csv", text);
    REQUIRE(read.columns.size() == 2);
    CHECK(read.keys.at("citation") == "Someone (2000)");
    CHECK(read.columns[0].unit == "s");
    CHECK(read.columns[1].unit == "m/s");
    REQUIRE(read.columns[1].values.size() == 2);
    CHECK(read.columns[0].values[1] == Approx(0.004).epsilon(1e-14));
    CHECK(read.columns[1].values[0] == Approx(-2.93).epsilon(1e-14));
    CHECK(read.columns[1].values[1] == Approx(2.5).epsilon(1e-14));
}

TEST_CASE("A curve that could be read in two ways, or in none, is refused in one line", "[reference][lab]") {
    const std::string utf16 = [] {
        std::string wide = "\xFF\xFE";
        for (const char c : head) wide += {c, '\0'};
        return wide;
    }();
    const std::string names = head + "t [s];vy [m/s]\n";
    const auto [text, message] = GENERATE_COPY(table<std::string, std::string>({
        {names + "0,000;-2,93\n", "a.csv:17: t is '0,000', expected a number; decimal commas are not read"},
        {head + "t [s]\tvy [m/s]\n0,5\t-2,93\n", "a.csv:17: t is '0,5', expected a number; decimal commas"},
        {head + "t [s],vy [m/s]\n0,000,-2,93\n", "a.csv:17: 4 cells, expected 2, or decimal commas"},
        {head + "t [s],vy [m/s]\n\"0,000\",\"-2,93\"\n",
         "a.csv:17: t is '0,000', expected a number; decimal"},
        {names + "0,1\n", "a.csv:17: 1 cell, expected 2 between ';', as in the column names"},
        {head + "t [s]\tvy [m/s]\n0 1\n", "a.csv:17: 1 cell, expected 2 between tabs"},
        {utf16, "a.csv:1: UTF-16 text, expected UTF-8"},
        {replaced_all(names + "0;1\n", "0", std::string("0\0", 2)), "a.csv:1: holds NUL bytes"},
        {with_line_ends(names + "0;1\n", "\r"), "a.csv:1: the line ends with a lone carriage return"},
        {names + "0;1\n1;2\r2;3\n", "a.csv:18: the line ends with a lone carriage return"},
        {names + "0;NaN\n", "a.csv:17: vy is 'NaN', expected a finite number"},
        {names + "0;\xE2\x88\x92"
                 "2.93\n",
         "a.csv:17: vy is '\xE2\x88\x92"
         "2.93', expected a number; its minus sign is that of typesetting"},
        {names + "0;+-1\n", "a.csv:17: vy is '+-1', expected a number"},
        {names + "0;1\n0;2\n", "a.csv:18: t is 0 after 0, expected a strictly increasing abscissa"},
        {head + "t (s),vy (m/s)\n0,1\n", "a.csv:16: column 't (s)' has no unit, expected 'name [unit]'"},
        {head + "0,1\n1,2\n", "a.csv:16: column '0' has no unit"},
        {head + "t [s],vy [degC]\n0,1\n", "a.csv:16: column 'vy' has the unknown unit 'degC'"},
    }));
    const std::string said = refusal(text);
    CHECK_THAT(said, Catch::StartsWith(message));
    CHECK(said.find('\n') == std::string::npos);
}

TEST_CASE("g in a column of accelerations is standard gravity, deg an angle", "[reference][lab][units]") {
    const Reference read = parse_reference("a.csv", head + "t [s],a [g],phi [deg],p [kPa]\n0,-2,180,1.5\n");
    CHECK(read.columns[1].unit == "m/s^2");
    CHECK(read.columns[1].given_unit == "g");
    CHECK(read.columns[1].values[0] == Approx(-19.6133).epsilon(1e-14));
    CHECK(read.columns[2].values[0] == Approx(3.141592653589793).epsilon(1e-14));
    CHECK(read.columns[3].unit == "Pa");
    CHECK(read.columns[3].values[0] == 1500);
}

TEST_CASE("A number with a separator in its name keeps its column", "[reference][lab]") {
    const Reference read = parse_reference("a.csv", head + "t [s];p, filtered [Pa];q#2 [-]\n0;1;2\n");
    REQUIRE(read.columns.size() == 3);
    CHECK(read.columns[1].name == "p, filtered");
    CHECK(read.columns[2].name == "q#2");
    CHECK(read.columns[2].values[0] == 2);
}

TEST_CASE("A file is told to be a curve by its header or by its columns", "[reference][lab]") {
    const std::string curve = GENERATE_COPY(values<std::string>(
        {head, "# kind: guess\n0,0\n", "\xEF\xBB\xBF# kind: experiment\r\n", "\n\n#kind:x\n", "# u_data: 0\n",
         "t [s],vy [m/s]\n0,1\n", "t [s];p [Pa]\n", "t [s]\tp [Pa]\tq [Pa]\n", "x [m],y [m],z [m]\n",
         "\"# kind: experiment\",,\n"}));
    INFO(curve);
    CHECK(looks_like_reference(curve));
    const std::string corners = GENERATE_COPY(values<std::string>(
        {"0,0\n1,0\n", "x,y\n0,0\n", "x [m],y [m]\n0,0\n", "x [mm];y [mm]\n", "# note: hull 7\n0 0\n",
         "# half section, from keel to deck\n0,0\n", "", "half breadth,height\n[m],[m]\n0,0\n", "#\n0\t0\n",
         "\xEF\xBB\xBF"
         "0,0\n"}));
    INFO(corners);
    CHECK_FALSE(looks_like_reference(corners));
}
