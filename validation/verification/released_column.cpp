// SPDX-License-Identifier: BSD-3-Clause
// Pressure in a column of water just after its gate is gone: Laplace's equation, Greco's series, and the
// solver.
#include <cmath>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/poisson.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double height = 1, length = 2, gravity = 9.81, weight = water_density * gravity * height;
constexpr double mach_inverse = 80;  // sound speed over sqrt(g H)
// in sqrt(height / gravity): two periods of the slowest sound, 4 H / c sqrt(1 + (H / 2 L)^2 ...) = 3.6 H / c;
// the face has moved by 0.01 H
constexpr double mean_from = 0.04, mean_to = mean_from + 2 * 3.58 / mach_inverse;

PoissonSolution laplace(double column, int cells) {
    PoissonProblem problem;
    problem.box = {{0, 0}, {column, height}};
    problem.cells_y = cells;
    problem.cells_x = static_cast<int>(std::lround(cells * column / height));
    problem.left = {Side::Kind::slope, 0};
    problem.bottom = {Side::Kind::slope, -water_density * gravity};
    return PoissonSolution(problem);
}

void series(Findings& findings) {
    constexpr double long_column = 4 * height;
    for (const int cells : {8, 16, 32, 64}) {
        const PoissonSolution solution = laplace(long_column, cells);
        double squares = 0;
        int count = 0;
        // on nodes of every grid; the back wall, which the series has not, is four heights away
        for (int i = 1; i <= 16; ++i) {
            for (int j = 0; j < 8; ++j) {
                const Vec2 at(long_column - i * height / 8, j * height / 8);
                const double difference = solution.at(at) - greco_pressure(water_density, gravity, height,
                                                                           long_column - at.x(), at.y());
                squares += difference * difference;
                ++count;
            }
        }
        findings.record("greco_series", 1.0 / cells, std::sqrt(squares / count) / weight);
    }
}

void solver(Findings& findings) {
    const PoissonSolution exact = laplace(length, 100);
    const double wave_speed = std::sqrt(gravity * height), unit = std::sqrt(height / gravity);
    VerificationFigure figure{"Pressure on the bed just after release",
                              "distance from the back wall over H",
                              "-",
                              "pressure over rho g H",
                              "-",
                              {},
                              {}};
    for (double x = 0; x <= length; x += 0.02) {
        figure.exact.x.push_back(x / height);
        figure.exact.y.push_back(exact.at({x, 0}) / weight);
    }
    for (const bool from_hydrostatic : {false, true}) {
        for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
            Model model = water_model(mach_inverse * wave_speed, gravity);
            model.negative_pressure = false;
            Setup setup(model, {{0, 0}, {length + 1, 1.5 * height}}, dx, true);
            setup.fill(Phase::water, {{0, 0}, {length, height}});
            set_initial_pressure(setup.fluid, model, [&](Phase, Vec2 at) {
                if (from_hydrostatic) return water_density * gravity * (height - at.y());
                return greco_pressure(water_density, gravity, height, length - at.x(), at.y());
            });
            Simulation simulation = setup.simulate();
            std::vector<double> sum(setup.fluid.size(), 0.0);
            std::vector<Vec2> position(setup.fluid.size());
            double samples = 0;
            for (std::size_t i = 0; i < setup.fluid.size(); ++i)
                position[i] = setup.fluid.state[i].position();
            advance(simulation, mean_to * unit, [&](const Simulation& s) {
                if (s.time() < mean_from * unit) return;
                samples += 1;
                for (std::size_t i = 0; i < s.fluid().size(); ++i)
                    sum[s.fluid().id[i]] += s.fluid().state[i].pressure;
            });
            double squares = 0;
            Curve bed;
            for (std::size_t i = 0; i < sum.size(); ++i) {
                const double mean = sum[i] / samples;
                squares += std::pow(mean - exact.at(position[i]), 2);
                if (position[i].y() < dx) {
                    bed.x.push_back(position[i].x() / height);
                    bed.y.push_back((mean + water_density * gravity * position[i].y()) / weight);
                }
            }
            const double error = std::sqrt(squares / static_cast<double>(sum.size())) / weight;
            findings.record(from_hydrostatic ? "from_hydrostatic" : "from_greco", dx / height, error);
            figure.computed.push_back(
                {(from_hydrostatic ? "from hydrostatic, dx/H = " : "from Greco, dx/H = ") +
                     std::to_string(dx).substr(0, 6),
                 std::move(bed)});
        }
    }
    findings.figure(std::move(figure));
}

void run(Findings& findings) {
    series(findings);
    solver(findings);
}

}  // namespace

Problem released_column() {
    Problem problem;
    problem.name = "released_column";
    problem.title = "Pressure just after the release of a column";
    problem.exact =
        "Laplace's equation with p = 0 on surface and face, dp/dy = -rho g on the bed, dp/dx = 0 at the back "
        "wall, by "
        "finite differences and a sparse factorisation.";
    problem.claims = {
        {"greco_series", "rms difference of Greco's series (27) from Laplace's equation over rho g H",
         "cell / height", 0.01, Window{1.7, 2.3},
         "the finite differences are of second order; at 8 cells (pi/16)^2 / 12 of the slowest term is 0.3 "
         "%"},
        {"from_greco",
         "rms difference of the solver's mean pressure from Laplace's over rho g H, started from the series",
         "dx / height", 0.025, Window{0.3, 2.2},
         "pressure misplaced by half a spacing at the free faces, 2.5 % of rho g H at 20 spacings; first "
         "order"},
        {"from_hydrostatic",
         "the same, started from hydrostatic pressure: sound has to carry the release through the column",
         "dx / height",
         0.05,
         {},
         "sound of the release, as strong as rho g H at the foot of the face, is averaged over two periods "
         "of its slowest mode; "
         "what is left of faster ones is at most a twentieth; no order expected"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
