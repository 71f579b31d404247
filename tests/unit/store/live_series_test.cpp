// SPDX-License-Identifier: BSD-3-Clause
// live.h5: rows appear block by block.
#include "validation/store/live_series.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {

const std::vector<LiveColumn> columns = {{"pressure", "Pa", "at the gauge"},
                                         {"energy", "J/m", "of the water"}};

void append(LiveSeries& live, int first, int end) {
    for (int i = first; i < end; ++i) live.append(0.5 * i, std::vector<double>{1.0 * i, -2.0 * i});
}

}  // namespace

TEST_CASE("live series come back with names, units and values", "[store]") {
    const ScratchFolder folder;
    {
        LiveSeries live(folder, columns, 4);
        append(live, 0, 10);
    }
    const std::map<std::string, Series> series = read_live(folder);
    REQUIRE(series.size() == 2);
    REQUIRE(samples::same(
        series.at("pressure"),
        {"Pa", "at the gauge", {0, .5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {}}));
    REQUIRE(series.at("energy").value.back() == -18);
}

TEST_CASE("live series can be read while the run goes on, whole blocks at a time", "[store]") {
    const ScratchFolder folder;
    LiveSeries live(folder, columns, 4);
    REQUIRE(read_live(folder).at("energy").time.empty());
    append(live, 0, 10);
    REQUIRE(read_live(folder).at("energy").time.size() == 8);
    live.flush();
    REQUIRE(read_live(folder).at("energy").time.size() == 10);
}

TEST_CASE("live series start anew over old ones and over garbage", "[store]") {
    const ScratchFolder folder;
    SECTION("old ones") {
        LiveSeries live(folder, columns, 4);
        append(live, 0, 10);
    }
    SECTION("garbage") {
        samples::put_bytes(live_file(folder), "garbage");
    }
    LiveSeries(folder, columns, 4).flush();
    REQUIRE(read_live(folder).at("energy").time.empty());
}

TEST_CASE("a row of the wrong length is refused", "[store]") {
    const ScratchFolder folder;
    LiveSeries live(folder, columns);
    REQUIRE_THROWS_WITH(live.append(0, std::vector<double>{1}), Catch::Contains("1 values for 2 columns"));
}

TEST_CASE("a missing or damaged live file is a data error that names it", "[store]") {
    const ScratchFolder folder;
    REQUIRE_THROWS_WITH(read_live(folder), live_file(folder).string() + ": no such file");
    samples::put_bytes(live_file(folder), "garbage");
    REQUIRE_THROWS_AS(read_live(folder), DataError);
}
