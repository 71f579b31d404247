// SPDX-License-Identifier: BSD-3-Clause
// Symmetries of the rates: observers that move, mirrors, rotations, the order in which particles are given.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <numeric>
#include <random>

#include "tests/support/samples.hpp"

using namespace wetdeck;
using samples::Setup;
using samples::two_phase_model;

namespace {

/// Sums run in another order and differences of velocities round anew: some 30 terms, of either sign.
constexpr double rounding = 1e-11;

/// The set-up under a linear map of the plane that keeps lengths (mirror, rotation), gravity, walls and all.
Setup mapped(Setup setup, const Eigen::Matrix2d& map) {
    const auto apply = [&](double& x, double& y) {
        const Vec2 image = map * Vec2(x, y);
        x = image.x();
        y = image.y();
    };
    for (FluidState& p : setup.fluid.state) {
        apply(p.x, p.y);
        apply(p.vx, p.vy);
    }
    for (WallState& w : setup.walls.state) {
        apply(w.x, w.y);
        apply(w.vx, w.vy);
        apply(w.nx, w.ny);
        apply(w.ax, w.ay);
    }
    setup.model.gravity = map * setup.model.gravity;
    const Vec2 low = map * setup.domain.low, high = map * setup.domain.high;
    setup.domain = {low.cwiseMin(high), low.cwiseMax(high)};
    return setup;
}

/// Rates of `simulation` mapped, compared with those of the mapped set-up.
double map_difference(const Setup& setup, const Eigen::Matrix2d& map) {
    Simulation original = setup.simulate();
    FluidParticles& fluid = original.disturb();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const Vec2 image = map * Vec2(fluid.acceleration_x[i], fluid.acceleration_y[i]);
        fluid.acceleration_x[i] = image.x();
        fluid.acceleration_y[i] = image.y();
    }
    return samples::rate_difference(original, mapped(setup, map).simulate());
}

Setup moved(Setup setup, Vec2 velocity) {
    for (FluidState& p : setup.fluid.state) {
        p.vx += velocity.x();
        p.vy += velocity.y();
    }
    for (WallState& w : setup.walls.state) {
        w.vx += velocity.x();
        w.vy += velocity.y();
    }
    return setup;
}

}  // namespace

TEST_CASE("Rates are the same for an observer who moves", "[symmetry]") {
    Model model = two_phase_model();
    model.water.viscosity = 20;
    model.air.viscosity = 0.5;
    model.viscosity = GENERATE(Viscosity::none, Viscosity::symmetric);
    model.wall_slip = GENERATE(WallSlip::free, WallSlip::no);
    const Setup setup = samples::shaken_tank(model, 21);
    CHECK(samples::rate_difference(setup.simulate(), moved(setup, {40, -25}).simulate()) < rounding);
}

TEST_CASE("The paper's harmonic mean of velocities gives a moving observer other rates", "[symmetry]") {
    Model model = two_phase_model();
    model.velocity_mean = Mean::harmonic;
    const Setup setup = samples::shaken_tank(model, 21);
    CHECK(samples::rate_difference(setup.simulate(), moved(setup, {40, -25}).simulate()) > 0.01);
}

TEST_CASE("The paper's dissipation switch gives a moving observer other rates", "[symmetry]") {
    Model model = two_phase_model();
    model.dissipation_switch = true;  // its strength is the speed itself, Eq. (14)
    const Setup setup = samples::shaken_tank(model, 21);
    CHECK(samples::rate_difference(setup.simulate(), moved(setup, {40, -25}).simulate()) > 0.01);
}

TEST_CASE("Rates of a mirrored or rotated tank are the mirrored or rotated rates", "[symmetry]") {
    const Model model = GENERATE(two_phase_model(), samples::paper_model());
    const auto matrix = [](double a, double b, double c, double d) {
        Eigen::Matrix2d m;
        m << a, b, c, d;
        return m;
    };
    const Eigen::Matrix2d mirror = matrix(-1, 0, 0, 1), quarter_turn = matrix(0, -1, 1, 0),
                          half_turn = matrix(-1, 0, 0, -1);
    const Setup setup = samples::shaken_tank(model, 22);
    CHECK(map_difference(setup, mirror) < rounding);
    CHECK(map_difference(setup, quarter_turn) < rounding);
    CHECK(map_difference(setup, half_turn) < rounding);
}

TEST_CASE("Gravity that does not turn with the tank shows, so the rotation test can fail", "[symmetry]") {
    const Setup setup = samples::shaken_tank(two_phase_model(), 22);
    Setup turned = setup;
    turned.model.gravity = {9.81, 0};
    CHECK(samples::rate_difference(setup.simulate(), turned.simulate()) > 1e-4);
}

TEST_CASE("Rates do not depend on the order in which particles are given", "[symmetry]") {
    const Setup setup = samples::shaken_tank(two_phase_model(), 23);
    Setup shuffled = setup;
    std::vector<std::size_t> order(setup.fluid.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937_64 engine(5);
    const auto air = order.begin() + static_cast<std::ptrdiff_t>(setup.fluid.water);
    std::shuffle(order.begin(), air, engine);
    std::shuffle(air, order.end(), engine);
    for (std::size_t i = 0; i < order.size(); ++i) {
        shuffled.fluid.state[i] = setup.fluid.state[order[i]];
        shuffled.fluid.mass[i] = setup.fluid.mass[order[i]];
        shuffled.fluid.id[i] = setup.fluid.id[order[i]];
    }
    std::reverse(shuffled.walls.state.begin(), shuffled.walls.state.end());
    CHECK(samples::rate_difference(setup.simulate(), shuffled.simulate()) < rounding);
}

TEST_CASE("Rates do not depend on where the tank stands", "[symmetry]") {
    const Setup setup = samples::shaken_tank(two_phase_model(), 24);
    Setup elsewhere = setup;
    const Vec2 shift(17.25, -3.5);
    const auto move = [&](auto& particle) {
        particle.x += shift.x();
        particle.y += shift.y();
    };
    for (FluidState& p : elsewhere.fluid.state) move(p);
    for (WallState& w : elsewhere.walls.state) move(w);
    elsewhere.domain = {setup.domain.low + shift, setup.domain.high + shift};
    // coordinates near 17 hold two digits fewer than those near 0.1
    CHECK(samples::rate_difference(setup.simulate(), elsewhere.simulate()) < 100 * rounding);
}
