// SPDX-License-Identifier: BSD-3-Clause
// The skin of the neighbour list that a run chooses.
#include "solver/neighbours/skin_choice.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

/// The skin after many lists, each of which serves `per_skin` steps a smoothing length of its skin.
SkinChoice settled(double per_skin) {
    SkinChoice choice;
    for (int list = 0; list < 100; ++list) {
        choice.served = per_skin * choice.skin;
        choice.end_of_list();
    }
    return choice;
}

/// What pairs and list cost a step beyond the pairs without a skin, over cost_ratio times a.
double cost(double skin, double per_skin) {
    return skin / SkinChoice::cost_ratio + 1 / (per_skin * skin);
}

/// Water and air in a tank, stirred at a share of the speed of sound.
samples::Setup stirred(double share) {
    samples::Setup setup = samples::shaken_tank(samples::two_phase_model(), 3);
    const double speed = share * setup.model.air.eos.sound_speed;
    for (FluidState& p : setup.fluid.state) {
        p.vx = speed * std::sin(7 * p.y);
        p.vy = speed * std::cos(7 * p.x);
    }
    return setup;
}

double skin_after(Simulation& simulation, int steps) {
    for (int n = 0; n < steps; ++n) REQUIRE_FALSE(simulation.step(1));
    return simulation.state().numbers.at("list_skin");
}

}  // namespace

TEST_CASE("The chosen skin is the one at which lists and pairs cost least", "[neighbours]") {
    const double per_skin = GENERATE(12.0, 40.0, 150.0, 700.0);
    const double skin = settled(per_skin).skin;
    CHECK(cost(skin, per_skin) < cost(0.9 * skin, per_skin));
    CHECK(cost(skin, per_skin) < cost(1.1 * skin, per_skin));
}

TEST_CASE("The chosen skin keeps its range", "[neighbours]") {
    CHECK(settled(0.5).skin == SkinChoice::largest);
    CHECK(settled(1e6).skin == SkinChoice::least);
    SkinChoice at_once;
    at_once.end_of_list();  // that has served no step
    CHECK(at_once.is_sound());
}

TEST_CASE("The chosen skin follows a motion that changes within a few lists", "[neighbours]") {
    SkinChoice choice = settled(500);
    for (int list = 0; list < 8; ++list) {
        choice.served = 20 * choice.skin;
        choice.end_of_list();
    }
    CHECK(choice.skin > 0.8 * settled(20).skin);
}

TEST_CASE("A fast flow gets a thicker skin than a slow one, and a given skin is kept",
          "[neighbours][simulation]") {
    Simulation slow = stirred(0.01).simulate(), fast = stirred(0.3).simulate();
    const double of_slow = skin_after(slow, 30), of_fast = skin_after(fast, 30);
    INFO(of_slow << ", " << of_fast);
    CHECK(of_fast > 1.5 * of_slow);

    samples::Setup thin = stirred(0.3);
    thin.execution.skin = 0.1;
    Simulation often = thin.simulate();
    skin_after(often, 30);
    CHECK(often.neighbours().skin() == Approx(0.1 * often.kernel().smoothing_length));
    CHECK(often.list_builds() > 2 * fast.list_builds());
}
