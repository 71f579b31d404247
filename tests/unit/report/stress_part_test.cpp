// SPDX-License-Identifier: BSD-3-Clause
// Hard cases: which scheme a row belongs to.
#include <catch2/catch.hpp>

#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;
using samples::between;
using samples::contains;
using samples::page_of;

namespace {

/// Two cases with the default scheme and two others, whatever their names; one setting has a comma of its
/// own.
Summary hard_cases() {
    Summary summary;
    summary.stress = {{"plate", "flat, 3 spacings", true, ""},
                      {"plate", "flat, 3 spacings, fancy", false, "left the tank"},
                      {"plate", "flat, 3 spacings, bare", false, ""},
                      {"wedge", "10 m/s", true, ""},
                      {"wedge", "10 m/s, fancy", true, ""},
                      {"wedge", "20 m/s", false, "density error"},
                      {"wedge", "limit of entry: speed [m/s]", true, "margin 3"}};
    return summary;
}

}  // namespace

TEST_CASE("Hard cases are counted by the schemes that the rows name", "[report]") {
    const std::string counts = between(page_of(hard_cases()), "<h1>Hard cases</h1>", "</table>");
    const auto row = [](const char* scheme, int settings, int stable) {
        return "<tr><td>" + std::string(scheme) + "</td><td class=\"number\">" + std::to_string(settings) +
               "</td><td class=\"number\">" + std::to_string(stable) + "</td></tr>";
    };
    CHECK(contains(counts, row("default", 3, 2)));
    CHECK(contains(counts, row("fancy", 2, 1)));
    CHECK(contains(counts, row("bare", 1, 0)));
    CHECK(samples::occurrences(counts, "<tr><td>") == 3);  // a comma in a setting makes no scheme
}

TEST_CASE("Unstable settings of the default scheme come first, other schemes and limits apart", "[report]") {
    const std::string page = page_of(hard_cases());
    const std::string unstable = between(page, "the default scheme became unstable</h4>", "</table>");
    CHECK(contains(unstable, "20 m/s"));
    CHECK(samples::occurrences(unstable, "became unstable</span>") == 1);
    CHECK(contains(between(page, "stability limits</h4>", "</table>"), "margin 3"));
    const std::string others = between(page, "<summary>Other schemes</summary>", "</table>");
    CHECK(contains(others, "flat, 3 spacings, fancy"));
    CHECK_FALSE(contains(others, "<td>20 m/s</td>"));
}

TEST_CASE("A default scheme that was stable everywhere is said to be", "[report]") {
    Summary summary;
    summary.stress = {{"wedge", "10 m/s", true, ""}};
    CHECK(contains(page_of(summary), "The default scheme was stable in every setting."));
}
