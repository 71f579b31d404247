// SPDX-License-Identifier: BSD-3-Clause
// Identifiers in words, units and verdicts as a reader needs them.
#include "reports/figures/words.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;
using namespace wetdeck::report;
using samples::contains;

namespace {

QuantitySpec quantity(const std::string& name, const char* metric, const std::string& series) {
    QuantitySpec spec;
    spec.name = name;
    spec.metric = &metric_named(metric);
    spec.series = series;
    return spec;
}

ComparisonSpec comparison(const std::string& title, const std::string& series, const std::string& reference,
                          const std::string& label) {
    ComparisonSpec spec;
    spec.title = title;
    spec.quantity = series;
    spec.reference = reference;
    spec.y_label = label;
    return spec;
}

AnalysisSpec scene() {
    AnalysisSpec s;
    s.scene = "drop";
    s.quantities = {quantity("force_peak", "maximum", "body_force_y_filtered"),
                    quantity("force_peak_time", "time_of_maximum", "body_force_y"),
                    quantity("velocity_at_15ms", "value_at", "body_velocity_y"),
                    quantity("y_at_2", "value_at", "body_y_2"),
                    quantity("impulse_2ms", "integral", "body_force_y"),
                    quantity("travel", "integral", "body_velocity_y"),
                    quantity("loss", "change", "body_velocity_y"),
                    quantity("plateau_mean", "mean", "gauge_7"),
                    quantity("first_peak", "maximum", "gauge_7"),
                    quantity("second_peak", "maximum", "gauge_7"),
                    quantity("rms_gauge", "rms_difference", "gauge_7"),
                    quantity("slope_of_force", "slope", "body_force_y"),
                    quantity("arrival", "first_crossing", "front")};
    s.quantities[2].threshold = 0.015;
    s.quantities[2].origin = "first_contact";
    s.quantities[3].threshold = 2;
    s.quantities[8].window = Window{0, 0.02};
    s.quantities[9].window = Window{0.02, 0.05};
    s.quantities[10].reference = "author_gauge";
    s.quantities[12].threshold = 0.5;
    s.comparisons = {
        comparison("Pressure at 0.19 h_w, Author (2002)", "gauge_7", "author_gauge", "p / (rho g h) [-]"),
        comparison("Force against the experiment, Author (2002)", "body_force_y", "author_force",
                   "force [kN/m]"),
        comparison("Speed, Author (2002)", "body_velocity_y", "author_speed", "V [m/s]"),
        comparison("Profile at T = 3, other_profile", "profile", "other_profile", "p [kPa]")};
    return s;
}

}  // namespace

TEST_CASE("Quantities stand by their words", "[report]") {
    const AnalysisSpec s = scene();
    const std::pair<const char*, const char*> words[] = {
        {"force_peak", "largest vertical force, filtered"},
        {"force_peak_time", "time of the largest vertical force"},
        {"velocity_at_15ms", "vertical velocity at 15 ms after first contact"},
        {"y_at_2", "vertical position of body 2 at 2 s"},
        {"impulse_2ms", "impulse of the vertical force"},
        {"travel", "integral of the vertical velocity"},
        {"loss", "change of the vertical velocity"},
        {"plateau_mean", "mean pressure at 0.19 h_w"},
        {"first_peak", "largest pressure at 0.19 h_w, from 0 to 20 ms"},
        {"second_peak", "largest pressure at 0.19 h_w, from 0.02 to 50 ms"},
        {"rms_gauge", "rms difference of the pressure at 0.19 h_w to Author (2002)"},
        {"slope_of_force", "slope of the vertical force"},
        {"arrival", "time at which the front reaches 0.5"},
        {"body_force_y: peak against author_force", "peak of the vertical force"},
        {"gauge_7: mean against author_gauge", "mean of the pressure at 0.19 h_w"},
        {"Profile at T = 3, other_profile: mean", "mean of the profile at T = 3"},
        {"curve of body_velocity_y", "curve of the vertical velocity"},
        {"not_known", "not known"}};
    for (const auto& [name, expected] : words) {
        INFO(name);
        std::string found = quantity_words(s, name);
        for (std::size_t at; (at = found.find("\u00a0")) != std::string::npos;) found.replace(at, 2, " ");
        CHECK(found == expected);
    }
}

TEST_CASE("Series of every body stand by their words", "[report]") {
    const std::pair<const char*, const char*> words[] = {
        {"body_force_x", "horizontal force"},
        {"body_force_y", "vertical force"},
        {"body_torque", "moment"},
        {"body_x", "horizontal position"},
        {"body_angle", "angle"},
        {"body_velocity_y", "vertical velocity"},
        {"body_acceleration_y_filtered", "vertical acceleration, filtered"},
        {"body_force_y_2_filtered", "vertical force of body 2, filtered"},
        {"body_y_12", "vertical position of body 12"},
        {"energy_kinetic", "kinetic energy"},
        {"pressure_p4", "pressure p4"},
        {"level_1", "level 1"}};
    for (const auto& [name, expected] : words) CHECK(series_words(name) == expected);
}

TEST_CASE("A verdict says faster and slower of a speed, later and earlier of a time", "[report]") {
    struct Case {
        const char *quantity, *against, *unit;
        double reference, error;
        const char *verdict, *words;
    };
    const Case cases[] = {{"speed", "x", "m/s", -5, 0.2, "too high", "too slow"},
                          {"speed", "x", "m/s", -5, -0.2, "too low", "too fast"},
                          {"speed", "x", "m/s", 5, 0.2, "too high", "too fast"},
                          {"speed", "x", "m/s", 5, -0.2, "lower", "slower"},
                          {"speed", "x", "m/s", -5, -0.2, "lower", "faster"},
                          {"body_velocity_y: mean against author_speed", "Speed, Author (2002)", "-", -5, 0.2,
                           "too high", "too slow"},
                          {"time", "x", "s", 2, 0.2, "too high", "too late"},
                          {"time", "x", "s", 2, -0.2, "too low", "too early"},
                          {"time", "x", "s", 2, -0.2, "lower", "earlier"},
                          {"force", "x", "N/m", 5, 0.2, "too high", "too high"},
                          {"force", "x", "N/m", -5, -0.2, "too low", "too large"},
                          {"force", "x", "N/m", -5, 0.2, "higher", "smaller in magnitude"},
                          {"force", "x", "N/m", 5, 0.2, "refine first", "refine first"},
                          {"speed", "x", "m/s", -5, 0.2, "within the uncertainty", "within the uncertainty"}};
    const AnalysisSpec s = scene();
    for (const Case& c : cases) {
        ValidationRow row;
        row.quantity = c.quantity;
        row.against = c.against;
        row.unit = c.unit;
        row.reference = c.reference;
        row.error = c.error;
        row.verdict = c.verdict;
        INFO(c.quantity << " " << c.reference << " " << c.error << " " << c.verdict);
        CHECK(verdict_words(s, row) == c.words);
    }
}

TEST_CASE("A scaled value has the unit of its axis", "[report]") {
    const AnalysisSpec s = scene();
    ValidationRow row;
    row.unit = "Pa";
    CHECK(unit_words(s, row) == "Pa");
    row.unit = "-";
    CHECK(unit_words(s, row) == "-");
    row.quantity = "body_force_y: peak against author_force";
    row.against = "Force against the experiment, Author (2002)";
    CHECK(unit_words(s, row) == "kN/m");
    row.quantity = "plateau_mean";
    row.against = "Author (2002)";
    CHECK(unit_words(s, row) == "p / (rho g h)");
}

TEST_CASE("No order stands beside values that drift apart, and no impulse of a velocity", "[report]") {
    Summary summary = samples::summary();
    summary.convergence[1].order = -5.64;
    summary.convergence[1].verdict = "divergent";
    for (RunSummary& run : summary.runs) {
        run.comparisons[0].quantity = "body_velocity_y";
        run.comparisons[0].features = {{"impulse", 1, 2}, {"peak", 3, 4}};
    }
    const std::string page = samples::page_of(summary);
    CHECK_FALSE(contains(page, "5.64"));
    CHECK_FALSE(contains(page, "impulse"));
    CHECK(contains(page, "<th scope=\"col\">integral</th>"));
    summary.convergence[1].order = 1.64;
    summary.convergence[1].verdict = "monotonic";
    CHECK(contains(samples::page_of(summary), ">1.64</td>"));
}
