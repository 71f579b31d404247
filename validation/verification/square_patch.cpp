// SPDX-License-Identifier: BSD-3-Clause
// A square of water that rotates freely: its corners fly out, its centre is under tension. Water alone clumps
// under tension; with air around, a background pressure bears it, as in scenes with air.
#include <algorithm>
#include <cmath>

#include "solver/probes/energy.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/numerics.hpp"
#include "validation/verification/poisson.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/rotating_patch.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double side = 1, rotation = 1;                    // [m], [1/s]
constexpr double sound_speed = 20 * 0.5 * side * rotation;  // of the speed at the middle of a side
constexpr double air_sound_speed = 5.6 * sound_speed;       // as in the dam break
// the largest tension, in the middle at the start, is 0.15 rho omega^2 side^2
constexpr double background = 0.25 * water_density * rotation * rotation * side * side;
constexpr double shape_times[] = {1, 2}, duration = 2;  // in 1 / rotation

double angular_momentum(const FluidParticles& f) {
    double sum = 0;
    for (std::size_t i = 0; i < f.water; ++i)
        sum += f.mass[i] * (f.state[i].x * f.state[i].vy - f.state[i].y * f.state[i].vx);
    return sum;
}

/// How far the particles are from where finite elements say that their water is.
struct Shape {
    double places = 0;   ///< rms distance over the side
    double inertia = 0;  ///< relative error of the polar second moment
    double arm = 0;      ///< relative error of the mean length of the four corners' arms
    Curve outline;       ///< the particles that began at the sides, in their order around them
};

Shape compare(const FluidParticles& end, const FluidParticles& start, const RotatingPatch& exact, double dx) {
    Shape shape;
    double squares = 0, moment = 0, exact_moment = 0, arm = 0, exact_arm = 0;
    std::vector<std::pair<double, Vec2>> rim;
    for (std::size_t i = 0; i < end.water; ++i) {
        const Vec2 from = start.state[end.id[i]].position(), at = end.state[i].position();
        const Vec2 should = exact.place_of(from), inwards = Vec2::Constant(0.5 * side) - from.cwiseAbs();
        squares += (at - should).squaredNorm();
        moment += at.squaredNorm();
        exact_moment += should.squaredNorm();
        if (inwards.minCoeff() < dx) rim.emplace_back(std::atan2(from.y(), from.x()), at / side);
        if (inwards.maxCoeff() >= dx) continue;
        arm += at.norm();
        exact_arm += should.norm();
    }
    shape.places = std::sqrt(squares / static_cast<double>(end.water)) / side;
    shape.inertia = std::abs(moment / exact_moment - 1);
    shape.arm = std::abs(arm / exact_arm - 1);
    std::sort(rim.begin(), rim.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [angle, at] : rim) {
        shape.outline.x.push_back(at.x());
        shape.outline.y.push_back(at.y());
    }
    shape.outline.x.push_back(shape.outline.x.front());
    shape.outline.y.push_back(shape.outline.y.front());
    return shape;
}

/// The sides of the square after the time of the finite elements, over its side.
Curve outline(const RotatingPatch& patch) {
    Curve curve;
    const Vec2 corner[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}};
    for (int k = 0; k < 4; ++k) {
        for (const double s : linspace(0, 1, 81)) {
            const Vec2 at = patch.place_of(side * (corner[k] + s * (corner[k + 1] - corner[k]))) / side;
            curve.x.push_back(at.x());
            curve.y.push_back(at.y());
        }
    }
    return curve;
}

const double coarse_length = Model{}.smoothing_ratio / 20;  ///< smoothing length at 20 spacings over the side
const double half_diagonal = side / std::sqrt(2.0);

std::string instant_suffix(double time) {
    return "_at_" + std::to_string(time).substr(0, 1);
}
std::string instant_words(double time) {
    return " at omega t = " + std::to_string(time).substr(0, 1);
}

const Box square = {{-0.5 * side, -0.5 * side}, {0.5 * side, 0.5 * side}};

/// The square as a rigid rotation, with the pressure that goes with it.
void rotate(Setup& setup) {
    PoissonProblem initial;  // grad p = -rho (v.grad) v: its divergence is that of a rigid rotation
    initial.box = square;
    initial.cells_x = initial.cells_y = 100;
    initial.source = 2 * water_density * rotation * rotation;
    const PoissonSolution pressure(initial);
    set_initial_pressure(setup.fluid, setup.model,
                         [&](Phase phase, Vec2 at) { return phase == Phase::water ? pressure.at(at) : 0; });
    setup.spin_water(rotation);
}

Setup water_alone(double dx) {
    Setup setup(water_model(sound_speed), {{-2 * side, -2 * side}, {2 * side, 2 * side}}, dx, false);
    setup.fill(Phase::water, square);
    rotate(setup);
    return setup;
}

/// In a box of air, which the corners do not reach.
Setup with_air(double dx) {
    const double room = 1.6 * side;
    Setup setup(two_phase_model(sound_speed, air_sound_speed, background), {{-room, -room}, {room, room}}, dx,
                true);
    setup.fill(Phase::water, square);
    setup.fill_around(Phase::air, square);
    rotate(setup);
    return setup;
}

struct Instant {
    double time;
    std::string name;
    RotatingPatch exact;
    VerificationFigure figure;
};

std::vector<Instant> exact_shapes() {
    std::vector<Instant> instants;
    RotatingPatch exact(side, rotation, 60);
    double reached = 0;
    for (const double time : shape_times) {
        const std::string number = std::to_string(time).substr(0, 3);
        exact.advance((time - reached) / rotation, 25);
        reached = time;
        Instant& instant = instants.emplace_back(Instant{time, instant_suffix(time), exact, {}});
        instant.figure = {"Outline with air around at omega t = " + number,
                          "x over side",
                          "-",
                          "y over side",
                          "-",
                          outline(instant.exact),
                          {}};
    }
    return instants;
}

/// Water alone: what it keeps, and its corners, which are under no tension.
void run_alone(Findings& findings) {
    const std::vector<Instant> instants = exact_shapes();
    VerificationFigure figure{"Energy of the rotating square of water alone",
                              "time times rotation",
                              "-",
                              "energy over its start",
                              "-",
                              {{0, duration}, {1, 1}},
                              {}};
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        const Setup setup = water_alone(dx);
        Simulation simulation = setup.simulate();
        const double momentum = angular_momentum(simulation.fluid());
        const auto energy = [&] {
            const Balance b = balance(simulation);
            return b.kinetic + b.compression;
        };
        const double start = energy();
        Curve curve{{0}, {1}};
        for (const Instant& instant : instants) {
            advance(simulation, instant.time / rotation, [&](const Simulation& s) {
                if (s.steps() % 10 != 0) return;
                curve.x.push_back(s.time() * rotation);
                curve.y.push_back(energy() / start);
            });
            findings.record("arms" + instant.name, dx / side,
                            compare(simulation.fluid(), setup.fluid, instant.exact, dx).arm);
        }
        findings.record("angular_momentum", dx / side,
                        std::abs(angular_momentum(simulation.fluid()) / momentum - 1));
        findings.record("energy", dx / side, std::abs(energy() / start - 1));
        figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 6) + " m", std::move(curve)});
    }
    findings.figure(std::move(figure));
}

/// With air: where its water goes.
void run_with_air(Findings& findings) {
    std::vector<Instant> instants = exact_shapes();
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        const Setup setup = with_air(dx);
        Simulation simulation = setup.simulate();
        for (Instant& instant : instants) {
            advance(simulation, instant.time / rotation);
            Shape shape = compare(simulation.fluid(), setup.fluid, instant.exact, dx);
            findings.record("places" + instant.name, dx / side, shape.places);
            findings.record("inertia" + instant.name, dx / side, shape.inertia);
            instant.figure.computed.push_back(
                {"dx = " + std::to_string(dx).substr(0, 6) + " m", std::move(shape.outline)});
        }
    }
    for (Instant& instant : instants) findings.figure(std::move(instant.figure));
}

}  // namespace

Problem square_patch() {
    Problem problem;
    problem.name = "square_patch";
    problem.title = "Rotating square of water";
    problem.exact =
        "Angular momentum and energy stay; a quarter turn changes nothing. The initial pressure solves "
        "laplace(p) = 2 rho omega^2 with p = 0 on the sides. Where the corners fly has no closed form: it is "
        "compared with moving finite elements, whose cells keep their areas.";
    problem.claims = {
        {"angular_momentum",
         "relative change of the angular momentum over omega t = 2",
         "dx / side",
         1e-4,
         {},
         "pair forces are central, so that only the step's rounding and the drift between two forces changes "
         "it: second order in c dt, (0.5)^2 of "
         "the angle turned per step squared"},
        {"energy", "relative change of kinetic and elastic energy over omega t = 2", "dx / side", 0.15,
         Window{0.4, 2.5},
         "particles in a strip of one smoothing length along the four sides lack half their neighbours: 4 h "
         "/ side / 2 = 15 % of "
         "all pairs at 20 spacings; first order"},
    };
    for (const double time : shape_times) {
        problem.claims.push_back(
            {"arms" + instant_suffix(time),
             "relative error of the distance of the corners' particles from the middle" + instant_words(time),
             "dx / side", coarse_length * time / half_diagonal, Window{0.5, 2.5},
             "the tips feel no force and fly straight; a smoothing length of the corner per unit of omega t "
             "lacks the neighbours that would tell; first order"});
    }
    problem.run = run_alone;
    return problem;
}

Problem square_in_air() {
    Problem problem;
    problem.name = "square_in_air";
    problem.quick = false;
    problem.title = "Rotating square of water in air";
    problem.exact =
        "Where the water of a rotating square goes has no closed form: it is compared with moving finite "
        "elements in empty space, whose cells keep their areas. A background pressure bears the tension in "
        "the middle.";
    for (const double time : shape_times) {
        problem.claims.push_back(
            {"places" + instant_suffix(time),
             "rms distance of the particles from where finite elements have their water, over the side," +
                 instant_words(time),
             "dx / side", 0.5 * coarse_length * time, Window{0.5, 2.5},
             "half a smoothing length per unit of omega t, by which the sides know less than all of the "
             "pressure; first order"});
        problem.claims.push_back({"inertia" + instant_suffix(time),
                                  "relative error of the polar second moment of area," + instant_words(time),
                                  "dx / side", coarse_length * time / half_diagonal, Window{0.5, 2.5},
                                  "twice the places' bound over the radius of the corners; first order"});
    }
    problem.run = run_with_air;
    return problem;
}

}  // namespace wetdeck::verification
