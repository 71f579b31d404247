// SPDX-License-Identifier: BSD-3-Clause
// Sound in the sponge layer of Eqs. (24)-(25). Both rates are multiplied by the same f(l), l the
// distance from the wall, so that the impedance is the same everywhere and nothing is reflected on the way;
// the wave only slows down to c f. With f = 1 - e^(-k l), k = 50 ln(1/0.9) / s, it takes
//     INT_d^s dl / (c f) = [ln(e^(k s) - 1) - ln(e^(k d) - 1)] / (c k)
// to within d of the wall: for ever to the wall itself, but not to the last particle, half a spacing from it.
// There it turns.
#include <cmath>
#include <numbers>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/numerics.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double sound_speed = 30;
constexpr double scale = 1e-4 * water_density * sound_speed * sound_speed;  // [Pa]; squares do not matter
constexpr double length = 2, height = 0.12, thickness = 0.4;
constexpr double start = 1, half_width = 0.1;
constexpr double way = 2 * (length - start) + 0.6;  // that sound goes in the time computed

/// By how much longer than through open water sound is on its way to the last particle and back, times c.
double detour(double spacing) {
    const double k = 50 * std::log(1 / 0.9) / thickness, last = 0.5 * spacing;
    const double slowed = (std::log(std::expm1(k * thickness)) - std::log(std::expm1(k * last))) / k;
    return 2 * (slowed - (thickness - last));
}

Simulation channel(double spacing, bool with_sponge) {
    Model model = water_model(sound_speed);
    if (with_sponge) model.sponge_thickness = thickness;
    Setup setup(model, {{0, 0}, {length, height}}, spacing, true);
    setup.fill(Phase::water, {{0, 0}, {length, height}});
    // the layer lies along the ends only
    setup.domain.low -= Vec2(thickness, thickness);
    setup.domain.high.y() += thickness;
    set_initial_pressure(setup.fluid, model, [&](Phase, Vec2 at) {
        return scale * std::exp(-std::pow((at.x() - start) / half_width, 2));
    });
    for (FluidState& p : setup.fluid.state) p.vx = p.pressure / (water_density * sound_speed);
    return setup.simulate();
}

struct Returned {
    double share = 0;   ///< of the incident pulse's area, in open water
    double centre = 0;  ///< position along the channel [m]
    Curve pressure;
};

Returned returned(double spacing, bool with_sponge) {
    Simulation simulation = channel(spacing, with_sponge);
    advance(simulation, way / sound_speed);
    Returned result;
    double moment = 0;
    std::vector<std::pair<double, double>> row;
    for (const FluidState& p : simulation.fluid().state) {
        if (std::abs(p.y - 0.5 * height) < 0.9 * spacing && p.y > 0.5 * height)
            row.emplace_back(p.x, p.pressure / scale);
        if (p.x > length - thickness) continue;
        const double share =
            p.pressure * p.volume / (height * scale * half_width * std::sqrt(std::numbers::pi));
        result.share += share;
        moment += share * p.x;
    }
    result.centre = moment / result.share;
    result.pressure = sorted_curve(row);
    return result;
}

void run(Findings& findings) {
    VerificationFigure figure{"Sound pulse after its return from a sponge layer",
                              "distance from the left end",
                              "m",
                              "pressure over the incident amplitude",
                              "-",
                              {},
                              {}};
    double finest = 0;
    for (const double dx : findings.levels({1.0 / 50, 1.0 / 100, 1.0 / 200})) {
        const Returned open = returned(dx, false), soaked = returned(dx, true);
        findings.record("returned", dx / half_width, std::abs(soaked.share / open.share - 1));
        findings.record("delay", dx / half_width, std::abs((soaked.centre - open.centre) / detour(dx) - 1));
        figure.computed.push_back(
            {"sponge, dx = " + std::to_string(dx).substr(0, 5) + " m", soaked.pressure});
        finest = dx;
        figure.exact = {};
        for (const double x : soaked.pressure.x) {
            const double centre = length - (way - (length - start)) + detour(dx);
            figure.exact.x.push_back(x);
            figure.exact.y.push_back(
                x > length - thickness ? 0 : std::exp(-std::pow((x - centre) / half_width, 2)));
        }
    }
    findings.figure(std::move(figure));
    findings.note(
        "The layer absorbs nothing: all of the pulse comes back, later by the way of at most " +
        std::to_string(detour(finest)) +
        " m at the finest spacing, which grows with the logarithm of it. A tank that is larger by half "
        "of that way does the same and leaves the equations alone.");
}

}  // namespace

Problem sponge_layer() {
    Problem problem;
    problem.name = "sponge_layer";
    problem.title = "Sound pulse in a sponge layer";
    problem.exact =
        "Acoustics with both rates times f: the impedance stays, the speed is c f, the time to the last "
        "particle in "
        "closed form.";
    const std::string resolution = "dx / half width of the incident pulse";
    problem.claims.push_back(
        {"returned",
         "change of the returned area by the layer, relative",
         resolution,
         0.1,
         {},
         "an impedance that is the same everywhere reflects nothing on the way and absorbs "
         "nothing; a tenth for the tail that is still in the layer"});
    Claim delay{"delay",
                "relative error of the delay of the return",
                resolution,
                0.3,
                {},
                "the place where sound turns is known to half of half a spacing, and the delay has the "
                "logarithm of it: ln 2 of 2.3 at the coarsest"};
    delay.known_miss =
        "sound turns earlier than at the last particle, where slowing has shortened the pulse to the length "
        "of the "
        "kernel: the delay is 0.66 short of what was expected at the coarsest spacing, 0.39 at the finest";
    problem.claims.push_back(delay);
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
