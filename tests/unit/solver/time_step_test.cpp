// SPDX-License-Identifier: BSD-3-Clause
// The stable time step: each criterion by hand.
#include "solver/time/time_step.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/core/errors.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {
constexpr double h = 0.025;
}

TEST_CASE("Sound in air limits a step in two phases, sound in water without air", "[time]") {
    const Model model = samples::two_phase_model();  // 30 and 90 m/s, Courant number 0.5
    const TimeStep both = stable_time_step(model, h, {{2, 10}}, true, true);
    CHECK(both.criterion == LimitingCriterion::acoustic_air);
    CHECK(both.size == Approx(0.5 * 0.025 / 100));
    const TimeStep water = stable_time_step(model, h, {{2, 10}}, true, false);
    CHECK(water.criterion == LimitingCriterion::acoustic_water);
    CHECK(water.size == Approx(0.5 * 0.025 / 32));
    const TimeStep air = stable_time_step(model, h, {{2, 10}}, false, true);
    CHECK(air.size == both.size);
}

TEST_CASE("Water limits the step where it is the faster of both", "[time]") {
    const TimeStep step = stable_time_step(samples::two_phase_model(), h, {{80, 10}}, true, true);
    CHECK(step.criterion == LimitingCriterion::acoustic_water);
    CHECK(step.size == Approx(0.5 * 0.025 / 110));
}

TEST_CASE("Viscosity limits the step by rho h^2 / (8 mu), where the model has it", "[time]") {
    Model model = samples::two_phase_model();
    model.air.viscosity = 2;
    CHECK(stable_time_step(model, h, {}, true, true).criterion == LimitingCriterion::acoustic_air);
    model.viscosity = GENERATE(Viscosity::approaching, Viscosity::symmetric);
    const TimeStep step = stable_time_step(model, h, {}, true, true);
    CHECK(step.criterion == LimitingCriterion::viscous);
    CHECK(step.size == Approx(0.125 * 1 * 0.025 * 0.025 / 2));
    CHECK(stable_time_step(model, h, {}, true, false).criterion == LimitingCriterion::acoustic_water);
}

TEST_CASE("Gravity limits the step by sqrt(h/g) / 4", "[time]") {
    Model model = samples::two_phase_model();
    model.gravity = {-3e5, 4e5};
    const TimeStep step = stable_time_step(model, h, {}, true, true);
    CHECK(step.criterion == LimitingCriterion::force);
    CHECK(step.size == Approx(0.25 * std::sqrt(0.025 / 5e5)));
}

TEST_CASE("Diffusion of density limits the step of fluid that is strongly compressed", "[time]") {
    Model model = samples::two_phase_model();
    const double c = 30 * std::pow(1.2, 3);  // gamma = 7
    const TimeStep step = stable_time_step(model, h, {{}, {1.2, 1}}, true, false);
    CHECK(step.criterion == LimitingCriterion::diffusion);
    CHECK(step.size == Approx(0.7 * 0.025 * 30 / (c * c)));
    model.pressure_diffusion = 2;  // at rest, 0.35 h / c is less than 0.5 h / c
    CHECK(stable_time_step(model, h, {}, true, false).size == Approx(0.35 * 0.025 / 30));
    model.pressure_diffusion = 0;
    const TimeStep acoustic = stable_time_step(model, h, {{}, {1.2, 1}}, true, false);
    CHECK(acoustic.criterion == LimitingCriterion::acoustic_water);
    CHECK(acoustic.size == Approx(0.5 * 0.025 / c));
}

TEST_CASE("The acoustic step is proportional to the Courant number", "[time]") {
    Model model = samples::two_phase_model();
    const double half = stable_time_step(model, h, {}, true, true).size;
    model.courant_number = 0.25;
    CHECK(stable_time_step(model, h, {}, true, true).size == Approx(0.5 * half));
}

TEST_CASE("Steps of the air make a step of the water, which has its own limit", "[time]") {
    Model model = samples::two_phase_model();
    model.air_substeps = 5;
    const TimeStep air = stable_time_step(model, h, {{2, 10}}, true, true);
    CHECK(air.criterion == LimitingCriterion::acoustic_water);  // 5 / 100 is more than 1 / 32
    CHECK(air.size == Approx(0.5 * 0.025 / 32));
    const TimeStep fast_air = stable_time_step(model, h, {{2, 100}}, true, true);
    CHECK(fast_air.criterion == LimitingCriterion::acoustic_air);
    CHECK(fast_air.size == Approx(5 * 0.5 * 0.025 / 190));
    CHECK(stable_time_step(model, h, {{2, 100}}, false, true).size == Approx(0.5 * 0.025 / 190));
}

TEST_CASE("The air takes as many steps in one of the water as the sound speeds allow", "[time]") {
    Model model = samples::two_phase_model();
    model.air_substeps = 0;
    const auto with_air = [&](double sound_speed) {
        model.air.eos.sound_speed = sound_speed;
        return air_substeps(model);
    };
    CHECK(with_air(20) == 1);
    CHECK(with_air(3 * 1.5 * 30 - 1) == 1);
    CHECK(with_air(3 * 1.5 * 30 + 1) == 3);
    CHECK(with_air(5 * 1.5 * 30 + 1) == 5);
    CHECK(with_air(1e5) == 15);
    model.dissipation_switch = true;
    CHECK(air_substeps(model) == 1);
    model.air_substeps = 3;
    CHECK_THROWS_AS(air_substeps(model), InputError);
    model.dissipation_switch = false;
    CHECK(air_substeps(model) == 3);
    model.air_substeps = GENERATE(-1, 2, 4);
    CHECK_THROWS_AS(air_substeps(model), InputError);
}

TEST_CASE("Fine water takes as many steps in one of coarse water as leave the fewest particle-steps",
          "[time]") {
    Model model = samples::two_phase_model();
    model.coarse_substeps = 0;
    const auto with_coarse = [&](double fineness, std::size_t of_hundred) {
        std::vector<double> finenesses(100, 1.0);
        std::fill_n(finenesses.begin(), of_hundred, fineness);
        return coarse_substeps(model, finenesses);
    };
    CHECK(with_coarse(0.5, 100) == 1);
    CHECK(with_coarse(0.25, 50) == 3);
    CHECK(with_coarse(0.2, 50) == 5);
    CHECK(with_coarse(0.125, 50) == 7);
    CHECK(with_coarse(0.25, 16) == 3);  // 100 - 16 + 16/3 < 90
    CHECK(with_coarse(0.25, 14) == 1);
    model.dissipation_switch = true;
    CHECK(with_coarse(0.25, 50) == 1);
    model.coarse_substeps = 3;
    CHECK_THROWS_AS(with_coarse(0.25, 50), InputError);
    model.dissipation_switch = false;
    CHECK(with_coarse(1, 0) == 3);
    model.coarse_substeps = GENERATE(-1, 2, 4);
    CHECK_THROWS_AS(with_coarse(0.25, 50), InputError);
}

TEST_CASE("Coarse water lengthens the step, by its weight less than by its sound", "[time]") {
    Model model = samples::two_phase_model();
    const auto step = [&](int substeps) { return stable_time_step(model, h, {}, true, false, substeps); };
    CHECK(step(3).size == Approx(3 * step(1).size));
    model.gravity.y() = -1e4;  // 0.25 sqrt(h / g)
    REQUIRE(step(1).criterion == LimitingCriterion::force);
    REQUIRE(step(3).criterion == LimitingCriterion::force);
    CHECK(step(3).size == Approx(std::sqrt(3.0) * step(1).size));
}

TEST_CASE("Every criterion has its name", "[time]") {
    CHECK(limiting_criterion_names[static_cast<std::size_t>(LimitingCriterion::acoustic_water)] ==
          std::string("acoustic_water"));
    CHECK(limiting_criterion_names[static_cast<std::size_t>(LimitingCriterion::acoustic_air)] ==
          std::string("acoustic_air"));
    CHECK(limiting_criterion_names[static_cast<std::size_t>(LimitingCriterion::viscous)] ==
          std::string("viscous"));
    CHECK(limiting_criterion_names[static_cast<std::size_t>(LimitingCriterion::force)] ==
          std::string("force"));
}

TEST_CASE("A fixed step is taken whatever the criteria say, and counted as within or beyond them", "[time]") {
    Model model = samples::two_phase_model();
    samples::Setup setup = samples::shaken_tank(model, 5);
    const double stable = setup.simulate().time_step().size;
    setup.model.fixed_step = 0.4 * stable;
    Simulation small = setup.simulate();
    CHECK_FALSE(small.step(1));
    CHECK(small.time() == setup.model.fixed_step);
    CHECK(small.limiting_counts()[static_cast<std::size_t>(LimitingCriterion::fixed)] == 1);
    CHECK_FALSE(small.step(0.1 * stable));  // the end of a run comes first
    CHECK(small.time() == Approx(0.5 * stable));
    setup.model.fixed_step = 1.2 * stable;
    Simulation large = setup.simulate();
    CHECK(large.time_step().size == setup.model.fixed_step);
    CHECK(large.time_step().criterion == LimitingCriterion::fixed_beyond);
    CHECK_FALSE(large.step(1));
    CHECK(large.limiting_counts()[static_cast<std::size_t>(LimitingCriterion::fixed_beyond)] == 1);
}
