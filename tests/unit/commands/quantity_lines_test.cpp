// SPDX-License-Identifier: BSD-3-Clause
// How a run's quantities are printed when it ends: in units that suit their size, expected ones first.
#include "validation/commands/quantity_lines.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;
using Catch::EndsWith;

namespace {

QuantitySpec maximum_of(const std::string& series, const std::string& unit) {
    QuantitySpec spec;
    spec.name = series + "_peak";
    spec.metric = &metric_named("maximum");
    spec.series = series;
    spec.unit = unit;
    return spec;
}

Series constant(double value) {
    Series series;
    series.time = {0, 1};
    series.value = {value, value};
    return series;
}

/// The line of one quantity whose series is constant.
std::string line_of(double value, QuantitySpec spec) {
    RunRecord record;
    record.series["q"] = constant(value);
    ReferenceShelf shelf("none");
    AnalysisSpec all;
    all.quantities = {std::move(spec)};
    const std::vector<std::string> lines = quantity_lines(all, record, shelf);
    REQUIRE(lines.size() == 1);
    return lines[0];
}

}  // namespace

TEST_CASE("A quantity is printed in a unit that suits its size", "[commands]") {
    struct Row {
        double value;
        std::string unit, expected;
    };
    for (const Row& row : std::vector<Row>{{29400, "N/m", "29.4 kN/m"},
                                           {812.25, "N/m", "812.2 N/m"},
                                           {-40710, "Pa", "-40.71 kPa"},
                                           {999, "Pa", "999 Pa"},
                                           {0.0147, "s", "14.7 ms"},
                                           {2.5, "s", "2.5 s"},
                                           {0, "s", "0 s"},
                                           {124.5, "m/s^2", "124.5 m/s^2"},
                                           {-5.174, "m/s", "-5.174 m/s"},
                                           {2.40, "-", "2.4"}}) {
        CAPTURE(row.expected);
        CHECK(line_of(row.value, maximum_of("q", row.unit)) == "  q_peak  " + row.expected);
    }
}

TEST_CASE("An expected value, its tolerance and the verdict stand behind the value", "[commands]") {
    QuantitySpec spec = maximum_of("q", "N/m");
    spec.expected = 26500;
    spec.tolerance = 2650;
    CHECK_THAT(line_of(29400, spec), EndsWith("29.4 kN/m, expected 26.5 kN/m within 2.65: outside"));
    CHECK_THAT(line_of(27000, spec), EndsWith("27 kN/m, expected 26.5 kN/m within 2.65: within"));
    CHECK_THAT(line_of(1, maximum_of("other", "Pa")), EndsWith("the run has no series 'other'"));
}

TEST_CASE("Expected quantities come first, and at most eight are printed", "[commands]") {
    AnalysisSpec all;
    for (int k = 0; k < 11; ++k) {
        all.quantities.push_back(maximum_of("q", "m"));
        all.quantities.back().name = "q" + std::to_string(k);
    }
    all.quantities[9].expected = 1;
    all.quantities[9].tolerance = 0.1;
    RunRecord record;
    record.series["q"] = constant(1);
    ReferenceShelf shelf("none");
    const std::vector<std::string> lines = quantity_lines(all, record, shelf);
    REQUIRE(lines.size() == 9);
    CHECK(lines[0] == "  q9   1 m, expected 1 m within 0.1: within");
    CHECK(lines[1] == "  q0   1 m");
    CHECK(lines[8] == "  and 3 more in the report");
    CHECK(quantity_lines(AnalysisSpec{}, record, shelf).empty());
}
