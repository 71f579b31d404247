// SPDX-License-Identifier: BSD-3-Clause
// A run that is stored between two builds of its list and restored on other threads.
#pragma once

#include <catch2/catch.hpp>
#include <cstring>

#include "tests/support/samples.hpp"

namespace wetdeck::samples {

/// Steps that must all be stable.
inline void step_stably(Simulation& simulation, int steps) {
    for (int n = 0; n < steps; ++n) REQUIRE_FALSE(simulation.step(1));
}

/// Checks that the run goes on with the same bits, past further builds of its list.
/// @param steps  before a build is waited for
inline void check_restored_run(Setup setup, int steps) {
    Simulation whole = setup.simulate();
    step_stably(whole, steps);
    std::uint64_t builds = whole.list_builds();
    while (whole.list_builds() == builds) step_stably(whole, 1);
    step_stably(whole, 2);
    setup.execution.threads = 3;
    Simulation parted = setup.simulate();
    parted.restore(whole.state());
    builds = whole.list_builds();
    step_stably(whole, 60);
    step_stably(parted, 60);
    CHECK(whole.list_builds() > builds);
    const std::vector<FluidState>&a = whole.fluid().state, &b = parted.fluid().state;
    REQUIRE(a.size() == b.size());
    CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(FluidState)) == 0);
}

}  // namespace wetdeck::samples
