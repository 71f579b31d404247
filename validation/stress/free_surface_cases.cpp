// SPDX-License-Identifier: BSD-3-Clause
// Water that meets water, air or a roof, and water at rest for long.
#include <fmt/format.h>

#include <cmath>

#include "solver/setup/initial_pressure.hpp"
#include "validation/scene/schemes.hpp"
#include "validation/scene/trapped_air.hpp"
#include "validation/stress/cases.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::stress {
namespace {

using namespace verification;

constexpr double gravity = 9.81;

/// Jets of unit speed, 0.8 m long, the second shifted sideways.
Trial jets(const Scheme& scheme, double mach, double shift, bool air) {
    constexpr double dx = 0.02, thickness = 0.2, from = 0.1, to = 0.9, half_width = 1.2, half_height = 1;
    Model model = air ? two_phase_model(1 / mach, 10 / mach, 1000 * 0.25 / mach) : water_model(1 / mach);
    model.negative_pressure = air;
    apply_scheme(scheme, model);
    Setup setup(model, {{-half_width, -half_height}, {half_width, half_height}}, dx, true);
    const double first = 0, second = shift;
    setup.fill(Phase::water, {{-to, first}, {-from, first + thickness}});
    setup.fill(Phase::water, {{from, second}, {to, second + thickness}});
    if (air) {
        for (const auto& [low, high] : {std::pair(-half_width, -to), {-from, from}, {to, half_width}})
            setup.fill(Phase::air, {{low, -half_height}, {high, half_height}});
        for (const auto& [low, high, level] : {std::tuple(-to, -from, first), {from, to, second}}) {
            setup.fill(Phase::air, {{low, -half_height}, {high, level}});
            setup.fill(Phase::air, {{low, level + thickness}, {high, half_height}});
        }
    }
    for (std::size_t i = 0; i < setup.fluid.water; ++i)
        setup.fluid.state[i].vx = setup.fluid.state[i].x < 0 ? 1 : -1;
    return Trial{setup.simulate(), 0.6};
}

/// Half a metre of water above 0.3 m of air in a closed shaft, air above it.
struct FallingColumn {
    static constexpr double width = 0.5, bottom = 0.3, top = 0.8, roof = 1.2;
    double speed, air_sound_speed;

    Model model() const { return two_phase_model(100, air_sound_speed, 2000, gravity); }

    Trial trial(const Scheme& scheme) const {
        Model changed = model();
        apply_scheme(scheme, changed);
        Setup setup(changed, {{0, 0}, {width, roof}}, 0.02, true);
        setup.fill(Phase::water, {{0, bottom}, {width, top}});
        setup.fill(Phase::air, {{0, 0}, {width, bottom}});
        setup.fill(Phase::air, {{0, top}, {width, roof}});
        for (FluidState& p : setup.fluid.state)  // the air is pressed and drawn out evenly
            p.vy = -speed * std::min({1.0, p.y / bottom, (roof - p.y) / (roof - top)});
        return Trial{setup.simulate(), 0.15};
    }

    /// By the balance of energy that `wetdeck check` makes.
    std::string beyond() const {
        const TaitEquationOfState air = model().air.eos;
        const double mass = water_density * (top - bottom);
        const double share = squeezed_share(mass * gravity, air.coefficient(), air.exponent,
                                            0.5 * mass * speed * speed / bottom);
        if (share >= least_squeezed_share) return {};
        return fmt::format(
            "the water squeezes the air to {:.2g} of its volume, below the third that `check` asks for",
            share);
    }
};

struct Levels {
    double left, right;
};

/// A closed tank of 1 m by 0.6 m with water at two levels and hydrostatic pressure.
Trial tank(const Scheme& scheme, double dx, Levels levels, Trial (*finish)(const Setup&)) {
    constexpr double width = 1, roof = 0.6;
    const double sound_speed = 10 * std::sqrt(gravity * levels.left);
    Model model = two_phase_model(sound_speed, 5.6 * sound_speed, 500 * levels.left, gravity);
    apply_scheme(scheme, model);
    Setup setup(model, {{0, 0}, {width, roof}}, dx, true);
    const Box halves[] = {{{0, 0}, {0.5 * width, levels.left}}, {{0.5 * width, 0}, {width, levels.right}}};
    for (const Box& half : halves) setup.fill(Phase::water, half);
    for (const Box& half : halves)
        setup.fill(Phase::air, {{half.low.x(), half.high.y()}, {half.high.x(), roof}});
    set_initial_pressure(setup.fluid, setup.model, [&](Phase phase, Vec2 at) {
        const double level = at.x() < 0.5 * width ? levels.left : levels.right;
        if (phase == Phase::air) return air_density * gravity * (roof - at.y());
        return air_density * gravity * (roof - level) + water_density * gravity * (level - at.y());
    });
    return finish(setup);
}

Trial sloshing(const Scheme& scheme, Levels levels) {
    return tank(scheme, 0.02, levels, [](const Setup& setup) { return Trial{setup.simulate(), 1.5}; });
}

template <std::uint64_t steps>
Trial still_water(const Scheme& scheme) {
    return tank(scheme, 0.05, {0.3, 0.3}, [](const Setup& setup) {
        Trial trial{setup.simulate()};
        trial.most_steps = steps;
        return trial;
    });
}

/// Without the pressure that balances its rotation: it must find it.
Trial square_patch(const Scheme& scheme, double end, bool air) {
    constexpr double side = 1, rotation = 1, dx = 0.04, sound_speed = 10;
    Model model = air ? two_phase_model(sound_speed, 60, 250) : water_model(sound_speed);
    apply_scheme(scheme, model);
    constexpr double half = 0.5 * side, far = 1.5;
    Setup setup(model, {{-far, -far}, {far, far}}, dx, true);
    const Box square = {{-half, -half}, {half, half}};
    setup.fill(Phase::water, square);
    if (air) setup.fill_around(Phase::air, square);
    setup.spin_water(rotation);
    return Trial{setup.simulate(), end};
}

}  // namespace

std::vector<Case> free_surface_cases() {
    const auto jet = [](std::string name, double mach, double shift, bool air, bool quick = false) {
        return Setting{std::move(name), [=](const Scheme& s) { return jets(s, mach, shift, air); }, quick};
    };
    const auto column = [](double speed, double air) {
        const FallingColumn falling{speed, air};
        return Setting{fmt::format("{:g} m/s on air of {:g} m/s", speed, air),
                       [=](const Scheme& s) { return falling.trial(s); }, speed == 5 && air > 300,
                       falling.beyond()};
    };
    const auto slosh = [](std::string name, Levels levels) {
        return Setting{std::move(name), [=](const Scheme& s) { return sloshing(s, levels); }};
    };
    const auto patch = [](std::string name, double end, bool air) {
        return Setting{std::move(name), [=](const Scheme& s) { return square_patch(s, end, air); }};
    };
    Setting supersonic = jet("Mach 0.5, no air", 0.5, 0, false);
    supersonic.beyond = "weakly compressible water needs a Mach number well below 0.3";
    return {{"colliding_jets",
             "two jets of 0.2 m, speed over the sound speed",
             {jet("Mach 0.05, no air", 0.05, 0, false), jet("Mach 0.1, no air", 0.1, 0, false, true),
              jet("Mach 0.1, shifted by half, no air", 0.1, 0.1, false), supersonic,
              jet("Mach 0.05, in air", 0.05, 0, true), jet("Mach 0.1, in air", 0.1, 0, true)}},
            {"falling_column",
             "column of water falling on trapped air",
             {column(0, 340), column(5, 340), column(10, 340), column(5, 170), column(8, 170)}},
            {"sloshing",
             "two levels in a low tank: impact on wall and roof around a pocket of air",
             {slosh("half full", {0.5, 0.2}), slosh("nearly full", {0.56, 0.4})}},
            {"square_patch",
             "rotating square started without pressure",
             {patch("omega t = 2, no air", 2, false), patch("omega t = 4, no air", 4, false),
              patch("omega t = 2, in air", 2, true)}},
            {"still_water",
             "water at rest under air",
             {{"1e4 steps", still_water<10'000>, true}, {"1e5 steps", still_water<100'000>}}}};
}

}  // namespace wetdeck::stress
