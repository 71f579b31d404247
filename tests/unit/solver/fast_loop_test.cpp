// SPDX-License-Identifier: BSD-3-Clause
// The fast pair loops against the plain reference, for every instruction set and every ingredient.
#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/support/ingredients.hpp"
#include "tests/support/reference_rates.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::Ingredient;
using samples::ingredients;
using samples::paper_model;
using samples::two_phase_model;
using samples::with;

namespace {

double largest(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum = std::max(sum, std::abs(v));
    return sum;
}

/// Each phase has its own scale: rates of air and water differ by a factor of a thousand.
void check_rates(const FluidParticles& fluid, const samples::Rates& expected, double tolerance) {
    const std::size_t ends[] = {0, fluid.water, fluid.size()};
    for (int phase = 0; phase < 2; ++phase) {
        const std::size_t first = ends[phase], last = ends[phase + 1];
        CHECK(samples::difference(fluid.density_rate, expected.density, first, last) < tolerance);
        CHECK(samples::difference(fluid.acceleration_x, expected.acceleration_x, first, last) < tolerance);
        CHECK(samples::difference(fluid.acceleration_y, expected.acceleration_y, first, last) < tolerance);
    }
}

}  // namespace

TEST_CASE("Rates of the fast loop are those of the plain sum over all pairs", "[simd][pairs]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    const Ingredient& ingredient = GENERATE(from_range(ingredients()));
    INFO(name << ", " << ingredient.name);
    const samples::ChosenInstructionSet chosen(name);
    const Simulation simulation = samples::shaken_tank(with(ingredient), 1).simulate();
    REQUIRE(simulation.instruction_set() == name);
    const FluidParticles& fluid = simulation.fluid();
    const samples::Rates expected = samples::reference_rates(fluid, simulation.walls(), simulation.model(),
                                                             simulation.particle_spacing());
    check_rates(fluid, expected, 1e-11);  // rounding of some 30 terms
}

TEST_CASE("Where particles differ in their spacings the fast loop is the plain sum, too", "[simd][pairs]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    INFO(name);
    const samples::ChosenInstructionSet chosen(name);
    Model model = two_phase_model();
    model.wall_slip = GENERATE(WallSlip::free, WallSlip::no);
    if (model.wall_slip == WallSlip::no) {
        model.viscosity = Viscosity::symmetric;
        model.water.viscosity = 2;
        model.air.viscosity = 0.01;
    }
    samples::Setup setup = samples::graded_tank(model, 1);
    setup.execution.precision = GENERATE(Precision::double_precision, Precision::mixed);
    const double tolerance = setup.execution.precision == Precision::mixed ? 2e-5 : 1e-11;
    const Simulation simulation = setup.simulate();
    const FluidParticles& fluid = simulation.fluid();
    const samples::Rates expected = samples::reference_rates(fluid, simulation.walls(), simulation.model(),
                                                             simulation.particle_spacing(), true);
    check_rates(fluid, expected, tolerance);
    CHECK(samples::difference(fluid.kernel_sum, expected.kernel_sum, 0, fluid.water) < tolerance);
    CHECK(simulation.momentum_error() < tolerance);
    // with one smoothing length for all the sums are others
    const samples::Rates equal = samples::reference_rates(fluid, simulation.walls(), simulation.model(),
                                                          simulation.particle_spacing());
    CHECK(samples::difference(fluid.acceleration_y, equal.acceleration_y, 0, fluid.water) > 1e-2);
}

TEST_CASE("Particles that could differ in their spacings and do not have the rates of equal spacings",
          "[simd][pairs]") {
    const samples::Setup equal = samples::shaken_tank(two_phase_model(), 6);
    samples::Setup graded = equal;
    graded.coarsest = 2;
    for (FluidState& p : graded.fluid.state) p.fineness = 1;
    CHECK(samples::rate_difference(equal.simulate(), graded.simulate()) < 1e-12);
}

TEST_CASE("At edges of bodies and under a bound of the density the fast loop is the plain sum, too",
          "[simd][wall]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    const samples::ChosenInstructionSet chosen(name);
    samples::Setup setup = samples::shaken_tank(two_phase_model(), 4);
    setup.model.negative_pressure = false;
    for (std::size_t w = 0; w < setup.walls.size(); w += 3)
        setup.walls.state[w].nx = setup.walls.state[w].ny = 0;
    const Simulation simulation = setup.simulate();
    const FluidParticles& fluid = simulation.fluid();
    const samples::Rates expected = samples::reference_rates(fluid, simulation.walls(), simulation.model(),
                                                             simulation.particle_spacing());
    CHECK(samples::difference(fluid.density_rate, expected.density, 0, fluid.water) < 1e-11);
    CHECK(samples::difference(fluid.acceleration_x, expected.acceleration_x, 0, fluid.water) < 1e-11);
    CHECK(samples::difference(fluid.kernel_sum, expected.kernel_sum, 0, fluid.water) < 1e-11);
}

TEST_CASE("Every ingredient changes the rates, so that the comparison above can see it", "[pairs]") {
    const samples::Setup plain = samples::shaken_tank(with(ingredients().front()), 1);
    const samples::Rates before = samples::reference_rates(plain.simulate().fluid(), plain.simulate().walls(),
                                                           plain.model, plain.particle_spacing);
    for (std::size_t k = 1; k < ingredients().size(); ++k) {
        INFO(ingredients()[k].name);
        const Simulation simulation = samples::shaken_tank(with(ingredients()[k]), 1).simulate();
        const samples::Rates after = samples::reference_rates(
            simulation.fluid(), simulation.walls(), simulation.model(), simulation.particle_spacing());
        const std::size_t size = after.density.size();
        const double change =
            std::max({samples::difference(after.density, before.density, 0, size),
                      samples::difference(after.acceleration_x, before.acceleration_x, 0, size),
                      samples::difference(after.acceleration_y, before.acceleration_y, 0, size)});
        CHECK(change > 1e-6);
    }
}

TEST_CASE("Shepard means at walls are those of the plain sum over the fluid near them", "[simd][wall]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    const samples::ChosenInstructionSet chosen(name);
    Model model = two_phase_model();
    model.wall_pressure = GENERATE(WallPressure::shepard, WallPressure::shepard_water);
    const Simulation simulation = samples::shaken_tank(model, 2).simulate();
    const samples::Rates expected = samples::reference_rates(simulation.fluid(), simulation.walls(), model,
                                                             simulation.particle_spacing());
    std::vector<double> found_values, expected_values;
    const auto collect = [](const std::vector<WallMean>& means, double WallMean::*member,
                            std::vector<double>& out) {
        out.clear();
        for (const WallMean& mean : means) out.push_back(mean.*member);
    };
    for (const auto member : {&WallMean::pressure, &WallMean::vx, &WallMean::vy}) {
        collect(simulation.walls().mean, member, found_values);
        collect(expected.wall, member, expected_values);
        REQUIRE(largest(expected_values) > 1);
        CHECK(samples::difference(found_values, expected_values, 0, found_values.size()) < 1e-11);
    }
}

TEST_CASE("A pair of particles pushes each other with opposite forces", "[pairs]") {
    const Ingredient& ingredient = GENERATE(from_range(ingredients()));
    INFO(ingredient.name);
    const samples::Setup setup = samples::shaken_blob(with(ingredient), 3);
    const Simulation simulation = setup.simulate();
    const FluidParticles& fluid = simulation.fluid();
    std::size_t touching = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 on_j = samples::reference_pair_force(fluid, i, j, setup.model, setup.particle_spacing);
            const Vec2 on_i = samples::reference_pair_force(fluid, j, i, setup.model, setup.particle_spacing);
            if (on_j.norm() == 0) continue;
            ++touching;
            if ((on_i + on_j).norm() > 1e-13 * on_j.norm()) FAIL_CHECK("pair " << i << ", " << j);
        }
    }
    CHECK(touching > 2000);
}

TEST_CASE("Two particles alone get opposite momentum from the fast loop, whatever their phases",
          "[simd][pairs]") {
    const std::string name = GENERATE(from_range(samples::instruction_sets()));
    const Ingredient& ingredient = GENERATE(from_range(ingredients()));
    INFO(name << ", " << ingredient.name);
    const samples::ChosenInstructionSet chosen(name);
    samples::Setup setup(with(ingredient), Box{{-1, -1}, {1, 1}}, 0.05);
    setup.model.gravity = Vec2::Zero();
    setup.fluid.add(Phase::water, {0, 0}, 2.5, 1001);
    const Phase other = GENERATE(Phase::water, Phase::air);
    setup.fluid.add(other, {0.03, 0.02}, other == Phase::water ? 2.4 : 0.0025,
                    other == Phase::water ? 1002 : 1.1);
    setup.fluid.state[0].vx = 2;
    setup.fluid.state[1].vy = -1;
    setup.fluid.state[1].impact = 1;
    const FluidParticles fluid = setup.simulate().fluid();
    const auto force = [&](std::size_t i) {
        return Vec2(fluid.mass[i] * Vec2(fluid.acceleration_x[i], fluid.acceleration_y[i]));
    };
    REQUIRE(force(0).norm() > 1);
    CHECK((force(0) + force(1)).norm() < 1e-13 * force(0).norm());
}

TEST_CASE("An instruction set that does not exist is refused by name", "[simd]") {
    CHECK_THROWS_AS(pair_passes(two_phase_model(), "mmx"), InputError);
    CHECK_THROWS_WITH(pair_passes(two_phase_model(), "mmx"),
                      Catch::Contains("'mmx'") && Catch::Contains("avx2"));
    const samples::ChosenInstructionSet chosen("neon");
    CHECK_THROWS_WITH(samples::shaken_tank(two_phase_model(), 1).simulate(), Catch::Contains("'neon'"));
}
