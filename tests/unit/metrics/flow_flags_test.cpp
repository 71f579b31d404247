// SPDX-License-Identifier: BSD-3-Clause
// What makes a flow doubtful, and a water that is compressed more than it should be.
#include "validation/metrics/flow_flags.hpp"

#include <catch2/catch.hpp>
#include <tuple>

using namespace wetdeck;
using Catch::Contains;

namespace {

RunRecord compressed_by(double change, double sound_speed) {
    RunRecord record;
    record.series["density_error_max"] = {"-", "", {0, 1, 2}, {0, change, 0.5 * change}, {}};
    record.parameters["water.sound_speed"] = sound_speed;
    return record;
}

}  // namespace

TEST_CASE("A change of density above one per cent is noted, with the speeds that would keep it", "[flow]") {
    for (const double change : {0.0, 0.001, 0.005, 0.0099, 0.01})
        CHECK_FALSE(compression_note(compressed_by(change, 60)).has_value());
    const auto [change, speed, words] = GENERATE(table<double, double, std::string>({
        {0.0101, 60, "up to 1 %"},
        {0.02, 60, "up to 2 %"},
        {0.04, 60, "with 120 m/s the same pressures change it by 1 %, with 240 m/s those of a flat impact"},
        {0.0225, 200,
         "with 300 m/s the same pressures change it by 1 %, with 450 m/s those of a flat impact"},
        {0.09, 10, "sound speed, 10 m/s: with 30 m/s"},
        {0.25, 1450, "sound speed, 1450 m/s"},
    }));
    const auto note = compression_note(compressed_by(change, speed));
    REQUIRE(note.has_value());
    CHECK_THAT(*note, Contains(words) && Contains("twice the sound speed"));
}

TEST_CASE("A flow is doubtful beyond five per cent and with particles outside the tank", "[flow]") {
    CHECK(flow_flags(compressed_by(0.05, 60)).empty());
    CHECK(flow_flags(compressed_by(0.051, 60)).size() == 1);
    RunRecord outside = compressed_by(0.02, 60);
    outside.series["particles_outside"] = {"-", "", {0, 1}, {0, 3}, {}};
    REQUIRE(flow_flags(outside).size() == 1);
    CHECK_THAT(flow_flags(outside)[0], Contains("3 fluid particles are beyond"));
    RunRecord coarse;
    coarse.series["coarsest_at_bodies"] = {"-", "", {0, 1}, {1, 1.5}, {}};
    CHECK(flow_flags(coarse).empty());
    coarse.series["coarsest_at_bodies"].value.back() = 2.2;
    REQUIRE(flow_flags(coarse).size() == 1);
    CHECK_THAT(flow_flags(coarse)[0], Contains("2.2 times the finest spacing have touched a body"));
    CHECK(flow_flags(RunRecord{}).empty());
    CHECK_FALSE(compression_note(RunRecord{}).has_value());
}
