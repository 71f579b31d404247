// SPDX-License-Identifier: BSD-3-Clause
// The passes compiled without intrinsics of x86 processors.
#include <catch2/catch.hpp>

#include "tests/support/samples.hpp"

namespace wetdeck::plain {
PairPasses choose_pair_passes(const Model& model, Precision precision, bool graded);
}

using namespace wetdeck;

TEST_CASE("Passes without intrinsics give the rates of every instruction set to rounding", "[simd]") {
    const Simulation simulation = samples::shaken_tank(samples::two_phase_model(), 1).simulate();
    const FluidParticles& fluid = simulation.fluid();
    std::vector<double> rate(fluid.size()), sum(fluid.size()), ax(fluid.size()), ay(fluid.size());
    PassInput in = simulation.inputs();
    in.density_rate = rate.data();
    in.kernel_sum = sum.data();
    in.acceleration_x = ax.data();
    in.acceleration_y = ay.data();
    const PairPasses passes =
        plain::choose_pair_passes(simulation.model(), Precision::double_precision, false);
    passes.density_rates(in);
    passes.accelerations(in);
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const double rates = i < fluid.water ? 1e5 : 1e2, accelerations = i < fluid.water ? 1e3 : 1e5;
        CHECK(rate[i] == Approx(fluid.density_rate[i]).epsilon(1e-11).margin(1e-11 * rates));
        CHECK(ax[i] == Approx(fluid.acceleration_x[i]).epsilon(1e-11).margin(1e-11 * accelerations));
        CHECK(ay[i] == Approx(fluid.acceleration_y[i]).epsilon(1e-11).margin(1e-11 * accelerations));
    }
}
