// SPDX-License-Identifier: BSD-3-Clause
// Pairs in mixed precision against the plain sums in double precision, for every instruction set.
#include <catch2/catch.hpp>

#include "solver/core/dice.hpp"
#include "solver/core/errors.hpp"
#include "solver/physics/mixed_precision.hpp"
#include "tests/support/ingredients.hpp"
#include "tests/support/reference_rates.hpp"
#include "tests/support/samples.hpp"

namespace wetdeck::plain {
PairPasses choose_pair_passes(const Model& model, Precision precision, bool graded);
}

using namespace wetdeck;
using samples::Ingredient;
using samples::two_phase_model;

namespace {

/// Those that pairs in mixed precision have.
std::vector<Ingredient> ingredients() {
    std::vector<Ingredient> all = samples::ingredients();
    std::erase_if(all,
                  [](const Ingredient& each) { return !without_mixed_pairs(samples::with(each)).empty(); });
    return all;
}

samples::Setup tank(const Ingredient& ingredient, std::uint64_t seed) {
    samples::Setup setup = samples::shaken_tank(samples::with(ingredient), seed);
    setup.execution.precision = Precision::mixed;
    return setup;
}

/// Rates in mixed precision may differ from those in double precision by so much, over the largest of their
/// kind and phase; single precision has 6e-8. Measured: 2.9e-7 (density), 5.4e-7 (acceleration).
constexpr double density_bound = 1e-6, acceleration_bound = 2e-6;

void check_rates(const PassInput& rates, const FluidParticles& fluid, const samples::Rates& expected) {
    const auto vector = [&](const double* values) { return std::vector(values, values + fluid.size()); };
    const std::size_t ends[] = {0, fluid.water, fluid.size()};
    for (int phase = 0; phase < 2; ++phase) {
        const std::size_t first = ends[phase], last = ends[phase + 1];
        const auto differ = [&](const double* found, const std::vector<double>& in_double) {
            return samples::difference(vector(found), in_double, first, last);
        };
        CHECK(differ(rates.density_rate, expected.density) < density_bound);
        CHECK(differ(rates.acceleration_x, expected.acceleration_x) < acceleration_bound);
        CHECK(differ(rates.acceleration_y, expected.acceleration_y) < acceleration_bound);
    }
    CHECK(samples::difference(vector(rates.kernel_sum), expected.kernel_sum, 0, fluid.water) < density_bound);
}

struct Outputs {
    std::vector<double> density, sum, ax, ay;
    explicit Outputs(std::size_t size) : density(size), sum(size), ax(size), ay(size) {}
    void receive(PassInput& in) {
        in.density_rate = density.data();
        in.kernel_sum = sum.data();
        in.acceleration_x = ax.data();
        in.acceleration_y = ay.data();
    }
};

}  // namespace

TEST_CASE("Rates in mixed precision are those of the plain sum within single precision", "[mixed][simd]") {
    const Ingredient ingredient = GENERATE(from_range(ingredients()));
    for (const std::string& name : samples::instruction_sets()) {
        INFO(name << ", " << ingredient.name);
        const samples::ChosenInstructionSet chosen(name);
        const Simulation simulation = tank(ingredient, 1).simulate();
        REQUIRE(simulation.instruction_set() == name);
        Outputs out(simulation.fluid().size());
        PassInput in = simulation.inputs();
        out.receive(in);
        const PairPasses passes = pair_passes(simulation.model(), name, Precision::mixed);
        passes.density_rates(in);
        passes.accelerations(in);
        check_rates(in, simulation.fluid(),
                    samples::reference_rates(simulation.fluid(), simulation.walls(), simulation.model(),
                                             simulation.particle_spacing()));
        CHECK(out.ax == simulation.fluid().acceleration_x);
        CHECK(simulation.momentum_error() < 1e-7);  // measured 1.3e-8
    }
}

TEST_CASE("Passes in mixed precision without intrinsics are within single precision, too", "[mixed][simd]") {
    const Simulation simulation = tank(ingredients().front(), 2).simulate();
    Outputs out(simulation.fluid().size());
    PassInput in = simulation.inputs();
    out.receive(in);
    const PairPasses passes = plain::choose_pair_passes(simulation.model(), Precision::mixed, false);
    passes.density_rates(in);
    passes.accelerations(in);
    check_rates(in, simulation.fluid(),
                samples::reference_rates(simulation.fluid(), simulation.walls(), simulation.model(),
                                         simulation.particle_spacing()));
}

TEST_CASE("In mixed precision rates do not depend on where in the plane the tank is", "[mixed]") {
    const Vec2 far = GENERATE(Vec2(-3, 4), Vec2(1024, -512), Vec2(-1e5, 3e4));
    samples::Setup near = tank(ingredients().front(), 3), away = near;
    away.domain = {near.domain.low + far, near.domain.high + far};
    for (FluidState& p : away.fluid.state) p.x += far.x(), p.y += far.y();
    for (WallState& w : away.walls.state) w.x += far.x(), w.y += far.y();
    CHECK(samples::rate_difference(near.simulate(), away.simulate()) < acceleration_bound);
}

TEST_CASE("Periodic images are kept up in mixed precision", "[mixed][periodic]") {
    Model model = two_phase_model();
    model.periodic_x = true;
    samples::Setup setup(model, {{0, 0}, {1, 0.5}}, 0.05, true);
    setup.fill(Phase::water, {{0, 0}, {1, 0.5}});
    verification::shake(setup, 0.2, 5);
    for (FluidState& p : setup.fluid.state) p.vx = 1 + p.y;
    samples::Setup mixed = setup;
    mixed.execution.precision = Precision::mixed;
    Simulation in_double = setup.simulate(), in_mixed = mixed.simulate();
    for (int step = 0; step < 100; ++step) {
        REQUIRE_FALSE(in_double.step(1e-3));
        REQUIRE_FALSE(in_mixed.step(1e-3));
    }
    const std::vector<FluidState> a = samples::by_id(in_double.fluid()), b = samples::by_id(in_mixed.fluid());
    for (std::size_t id = 0; id < a.size(); ++id) {
        CHECK(b[id].x == Approx(a[id].x).margin(1e-5));
        CHECK(b[id].vy == Approx(a[id].vy).margin(1e-3));
    }
}

TEST_CASE("Two particles alone get opposite momentum within single precision", "[mixed][simd]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    const samples::ChosenInstructionSet chosen(name);
    samples::Setup setup(two_phase_model(), Box{{-1, -1}, {1, 1}}, 0.05);
    setup.execution.precision = Precision::mixed;
    setup.model.gravity = Vec2::Zero();
    setup.fluid.add(Phase::water, {0, 0}, 2.5, 1001);
    const Phase other = GENERATE(Phase::water, Phase::air);
    setup.fluid.add(other, {0.03, 0.02}, other == Phase::water ? 2.4 : 0.0025,
                    other == Phase::water ? 1002 : 1.1);
    setup.fluid.state[0].vx = 2;
    setup.fluid.state[1].vy = -1;
    const FluidParticles fluid = setup.simulate().fluid();
    const auto force = [&](std::size_t i) {
        return Vec2(fluid.mass[i] * Vec2(fluid.acceleration_x[i], fluid.acceleration_y[i]));
    };
    REQUIRE(force(0).norm() > 1);
    CHECK((force(0) + force(1)).norm() < 4e-7 * force(0).norm());
}

TEST_CASE("Differences of fixed-point positions are antisymmetric, and exact to a unit anywhere", "[mixed]") {
    const Box domain{{-1, 2}, {39, 2.5}};
    constexpr double support = 0.03;
    const MixedFluid mixed(domain, support);
    const FixedPoint& fixed_point = mixed.fixed_point();
    CHECK(1 / fixed_point.per_metre <= 64 / 4294967296.0);
    const auto metres = [&](std::uint32_t difference) {
        return static_cast<std::int32_t>(difference) / fixed_point.per_metre;
    };
    Dice dice(7);
    for (int trial = 0; trial < 2000; ++trial) {
        FluidState a, b;
        a.x = 19 + dice.symmetric(20 + 2 * support);
        a.y = 2.25 + dice.symmetric(0.25 + 2 * support);
        b.x = a.x + dice.symmetric(support);
        b.y = a.y + dice.symmetric(support);
        const MixedState i = fixed_point(a), j = fixed_point(b);
        REQUIRE(i.x - j.x == std::uint32_t{0} - (j.x - i.x));
        REQUIRE(std::abs(metres(i.x - j.x) - (a.x - b.x)) <= 1 / fixed_point.per_metre);
        REQUIRE(std::abs(metres(i.y - j.y) - (a.y - b.y)) <= 1 / fixed_point.per_metre);
        REQUIRE(std::abs(metres(i.x - mixed.nowhere().x)) > 1.9 * support);
        REQUIRE(std::abs(metres(i.y - mixed.nowhere().y)) > 1.9 * support);
    }
}

TEST_CASE("Models without pairs in mixed precision are refused by name", "[mixed]") {
    const auto refused = [](const std::function<void(Model&)>& choose, const char* named) {
        Model model = two_phase_model();
        choose(model);
        CHECK_NOTHROW(pair_passes(model));
        CHECK_THROWS_WITH(pair_passes(model, "", Precision::mixed), Catch::Contains(named));
    };
    refused([](Model& m) { m.velocity_mean = Mean::harmonic; }, "velocity_mean");
    refused([](Model& m) { m.pressure_mean = Mean::harmonic; }, "pressure_mean");
    refused([](Model& m) { m.impedance_mean = ImpedanceMean::harmonic; }, "impedance_mean");
    refused([](Model& m) { m.dissipation_switch = true; }, "dissipation_switch");
}
