// SPDX-License-Identifier: BSD-3-Clause
// Curves that cannot be compared: `check`, `run` and `suite` stop before they compute, a report leaves out
// the one comparison. Files that are outlines or curves, as `check` takes them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/faults/program_support.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::Outcome;
using samples::put_scene;
using samples::run_program;
using samples::ScratchFolder;

namespace {

const std::string head =
    "# kind: experiment\n# citation: Someone (2000)\n# doi: none\n# figure: 1\n# obtained: tabulated\n"
    "# obtained_from: here\n# date: 2026-01-31\n# digitisation_error: none\n# u_data: 0.05\n"
    "# u_data_source: text\n# sensor: gauge\n# filter: none\n# sign: up\n# time_origin: release\n# note: "
    "none\n";
const std::string good = head + "T [-],x [-]\n0,2\n0.5,2.1\n1,2.2\n";

/// A curve that the comparison of the small scene cannot use, and a piece of the line that says so.
struct BadCurve {
    std::string text, message;
};

std::vector<BadCurve> bad_curves() {
    return {
        {head + "T [-],x [-]\n0,2\n0,2.1\n", "nobody_front.csv:18: T is 0 after 0"},
        {head + "T [-],x [-]\n0,nan\n", "nobody_front.csv:17: x is 'nan'"},
        {head + "T [-],x [-]\n0,two\n", "nobody_front.csv:17: x is 'two'"},
        {head + "T [-],x [-]\n", "nobody_front.csv:16: no rows"},
        {head + "T [-],y [-]\n0,2\n1,2.2\n", "nobody_front.csv: no column 'x'"},
        {head + "t [s],x [-]\n0,2\n1,2.2\n", "nobody_front.csv: no column 'T'"},
        {head + "T [-];x [-]\n0,0;2,1\n",
         "nobody_front.csv:17: T is '0,0', expected a number; decimal commas"},
        {head + "T [-],x [Pa]\n0,2\n1,2.2\n", "series 'front' is in m, column 'x' in Pa"},
        {head + "T [m],x [-]\n0,2\n1,2.2\n", "the abscissa of series 'front' is in s, column 'T' in m"},
        {head + "T [-],x [vy]\n0,2\n1,2.2\n", "nobody_front.csv:16: column 'x' has the unknown unit 'vy'"},
        {"T [-],x [-]\n0,2\n", "nobody_front.csv:1: missing keys 'kind'"},
        {"", "nobody_front.csv:0: missing keys 'kind'"}};
}

}  // namespace

TEST_CASE("run and suite look at the curves before they compute", "[faults][curves]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder), out = folder / "out";
    for (const BadCurve& bad : bad_curves()) {
        samples::put_bytes(folder / "nobody_front.csv", bad.text);
        for (const std::vector<std::string>& arguments :
             {std::vector<std::string>{"check", scene},
              {"run", scene, "--dx", "0.04", "--out", out},
              {"suite", "--only", scene, "--out", out},
              {"suite", "--only", scene, "--row", "0", "--out", out}}) {
            const Outcome outcome = run_program(arguments);
            INFO(arguments[0] << ": " << outcome.err);
            CHECK(outcome.code == 2);
            CHECK(outcome.one_line());
            CHECK_THAT(outcome.err, Contains(bad.message));
        }
        CHECK_FALSE(std::filesystem::exists(out));
    }
}

TEST_CASE("a report leaves out the one comparison with a bad curve", "[faults][curves]") {
    const ScratchFolder folder;
    const std::string second =
        "\n[[compare]]\ntitle = \"second\"\nquantity = \"front\"\nreference = \"second\"\nx_column = \"T\"\n"
        "y_column = \"x\"\nx_scale = \"time\"\ny_scale = \"length\"\nwindow = [0.0, 1.0]\ntolerance = 0.9\n";
    const std::string scene = put_scene(folder, samples::small_scene + second), out = folder / "out";
    samples::put_bytes(folder / "nobody_front.csv", good);
    samples::put_bytes(folder / "second.csv", good);
    REQUIRE(run_program({"run", scene, "--dx", "0.04", "--variant", "single-phase", "--quiet", "--out", out})
                .code == 0);
    for (const BadCurve& bad : bad_curves()) {
        samples::put_bytes(folder / "nobody_front.csv", bad.text);
        std::filesystem::remove(folder / "out/index.html");
        const Outcome outcome = run_program({"report", out});
        INFO(outcome.err);
        CHECK(outcome.code < 2);
        CHECK_THAT(outcome.err, Contains("note: comparison 'front' is left out: ") && Contains(bad.message));
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
        CHECK_THAT(samples::report_in(folder / "out"), Contains("curve not available: "));
        const auto summary = nlohmann::json::parse(samples::bytes_of(folder / "out/summary.json"));
        const auto& comparisons = summary.at("runs")[0].at("comparisons");
        REQUIRE(comparisons.size() == 2);
        CHECK(comparisons[0].at("within").is_null());
        CHECK_THAT(comparisons[0].at("note").get<std::string>(), Contains(bad.message));
        CHECK(comparisons[1].at("within").is_boolean());
        CHECK(comparisons[1].at("metric").at("nrmse").is_number());
    }
}

TEST_CASE("check tells outlines from curves and checks each as such", "[faults][curves]") {
    const ScratchFolder folder;
    const auto [name, text, code, message] = GENERATE(table<const char*, std::string, int, const char*>({
        {"a.csv", "0,0\n1,0.5\n1,1\n", 0, "outline of 3 corners, x from 0 to 1 m, y from 0 to 1 m, fit for"},
        {"a.csv",
         "\xEF\xBB\xBF"
         "0;0\r\n1;0.5\r\n1;1\r\n",
         0, "outline of 3 corners"},
        {"a.txt", "0\t0\n1\t0.5\n1\t1\n", 0, "outline of 3 corners"},
        {"A.CSV", "x [mm],y [mm]\n0,0\n1000,500\n1000,1000\n", 0, "outline of 3 corners, x from 0 to 1 m"},
        {"a.csv", "0.3,0\n0.4,0.1\n0.3,0.2\n", 0, "not fit for 'mirrored = true'"},
        {"a.csv", "-1,0\n1,0\n0,1\n", 0, "not fit for 'mirrored = true'"},
        {"a.csv", "0,0\n1,1\n1,0\n0,1\n", 2, "a.csv: the outline is no simple polygon"},
        {"a.csv", "0,0\n1,0\n2,0\n", 2, "a.csv: the outline is no simple polygon"},
        {"a.csv", "0,0;0,0\n1,0;0,5\n", 2, "a.csv:1: expected two numbers, x and y [m]; decimal commas"},
        {"a.csv", "t [s],vy [m/s]\n0,1\n1,2\n", 2, "a.csv:1: missing keys 'kind'"},
        {"a.csv", "# kind: experiment\nt [s],vy [m/s]\n0,1\n", 2, "a.csv:2: missing keys 'citation'"},
        {"a.csv", good, 0, "experiment reference, 2 columns"},
        {"a.tsv", good, 0, "experiment reference, 2 columns"},
    }));
    const std::string file = folder / name;
    samples::put_bytes(file, text);
    const Outcome outcome = run_program({"check", file});
    INFO(text);
    CHECK(outcome.code == code);
    CHECK_THAT(code == 0 ? outcome.out : outcome.err, Contains(message));
    if (code != 0) CHECK(outcome.one_line());
}

TEST_CASE("a curve of one point or beside the window is refused before a run", "[faults][curves]") {
    const ScratchFolder folder;
    const std::string scene = put_scene(folder), out = folder / "out";
    for (const BadCurve& bad :
         {BadCurve{"0.5,2.1\n", "nobody_front.csv has one point, expected at least two"},
          BadCurve{"0.5,2.1\n0.6,\n", "has one point"},
          BadCurve{"1.5,2.1\n2,2.2\n", "window 0 to 1 lies outside curve x of"},
          BadCurve{"-2,2.1\n0,2.2\n", "spans -2 to 0"}}) {
        samples::put_bytes(folder / "nobody_front.csv", head + "T [-],x [-]\n" + bad.text);
        for (const std::vector<std::string>& arguments :
             {std::vector<std::string>{"check", scene}, {"run", scene, "--dx", "0.04", "--out", out}}) {
            const Outcome outcome = run_program(arguments);
            INFO(arguments[0] << ": " << outcome.err);
            CHECK(outcome.code == 2);
            CHECK_THAT(outcome.err, Contains(bad.message));
            CHECK_FALSE(std::filesystem::exists(out));
        }
    }
}
