// SPDX-License-Identifier: BSD-3-Clause
// The loader of reference files: what it reads and each thing it refuses.
#include "validation/metrics/reference.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "solver/core/errors.hpp"

using namespace wetdeck;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

const std::string header =
    "# kind: experiment\n# citation: Someone (2000)\n# doi: none\n# figure: 1\n# obtained: digitised\n"
    "# obtained_from: here\n# date: 2026-01-31\n# digitisation_error: 0.01\n# u_data: 0.05\n# u_data_source: "
    "text\n"
    "# sensor: gauge\n# filter: none\n# sign: up\n# time_origin: release\n# note: none\n";
const std::string columns = "T [-],p [Pa]\n";

/// A file that lives as long as the object.
class File {
  public:
    explicit File(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
    ~File() { std::filesystem::remove(path); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("wetdeck_reference_" + std::to_string(getpid()) + ".csv");
};

Reference load(const std::string& text) {
    return load_reference(File(text).path);
}

/// The message without the path in front of it; the path is checked.
std::string refusal(const std::string& text) {
    const File file(text);
    try {
        static_cast<void>(load_reference(file.path));
    } catch (const DataError& error) {
        const std::string message = error.what();
        REQUIRE(message.rfind(file.path.string() + ":", 0) == 0);
        return message.substr(file.path.string().size() + 1);
    }
    return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("A sound reference file is read with its header, columns and units", "[reference]") {
    const Reference reference = load(header + "# licence: free\n" + columns + "0,1\n0.5,-2e3\n");
    CHECK(reference.kind == ReferenceKind::experiment);
    CHECK(reference.citation == "Someone (2000)");
    CHECK(reference.u_data == StandardUncertainty{0.05});
    CHECK(reference.keys.at("licence") == "free");
    REQUIRE(reference.columns.size() == 2);
    CHECK(reference.columns[1].name == "p");
    CHECK(reference.columns[1].unit == "Pa");
    CHECK(reference.columns[1].values == std::vector<double>{1, -2000});
}

TEST_CASE("An unknown uncertainty is empty and not zero", "[reference]") {
    CHECK_FALSE(
        load(replaced(header, "u_data: 0.05", "u_data: unknown") + columns + "0,1\n").u_data.has_value());
    CHECK(load(replaced(header, "u_data: 0.05", "u_data: unknown\n# u_data_assumed: 0.1") + columns + "0,1\n")
              .u_data_assumed == StandardUncertainty{0.1});
    CHECK(load(replaced(header, "u_data: 0.05", "u_data: 0") + columns + "0,1\n").u_data ==
          StandardUncertainty{});
}

TEST_CASE("Files of spreadsheets with a byte order mark and carriage returns are read", "[reference]") {
    std::string text = "\xEF\xBB\xBF" + header + columns + "0,1\n1,2\n";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
    const Reference reference = load(text);
    CHECK(reference.kind == ReferenceKind::experiment);
    CHECK(reference.columns[1].values == std::vector<double>{1, 2});
}

TEST_CASE("The hash of a reference tells files apart", "[reference]") {
    const std::string first = load(header + columns + "0,1\n").hash;
    CHECK(first == load(header + columns + "0,1\n").hash);
    CHECK(first != load(header + columns + "0,2\n").hash);
    CHECK(first.size() == std::string("fnv1a64:").size() + 16);
}

TEST_CASE("Rows with an empty cell are counted and left out of the curve of that column", "[reference]") {
    const Reference reference = load(header + "T [-],a [-],b [-]\n0,1,5\n1,,6\n2,3,7\n");
    CHECK(reference.columns[1].empty_cells == 1);
    CHECK(reference.columns[2].empty_cells == 0);
    const Curve a = column_curve(reference, "T", "a");
    CHECK(a.x == std::vector<double>{0, 2});
    CHECK(a.y == std::vector<double>{1, 3});
    CHECK(column_curve(reference, "T", "b").x.size() == 3);
}

TEST_CASE("A column that the reference lacks is refused with the names there are", "[reference]") {
    const Reference reference = load(header + columns + "0,1\n");
    CHECK_THROWS_WITH(column_curve(reference, "T", "q"), EndsWith("no column 'q', there are T, p"));
    CHECK_THROWS_AS(column_curve(reference, "t", "p"), DataError);
}

TEST_CASE("A column that goes backwards cannot be an abscissa", "[reference]") {
    const Reference reference = load(header + columns + "0,1\n1,0\n");
    CHECK_THROWS_WITH(column_curve(reference, "p", "T"), Contains("'p' is not strictly increasing"));
}

TEST_CASE("A column without any value has no curve", "[reference]") {
    CHECK_THROWS_WITH(column_curve(load(header + columns + "0,\n1,\n"), "T", "p"),
                      EndsWith("column 'p' has no values"));
}

TEST_CASE("Every required key has to be there", "[reference]") {
    const std::string key = GENERATE("kind", "citation", "u_data", "sign", "time_origin");
    const std::string text = replaced(header, "# " + key + ":", "# other:") + columns + "0,1\n";
    CHECK(refusal(text) == "16: missing key '" + key + "', expected '# " + key + ": ...'");
}

TEST_CASE("Other keys are recommended, and named where they are missing", "[reference]") {
    CHECK(missing_recommended_keys(load(header + columns + "0,1\n")).empty());
    const std::string key = GENERATE("doi", "figure", "obtained", "obtained_from", "date",
                                     "digitisation_error", "u_data_source", "sensor", "filter", "note");
    const Reference reference = load(replaced(header, "# " + key + ":", "# other:") + columns + "0,1\n");
    CHECK(missing_recommended_keys(reference) == std::vector<std::string>{key});
}

TEST_CASE("An uncertainty is relative, in per cent, or in the unit of a column of values", "[reference]") {
    const std::string two = "t [ms],v [km/h],p [kPa]\n";
    const auto [given, value, unit] = GENERATE(table<std::string, double, std::string>({
        {"0.03", 0.03, ""},
        {"3 %", 0.03, ""},
        {"0", 0, ""},
        {"0 %", 0, ""},
        {"1", 1, ""},
        {"2.5   %", 0.025, ""},
        {"0.03 m/s", 0.03, "m/s"},
        {"36 km/h", 10, "m/s"},
        {"3 cm/s", 0.03, "m/s"},
        {"2 kPa", 2000, "Pa"},
        {"20 mbar", 2000, "Pa"},
    }));
    const Reference read =
        load(replaced(header, "u_data: 0.05", "u_data: " + given) + two + "0,1,2\n1,2,3\n");
    REQUIRE(read.u_data.has_value());
    CHECK(read.u_data->value == Approx(value));
    CHECK(read.u_data->unit == unit);
    CHECK(read.u_data->of(-200) == Approx(unit.empty() ? 200 * value : value));
}

TEST_CASE("A faulty header is refused with line and expectation", "[reference]") {
    const auto [from, to, message] = GENERATE(table<std::string, std::string, std::string>({
        {"kind: experiment", "kind: guess",
         "1: kind is 'guess', expected experiment, peer-simulation, analytic, stated"},
        {"obtained: digitised", "obtained: dreamt",
         "5: obtained is 'dreamt', expected tabulated, digitised, computed, stated"},
        {"date: 2026-01-31", "date: yesterday", "7: date is 'yesterday', expected YYYY-MM-DD"},
        {"u_data: 0.05", "u_data: small",
         "9: u_data is 'small', expected a relative uncertainty such as 0.03 or 3 %, or one with the unit of "
         "a column or unknown"},
        {"u_data: 0.05", "u_data: -1",
         "9: u_data is negative, expected a relative uncertainty such as 0.03 or 3 %, or one with the unit "
         "of "
         "a column or unknown"},
        {"u_data: 0.05", "u_data: unknown\n# u_data_assumed: -1",
         "10: u_data_assumed is negative, expected a relative uncertainty such as 0.03 or 3 %, or one with "
         "the "
         "unit of a column"},
        {"u_data: 0.05", "u_data: nan",
         "9: u_data is 'nan', expected a relative uncertainty such as 0.03 or 3 %, or one with the unit of "
         "a column or unknown"},
        {"u_data: 0.05", "u_data: 3",
         "9: u_data is 300 %, expected a relative uncertainty such as 0.03 or 3 %, or one with the unit of "
         "a column or unknown"},
        {"u_data: 0.05", "u_data: 0.1 s", "17: u_data is in s, the unit of no column of values"},
        {"sign: up", "sign:", "13: key 'sign' has no value"},
        {"sign: up", "figure: 2", "13: key 'figure' is given twice"},
        {"# sign: up", "# upwards", "16: missing key 'sign', expected '# sign: ...'"},
        {"Someone", "Some\xFFone", "2: not UTF-8 text"},
    }));
    CHECK(refusal(replaced(header, from, to) + columns + "0,1\n") == message);
}

TEST_CASE("Faulty column names are refused", "[reference]") {
    const auto [names, message] = GENERATE(table<std::string, std::string>({
        {"T,p [Pa]", "16: column 'T' has no unit, expected 'name [unit]'"},
        {"T [-],p [Pa", "16: column 'p [Pa' has no unit, expected 'name [unit]'"},
        {"T [-],,p [Pa]", "16: column '' has no unit, expected 'name [unit]'"},
        {"T [-],[Pa]", "16: column '[Pa]' has no name, expected 'name [unit]'"},
        {"T [-],T [-]", "16: column 'T' is given twice"},
        {"T [-],p\xFF [-]", "16: not UTF-8 text"},
    }));
    CHECK(refusal(header + names + "\n0,1\n") == message);
    CHECK_THAT(refusal(header + "T [-],p [bars of soap]\n0,1\n"),
               Catch::StartsWith("16: column 'p' has the unknown unit 'bars of soap', expected -, or a unit "
                                 "such as m, mm, s, ms, Pa"));
}

TEST_CASE("Faulty rows are refused", "[reference]") {
    const auto [rows, message] = GENERATE(table<std::string, std::string>({
        {"0,1\n0,2\n", "18: T is 0 after 0, expected a strictly increasing abscissa"},
        {"1,1\n0.5,2\n", "18: T is 0.5 after 1, expected a strictly increasing abscissa"},
        {"0,nan\n", "17: p is 'nan', expected a finite number"},
        {"0,-1e+300\n",
         "17: p is '-1e+300', which stands for no value in some programs; leave the cell empty"},
        {"0,0.8\n1,-9999\n2,0.7\n",
         "18: p is '-9999', far from all other values: if it stands for no value, leave the cell empty"},
        {"0,0.8\n1,999.99\n2,999.99\n",
         "18: p is '999.99', far from all other values: if it stands for no value, leave the cell empty"},
        {"0,1\n\ninf,1\n", "19: T is 'inf', expected a finite number"},
        {"0,one\n", "17: p is 'one', expected a number"},
        {"0,1.5x\n", "17: p is '1.5x', expected a number"},
        {"0,1e999\n", "17: p is '1e999', expected a number"},
        {"0,1,2\n", "17: 3 cells, expected 2"},
        {"0\n", "17: 1 cell, expected 2 between ',', as in the column names"},
        {"0;1\n", "17: 1 cell, expected 2 between ',', as in the column names"},
        {",1\n", "17: the abscissa 'T' is empty"},
        {"", "16: no rows after the column names"},
        {"\n\n", "18: no rows after the column names"},
    }));
    CHECK(refusal(header + columns + rows) == message);
}

TEST_CASE("A file that ends before its column names is refused", "[reference]") {
    CHECK(refusal(header) == "15: no column names, expected a line such as 'T [-],p_star [-]'");
    CHECK_THAT(refusal(""), Catch::StartsWith("0: missing keys 'kind', 'citation', 'u_data', ") &&
                                EndsWith("'time_origin', expected '# kind: ...'"));
}

TEST_CASE("What is no readable file is refused", "[reference]") {
    CHECK_THROWS_WITH(load_reference("/nowhere/at/all.csv"), "/nowhere/at/all.csv: no such file");
    CHECK_THROWS_WITH(load_reference(std::filesystem::temp_directory_path()),
                      EndsWith("not a regular file, expected a reference CSV"));
    CHECK_THROWS_WITH(load_reference("/dev/zero"), "/dev/zero: not a regular file, expected a reference CSV");
}

TEST_CASE("A file of more than 20 MB is refused unread", "[reference]") {
    const File file(header);
    std::filesystem::resize_file(file.path, 20'000'001);
    CHECK_THROWS_WITH(load_reference(file.path),
                      EndsWith("20000001 bytes, a reference file may have 20000000"));
}
