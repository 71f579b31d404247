// SPDX-License-Identifier: BSD-3-Clause
// Instants that a run finds in its own series, and numbers by hand that are compared with them.
#include "validation/metrics/time_origin.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "validation/metrics/resample.hpp"

using namespace wetdeck;
using Catch::Contains;
using Crossing = OriginEvent::Crossing;

namespace {

constexpr double interval = 1e-3;

/// A body that falls from 0.05 m above the level at 1 m/s under gravity, until 0.1 s.
RunRecord fall(double spacing = 0.01) {
    RunRecord record;
    record.particle_spacing = spacing;
    Series clearance{"m", "", {}, {}, {}}, gap = clearance;
    for (int k = 0; k <= 100; ++k) {
        const double t = k * interval;
        clearance.time.push_back(t);
        clearance.value.push_back(0.05 - t - 0.5 * 9.81 * t * t);
        gap.time.push_back(t);
        gap.value.push_back(std::max(0.0, clearance.value.back()));
    }
    record.series = {{"body_clearance", clearance}, {"body_water_gap", gap}};
    return record;
}

/// Time of a fall through this height from 1 m/s.
double time_of_fall(double height) {
    return (std::sqrt(1 + 2 * 9.81 * height) - 1) / 9.81;
}

AnalysisSpec stated(double contact) {
    AnalysisSpec spec;
    spec.origins["contact"] = {contact, std::nullopt};
    spec.stated_contacts = {"contact"};
    spec.contacts = {geometric_contact("body", "body_clearance")};
    spec.sample_interval = interval;
    return spec;
}

RunRecord record_of(std::vector<double> value) {
    RunRecord record;
    Series series{"m", "", {}, std::move(value), {}};
    for (std::size_t k = 0; k < series.value.size(); ++k) series.time.push_back(0.1 * static_cast<double>(k));
    record.series["s"] = series;
    return record;
}

}  // namespace

TEST_CASE("geometric and first contact of a fall are those computed by hand", "[origin]") {
    const FoundOrigin geometric = find_event(fall(), geometric_contact("body", "body_clearance"));
    CHECK(geometric.problem == "");
    CHECK(geometric.interval == Approx(interval));
    CHECK(geometric.time == Approx(time_of_fall(0.05)).epsilon(1e-4));
    for (const double spacing : {0.02, 0.01, 0.005}) {  // a quarter of the spacing before
        const FoundOrigin wet = find_event(fall(spacing), first_contact("body", "body_water_gap"));
        CHECK(wet.time == Approx(time_of_fall(0.05 - 0.25 * spacing)).epsilon(1e-4));
    }
}

TEST_CASE("a level is crossed where the series first goes through it in the direction that counts",
          "[origin]") {
    struct Row {
        std::vector<double> value;
        double level;
        Crossing crossing;
        std::optional<double> time;
    };
    const std::vector<Row> rows = {
        {{0, 1, 0}, 0.5, Crossing::either, 0.05},
        {{0, 1, 0}, 0.5, Crossing::rising, 0.05},
        {{0, 1, 0}, 0.5, Crossing::falling, 0.15},
        {{2, 1, 0}, 0.5, Crossing::rising, std::nullopt},
        {{2, 1, 0}, 1.0, Crossing::falling, 0.1},
        {{1, 1, 0}, 1.0, Crossing::falling, 0.0},
        {{0, 0.2, 0.4}, 1.0, Crossing::either, std::nullopt},
        {{0, 1}, 0.25, Crossing::rising, 0.025},
        {{-1, -2, -3}, 0.0, Crossing::falling, std::nullopt},
        {{3, 2, 2, 1}, 1.5, Crossing::either, 0.25},
        {{0, 1}, 1.0, Crossing::either, 0.1},
    };
    for (const Row& row : rows) {
        OriginEvent event;
        event.series = "s";
        event.level = row.level;
        event.crossing = row.crossing;
        event.meaning = "crossing";
        const FoundOrigin found = find_event(record_of(row.value), event);
        CAPTURE(row.level, row.value);
        CHECK(found.problem.empty() == row.time.has_value());
        if (row.time) CHECK(found.time == Approx(*row.time).margin(1e-12));
    }
}

TEST_CASE("a body that starts wet has its first contact at the start and no geometric contact", "[origin]") {
    RunRecord record = record_of({-0.1, -0.2});
    record.particle_spacing = 0.01;
    record.series["gap"] = record_of({0, 0}).series["s"];
    CHECK(find_event(record, first_contact("body", "gap")).time == 0);
    CHECK(find_event(record, first_contact("body", "gap")).problem == "");
    CHECK(find_event(record, geometric_contact("body", "s")).problem ==
          "the run found no geometric contact of body: 's' never falls through 0, from -0.1 at the start to "
          "-0.2 at "
          "0.1 s");
    CHECK_THAT(find_event(record, geometric_contact("body", "none")).problem,
               Contains("needs the series 'none', which this run does not hold"));
}

TEST_CASE("a curve counts its time from what its own run found", "[origin]") {
    SeriesScaling scaling;
    scaling.origin = "contact";
    scaling.event = geometric_contact("body", "body_clearance");
    const SeriesCurve curve = series_curve(fall(), "body_clearance", scaling);
    CHECK(curve.curve.x.front() == Approx(-time_of_fall(0.05)).epsilon(1e-4));
    RunRecord dry = fall();
    for (double& value : dry.series["body_clearance"].value) value += 1;
    CHECK_THAT(series_curve(dry, "body_clearance", scaling).problem,
               Contains("time origin 'contact': the run found no geometric contact of body"));
}

TEST_CASE("the origin with which a run was started counts before that of the scene file", "[origin]") {
    SeriesScaling scaling;
    scaling.origin = "contact";
    scaling.x_offset = 0.02;
    RunRecord record = fall();
    CHECK(find_origin(record, scaling).time == 0.02);
    for (const TimeOrigin& origin :
         {TimeOrigin{0.03, std::nullopt}, TimeOrigin{0, geometric_contact("body", "body_clearance")},
          TimeOrigin{0, first_contact("body", "body_water_gap")}}) {
        record.provenance["time_origins"] = origins_text({{"contact", origin}, {"gate", {1, std::nullopt}}});
        const double expected = origin.event ? find_event(record, *origin.event).time : 0.03;
        CHECK(find_origin(record, scaling).time == expected);
    }
    record.provenance["time_origins"] = "{}";
    CHECK(find_origin(record, scaling).time == 0.02);
}

TEST_CASE("a contact by hand is doubted where it is off by more than the sample interval", "[origin]") {
    const double found = time_of_fall(0.05);
    for (const double off : {-0.9, 0.0, 0.9})
        CHECK(doubtful_origins(stated(found + off * interval), fall()).empty());
    for (const double off : {-30.0, -1.1, 1.1, 30.0}) {
        const std::vector<std::string> doubts = doubtful_origins(stated(found + off * interval), fall());
        CAPTURE(off);
        REQUIRE(doubts.size() == 1);
        CHECK_THAT(doubts[0], Contains("time_origins.contact is ") &&
                                  Contains("geometric contact of body at 0.04") &&
                                  Contains("contact = \"geometric_contact\""));
    }
    RunRecord dry = fall();
    for (double& value : dry.series["body_clearance"].value) value += 1;
    REQUIRE(doubtful_origins(stated(found), dry).size() == 1);
    CHECK_THAT(doubtful_origins(stated(found), dry)[0],
               Contains("the run found no geometric contact of body"));
    CHECK(doubtful_origins(stated(0.2), dry).empty());                  // the run ended before
    CHECK(doubtful_origins(stated(found), record_of({1, 0})).empty());  // a run of an older program
    AnalysisSpec by_event = stated(9);
    by_event.origins["contact"].event = by_event.contacts[0];
    CHECK(doubtful_origins(by_event, fall()).empty());
}
