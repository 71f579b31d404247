// SPDX-License-Identifier: BSD-3-Clause
// What a benchmark makes of repeated measurements, and the limits it measures.
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/benchmark/instruction_counter.hpp"
#include "validation/benchmark/machine_limit.hpp"
#include "validation/benchmark/spread.hpp"
#include "validation/run/assemble.hpp"

using namespace wetdeck;

TEST_CASE("one disturbed repeat moves neither median nor deviation by much") {
    const Measured calm = measured({3, 1, 2, 5, 4});
    CHECK(calm.median == 3);
    CHECK(calm.deviation == 1);
    const Measured disturbed = measured({3, 1, 2, 500, 4});
    CHECK(disturbed.median == 3);
    CHECK(disturbed.deviation == 1);
    CHECK(measured({1, 2}).median == 1.5);
    CHECK(measured({7}).deviation == 0);
}

TEST_CASE("limits are measured on a state without changing it") {
    const Scene scene = parse_scene(samples::small_scene, "small.toml");
    const Simulation simulation = assemble(scene, 0.04, 1);
    const std::vector<double> before = simulation.fluid().density_rate;
    const ArithmeticLimit limit = arithmetic_limit(simulation, 1);
    CHECK(limit.density > 0);
    CHECK(limit.momentum > 0);
    CHECK(simulation.fluid().density_rate == before);
    // a particle of a full neighbourhood of radius 2 h = 3 dx has 27 others; its cluster lists more
    CHECK(listed_neighbours(simulation) >
          28 * static_cast<double>(simulation.neighbours().clusters().size()));
    CHECK(triad_bandwidth(100'000, 1) > 0);
}

TEST_CASE("instructions are counted where the machine counts them") {
    const InstructionCounter counter;
    const std::optional<std::uint64_t> before = counter.count();
    if (!before) {
        WARN("not tested: this machine counts no instructions");
        return;
    }
    volatile double sum = 0;
    for (int n = 0; n < 100'000; ++n) sum = sum + n;
    const std::uint64_t executed = counter.count().value() - *before;
    CHECK(executed > 300'000);
    CHECK(executed < 10'000'000);
}
