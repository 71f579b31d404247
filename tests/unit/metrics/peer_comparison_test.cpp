// SPDX-License-Identifier: BSD-3-Clause
// Peer simulations and a run against the same measurements, with known differences.
#include "validation/metrics/peer_comparison.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

namespace {

ComparisonResult comparison(const std::string& kind, Curve measured, Curve simulated) {
    ComparisonResult c;
    c.title = "title of " + kind;
    c.reference = kind + "_file";
    c.kind = reference_kind_named(kind);
    c.quantity = "gauge";
    c.window = Window{0.5, 2};
    c.measured = std::move(measured);
    c.simulated = std::move(simulated);
    return c;
}

Curve level(double value, double begin = 0, double end = 2) {
    return {{begin, end}, {value, value}};
}

/// A run 0.5 above the measurement, a peer 0.25 above it.
RunSummary sample() {
    RunSummary run;
    run.record.series["gauge"] = {"Pa", "", {0, 1}, {0, 1}, {}};
    run.comparisons = {comparison("experiment", level(1), level(1.5)),
                       comparison("peer-simulation", level(1.25), level(1.5)),
                       comparison("analytic", level(7), level(1.5))};
    return run;
}

}  // namespace

TEST_CASE("A peer and the run are measured against the same experiment", "[peer_comparison]") {
    const auto result = compare_with_peers(sample());
    REQUIRE(result.has_value());
    REQUIRE(result->measured.size() == 1);
    CHECK(result->measured[0].title == "title of experiment");
    REQUIRE(result->peers.size() == 1);
    CHECK(result->peers[0].name.reference == "peer-simulation_file");
    CHECK(result->peers[0].rms.at(0).value() == Approx(0.25));
    REQUIRE(result->own.size() == 1);  // the same simulated curve is taken once
    CHECK(result->own[0].series == "gauge");
    CHECK(result->own[0].rms.at(0).value() == Approx(0.5));
}

TEST_CASE("Differences are taken over the window that all comparisons share", "[peer_comparison]") {
    RunSummary run = sample();
    run.comparisons[1].window = Window{1, 3};
    run.comparisons[1].measured = {{0, 1, 2}, {9, 1.25, 1.25}};  // far off before the window
    const auto result = compare_with_peers(run);
    REQUIRE(result.has_value());
    CHECK(result->window.begin == 1);
    CHECK(result->window.end == 2);
    CHECK(result->peers[0].rms.at(0).value() == Approx(0.25));
    run.comparisons[1].window = Window{2.5, 3};
    CHECK_FALSE(compare_with_peers(run).has_value());
}

TEST_CASE("A curve that spans too little of the window has no difference", "[peer_comparison]") {
    RunSummary run = sample();
    run.comparisons[1].measured = level(1.25, 1, 2);
    const auto result = compare_with_peers(run);
    REQUIRE(result.has_value());
    CHECK_FALSE(result->peers[0].rms.at(0).has_value());
    CHECK(result->own[0].rms.at(0).has_value());
}

TEST_CASE("Nothing is compared without both an experiment and a peer, or of series other than pressures",
          "[peer_comparison]") {
    RunSummary run = sample();
    SECTION("no peer") {
        run.comparisons.erase(run.comparisons.begin() + 1);
    }
    SECTION("no experiment") {
        run.comparisons.erase(run.comparisons.begin());
    }
    SECTION("an experiment without its file") {
        run.comparisons[0].available = false;
    }
    SECTION("a force") {
        run.record.series["gauge"].unit = "N/m";
    }
    CHECK_FALSE(compare_with_peers(run).has_value());
}
