// SPDX-License-Identifier: BSD-3-Clause
// The table of metrics is complete, and a metric is a row and a function.
#include "validation/metrics/metric.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "validation/metrics/quantities.hpp"
#include "validation/metrics/resample.hpp"
#include "validation/store/whole_file.hpp"

using namespace wetdeck;

namespace {

/// A triangle of height 2 about x = 2 that falls below zero, from 0 to 5.
const Curve triangle{{0, 1, 2, 3, 4, 5}, {0, 1, 2, 1, 0, -1}};

MetricResult evaluated(const Metric& metric, double threshold) {
    const Curve shifted{triangle.x, {0.5, 1.5, 2.5, 1.5, 0.5, -0.5}};
    return metric.evaluate({triangle, triangle, extent(triangle), threshold, shifted});
}

QuantityResult quantity(const Metric& metric, const RunRecord& record) {
    QuantitySpec spec;
    spec.name = "q";
    spec.series = "p";
    spec.metric = &metric;
    ReferenceShelf none("none");
    return evaluate_quantity(spec, record, none);
}

}  // namespace

TEST_CASE("Names of metrics are unique and each row is complete", "[metric]") {
    std::set<std::string> names;
    for (const Metric& metric : metrics()) {
        INFO(metric.name);
        CHECK(names.insert(metric.name).second);
        CHECK(std::string(metric.meaning).size() > 10);
        CHECK(metric.evaluate != nullptr);
        CHECK(&metric_named(metric.name) == &metric);
    }
    CHECK(metric_names().size() == names.size());
}

TEST_CASE("Each metric gives its number of a triangle", "[metric]") {
    const std::map<std::string, double> expected{
        {"mean", 0.7},
        {"standard_deviation", 0.9},
        {"maximum", 2},
        {"time_of_maximum", 2},
        {"minimum", -1},
        {"slope", -4.5 / 17.5},
        {"proportion", 3.0 / 55},
        {"first_crossing", 0.5},
        {"value_at", 0.5},
        {"rms_difference", 0.5},
        {"largest_difference", 0.5},
        {"integral", 3.5},
        {"change", -1},
        {"first_peak_integral", 3.5},  // until x = 3, where half of the peak is left
    };
    for (const Metric& metric : metrics()) {
        INFO(metric.name);
        REQUIRE(expected.contains(metric.name));
        CHECK(evaluated(metric, 0.5).value.value() == Approx(expected.at(metric.name)));
    }
}

TEST_CASE("The largest difference is taken at the points of the reference in the window", "[metric]") {
    const Metric& metric = metric_named("largest_difference");
    const auto largest = [&](const Curve& reference, const Window& window) {
        return metric.evaluate({triangle, clip(triangle, window), window, 0, reference});
    };
    struct Row {
        Curve reference;
        Window window;
        double expected;
    };
    const std::vector<Row> rows = {{{{1, 3}, {1, 1}}, {0, 5}, 0},  // not at 2, where no point is
                                   {{{1, 2, 3}, {1, 1, 1}}, {0, 5}, 1},
                                   {{{1, 2, 3}, {1, 1, 1}}, {0, 1.5}, 0},
                                   {{{1, 2, 3}, {1, 3, 1}}, {0, 5}, 1},
                                   {{{0.5, 1.5}, {0.5, 1.25}}, {0, 5}, 0.25},
                                   {{{1, 2, 3}, {1.1, 2.2, 0.7}}, {1, 3}, 0.3},
                                   {{{1, 2, 3}, {1.1, 2.2, 0.7}}, {1, 2}, 0.2},
                                   {{{1, 2, 3}, {1.1, 2.2, 0.7}}, {1, 1.5}, 0.1},
                                   {{{-2, 1, 9}, {7, 0.5, 7}}, {-9, 9}, 0.5},  // outside the series
                                   {{{4.5, 5}, {0.5, 0}}, {0, 5}, 1}};
    for (const Row& row : rows) {
        CAPTURE(row.reference.x, row.reference.y, row.window.begin, row.window.end);
        CHECK(largest(row.reference, row.window).value.value() == Approx(row.expected).margin(1e-12));
    }
    const MetricResult none = largest({{1, 3}, {1, 1}}, {1.5, 2.5});
    CHECK_FALSE(none.value);
    CHECK(none.note == "no point of the reference lies in the window");
}

TEST_CASE("A quantity takes any metric that has a row and a function", "[metric]") {
    const Metric range{"range",
                       Dimension::series,
                       {.whole_window = true},
                       false,
                       "largest less smallest value",
                       [](const MetricInput& in) {
                           const auto [low, high] = std::minmax_element(in.part.y.begin(), in.part.y.end());
                           return MetricResult{*high - *low, {}};
                       }};
    RunRecord record;
    record.series["p"] = {"Pa", "", triangle.x, triangle.y, {}};
    CHECK(quantity(range, record).value.value() == Approx(3));
}

TEST_CASE("The list of metrics in the documentation is that of the table", "[metric]") {
    const std::string text = read_whole_file(std::string(WETDECK_SOURCE_DIR) + "/validation/README.md");
    for (const Metric& metric : metrics()) {
        std::string needs;
        if (metric.needs.threshold) needs = "`threshold`";
        if (metric.needs.reference) needs = "`reference`, `y_column`, `window`";
        const std::string row =
            "| `" + std::string(metric.name) + "` | " + metric.meaning + " | " + needs + " |\n";
        CHECK_THAT(text, Catch::Contains(row));
    }
}
