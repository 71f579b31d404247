// SPDX-License-Identifier: BSD-3-Clause
// A domain that is periodic along x knows no place where it begins.
#include <catch2/catch.hpp>
#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/setup/lattice.hpp"
#include "tests/support/restored_run.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

constexpr double spacing = 0.05, period = 0.6, tank_height = 0.5;

double wrapped(double x) {
    return x - period * std::floor(x / period);
}

/// Water below air between bed and lid, shaken, each with a motion of its own; all of it `shift` further
/// along.
samples::Setup channel(double shift, Model model = samples::two_phase_model()) {
    model.periodic_x = true;
    model.gravity = {0.7, -9.81};
    samples::Setup setup(model, {{0, 0}, {period, tank_height}}, spacing);
    setup.walls = tank_walls(setup.domain, spacing, 2 * model.smoothing_ratio * spacing, model.ends());
    fill_box(setup.fluid, Phase::water, {{0, 0}, {period, 0.3}}, spacing, 1000);
    fill_box(setup.fluid, Phase::air, {{0, 0.3}, {period, tank_height}}, spacing, 1);
    for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
        FluidState& p = setup.fluid.state[i];
        const auto wave = [&](double n) { return std::sin(n * static_cast<double>(i + 1)); };
        p.x = wrapped(p.x + 0.2 * spacing * wave(1) + shift);
        p.y += 0.2 * spacing * wave(2);
        p.vx = wave(3);
        p.vy = wave(4);
        p.density *= 1 + 0.01 * wave(5);
    }
    return setup;
}

}  // namespace

TEST_CASE("Rates do not depend on where the ends of a periodic domain are", "[periodic]") {
    Model model = samples::two_phase_model();
    model.wall_slip = GENERATE(WallSlip::free, WallSlip::no);
    model.viscosity = Viscosity::symmetric;
    model.water.viscosity = 2;
    model.air.viscosity = 0.1;
    // whole columns, so that the walls' particles stand where they stood
    const int columns = GENERATE(1, 3, 6, 11);
    const Simulation here = channel(0, model).simulate(),
                     there = channel(columns * spacing, model).simulate();
    CHECK(samples::rate_difference(here, there) < 1e-10);
    CHECK(here.momentum_error() < 1e-13);
    CHECK(there.momentum_error() < 1e-13);
}

TEST_CASE("A periodic domain three times as long with the same in it thrice has the same rates",
          "[periodic]") {
    const samples::Setup one = channel(0);
    samples::Setup three = one;
    three.domain.high.x() = 3 * period;
    three.walls =
        tank_walls(three.domain, spacing, 2 * one.model.smoothing_ratio * spacing, DomainEnds::periodic);
    three.fluid = {};
    for (const Phase phase : {Phase::water, Phase::air}) {
        for (int copy = 0; copy < 3; ++copy) {
            for (std::size_t i = 0; i < one.fluid.size(); ++i) {
                if (one.fluid.phase(i) != phase) continue;
                three.fluid.add(phase, one.fluid.state[i].position(), one.fluid.mass[i], 1);
                FluidState& p = three.fluid.state.back();
                p = one.fluid.state[i];
                p.x += copy * period;
            }
        }
    }
    const Simulation a = one.simulate(), b = three.simulate();
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < b.fluid().size(); ++i) {
        const Vec2 at = b.fluid().state[i].position();
        const Vec2 rate(b.fluid().acceleration_x[i], b.fluid().acceleration_y[i]);
        double nearest = 1e300;
        Vec2 same = Vec2::Zero();
        for (std::size_t k = 0; k < a.fluid().size(); ++k) {
            Vec2 apart = a.fluid().state[k].position() - at;
            apart.x() -= period * std::round(apart.x() / period);
            if (apart.norm() >= nearest) continue;
            nearest = apart.norm();
            same = {a.fluid().acceleration_x[k], a.fluid().acceleration_y[k]};
        }
        REQUIRE(nearest < 1e-12);
        worst = std::max(worst, (rate - same).norm());
        largest = std::max(largest, rate.norm());
    }
    CHECK(worst < 1e-9 * largest);
}

TEST_CASE("A fluid that flows through the seam moves as it does at rest", "[periodic]") {
    samples::Setup still = channel(0);
    still.walls = {};  // they would not come along
    still.execution.skin = 0.2;
    still.model.gravity = Vec2::Zero();
    still.model.water.eos.background_pressure = still.model.air.eos.background_pressure = 0;
    samples::Setup flowing = still;
    const double speed = 15, step = 2e-4;  // below the stable step of both
    for (FluidState& p : flowing.fluid.state) p.vx += speed;
    Simulation a = still.simulate(), b = flowing.simulate();
    while (a.time() < 1.2 * period / speed) {
        REQUIRE_FALSE(a.step(step));
        REQUIRE_FALSE(b.step(step));
    }
    REQUIRE(a.steps() == b.steps());
    const std::vector<FluidState> at_rest = samples::by_id(a.fluid()), moved = samples::by_id(b.fluid());
    double worst = 0, bent = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        Vec2 apart = moved[i].position() - at_rest[i].position() - Vec2(speed * a.time(), 0);
        apart.x() -= period * std::round(apart.x() / period);
        worst = std::max(worst, apart.norm());
        bent = std::max(bent, std::abs(at_rest[i].vy - still.fluid.state[i].vy));
        CHECK(std::abs(moved[i].x - 0.5 * period) < 0.5 * period + 2 * still.execution.skin * spacing);
    }
    CHECK(worst < 1e-8 * spacing);
    CHECK(bent > 0.1);  // forces have been at work
}

TEST_CASE("A periodic simulation restored between two builds of its list goes on with the same bits",
          "[periodic]") {
    Model model = samples::two_phase_model();
    model.air_substeps = GENERATE(1, 3);
    samples::check_restored_run(channel(0, model), 50);
}

TEST_CASE("What a periodic domain cannot have is refused", "[periodic]") {
    samples::Setup setup = channel(0);
    SECTION("a sponge layer") {
        setup.model.sponge_thickness = 0.1;
    }
    SECTION("less room than two supports") {
        setup.domain.high.x() = 0.25;
    }
    SECTION("a body") {
        setup.bodies.resize(1);
        setup.bodies[0].free = {false, false, false};
    }
    CHECK_THROWS_AS(setup.simulate(), InputError);
}

TEST_CASE("Bed and lid of a periodic tank run on beyond its ends", "[periodic]") {
    const Box tank{{0, 0}, {1, 0.5}};
    const WallParticles walls = tank_walls(tank, 0.05, 0.125, DomainEnds::periodic);
    CHECK(walls.size() == 2 * 3 * (20 + 6));
    for (const WallState& w : walls.state) {
        CHECK((w.y < 0 || w.y > 0.5));
        CHECK(w.nx == 0);
        CHECK(w.ny == (w.y < 0 ? 1 : -1));
    }
}
