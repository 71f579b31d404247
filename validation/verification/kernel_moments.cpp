// SPDX-License-Identifier: BSD-3-Clause
// Moments of the kernel, and the pair loop applied to fields with known derivatives.
#include <cmath>
#include <numbers>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/numerics.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double disorder = 0.2;  // largest displacement along an axis, in spacings

/// SUM over a square lattice (spacing 1) of f(dx, dy), the origin left out.
template <class F>
double lattice_sum(double radius, F f) {
    const int reach = static_cast<int>(std::ceil(radius));
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            if (i != 0 || j != 0) sum += f(static_cast<double>(i), static_cast<double>(j));
        }
    }
    return sum;
}

/// SUM_j V x dW/dx + 1 on a lattice: the relative error of the gradient of a linear field.
double lattice_gradient_error(double smoothing_ratio) {
    const WendlandC2 kernel{smoothing_ratio};
    return lattice_sum(
               2 * smoothing_ratio,
               [&](double x, double y) { return x * x * kernel.slope_over_distance(std::hypot(x, y)); }) -
           1;
}

/// To first order in the displacements, the standard deviation of SUM_j V g(r_j - r_i) on a lattice of
/// spacing 1 whose points are displaced by independent uniform amounts: (share / sqrt 3) sqrt(SUM_j |V grad
/// g|^2), for an odd grad g.
template <class G>
double disordered_noise(double smoothing_ratio, double share, G g) {
    constexpr double step = 1e-5;
    const double squares = lattice_sum(2 * smoothing_ratio + 1, [&](double x, double y) {
        const double gx = (g(x + step, y) - g(x - step, y)) / (2 * step);
        const double gy = (g(x, y + step) - g(x, y - step)) / (2 * step);
        return gx * gx + gy * gy;
    });
    return share / std::sqrt(3.0) * std::sqrt(squares);
}

constexpr double stretching_x = 0.3, stretching_y = 0.2;  // [1/s]

/// A square of water of side 1 around the origin, and the particles with full support.
struct Square {
    Setup setup;
    double inner;

    Square(double spacing, double share)
        : setup(water_model(100), {{-0.5, -0.5}, {0.5, 0.5}}, spacing, false),
          inner(0.5 - 2.5 * setup.model.smoothing_ratio * spacing) {
        setup.fill(Phase::water, setup.domain);
        if (share > 0) shake(setup, share, 20);
    }
    template <class Pressure, class Velocity>
    Simulation with(Pressure pressure, Velocity velocity) {
        set_initial_pressure(setup.fluid, setup.model, [&](Phase, Vec2 at) { return pressure(at); });
        for (FluidState& p : setup.fluid.state) {
            const Vec2 v = velocity(p.position());
            p.vx = v.x();
            p.vy = v.y();
        }
        return setup.simulate();
    }
    auto chosen(const FluidParticles& f) const {
        return [&f, this](std::size_t i) { return f.state[i].position().cwiseAbs().maxCoeff() < inner; };
    }
    /// rms over the inner particles of the acceleration's difference from -grad(p)/rho, over
    /// `scale(position)`.
    template <class Gradient, class Scale>
    double acceleration_error(const Simulation& simulation, Gradient gradient, Scale scale) const {
        const FluidParticles& f = simulation.fluid();
        return rms(f, chosen(f), [&](std::size_t i) {
            const Vec2 expected = -gradient(f.state[i].position()) / f.state[i].density;
            return (Vec2(f.acceleration_x[i], f.acceleration_y[i]) - expected).norm() /
                   scale(f.state[i].position());
        });
    }
    double divergence_error(const Simulation& simulation, double divergence) const {
        const FluidParticles& f = simulation.fluid();
        return rms(f, chosen(f),
                   [&](std::size_t i) { return f.density_rate[i] / (-f.state[i].density * divergence) - 1; });
    }
};

constexpr auto at_rest = [](Vec2) { return Vec2(0, 0); };

void continuous_moments(Findings& findings) {
    const WendlandC2 kernel{0.7};
    const double radius = kernel.support_radius();
    const double mass = integral([&](double r) { return 2 * pi * r * kernel.value(r); }, 0, radius);
    findings.record("normalisation", 1, std::abs(mass - 1));
    const double slope =
        integral([&](double r) { return pi * r * r * r * kernel.slope_over_distance(r); }, 0, radius);
    findings.record("slope_moment", 1, std::abs(slope - 1));
}

void lattice_moments(Findings& findings) {
    for (const double ratio : {1.25, 2.5, 5.0, 10.0}) {
        const WendlandC2 kernel{ratio};
        const double sum = kernel.value(0) + lattice_sum(2 * ratio, [&](double x, double y) {
                               return kernel.value(std::hypot(x, y));
                           });
        findings.record("lattice_sum", 1 / ratio, std::abs(sum - 1));
        findings.record("lattice_gradient", 1 / ratio, std::abs(lattice_gradient_error(ratio)));
    }
}

void fields_on_lattice(Findings& findings) {
    const double expected = lattice_gradient_error(Model{}.smoothing_ratio);
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        Square square(dx, 0);
        const Vec2 slope(300, -500);
        const Simulation linear = square.with([&](Vec2 at) { return 2000 + slope.dot(at); }, at_rest);
        const auto scale = [&](Vec2) { return slope.norm() / water_density; };
        findings.record("linear_field", dx,
                        square.acceleration_error(
                            linear, [&](Vec2) { return slope; }, scale));
        findings.record("linear_field_as_predicted", dx,
                        square.acceleration_error(
                            linear, [&](Vec2) { return Vec2(slope * (1 + expected)); }, scale));
        const Simulation quadratic = square.with([](Vec2 at) { return 1000 * at.squaredNorm(); }, at_rest);
        findings.record("quadratic_field", dx,
                        square.acceleration_error(
                            quadratic, [](Vec2 at) { return Vec2(2000 * at); },
                            [](Vec2 at) { return 2000 * at.norm() / water_density; }));
        const Simulation stretching =
            square.with([](Vec2) { return 0.0; },
                        [](Vec2 at) { return Vec2(stretching_x * at.x(), stretching_y * at.y()); });
        findings.record("divergence", dx, square.divergence_error(stretching, stretching_x + stretching_y));
    }
}

void fields_on_disorder(Findings& findings) {
    for (const double dx : findings.levels({1.0 / 20, 1.0 / 40, 1.0 / 80})) {
        Square square(dx, disorder);
        const Simulation constant = square.with([](Vec2) { return 1000.0; }, at_rest);
        // p over rho L is the scale: a field that varied by itself over L = 1 would have this acceleration
        findings.record("constant_field_disordered", dx,
                        square.acceleration_error(constant, at_rest, [](Vec2) { return 1.0; }));
        const Simulation stretching =
            square.with([](Vec2) { return 0.0; },
                        [](Vec2 at) { return Vec2(stretching_x * at.x(), stretching_y * at.y()); });
        findings.record("divergence_disordered", dx,
                        square.divergence_error(stretching, stretching_x + stretching_y));
    }
    findings.note(
        "On disordered particles (each displaced by up to 0.2 spacings along each axis) the sums do not "
        "converge at a "
        "fixed number of neighbours: the divergence keeps its error, and a constant pressure drives "
        "particles with "
        "an acceleration that grows as 1/dx. That acceleration is what pushes particles back to an even "
        "distribution.");
}

void run(Findings& findings) {
    continuous_moments(findings);
    lattice_moments(findings);
    fields_on_lattice(findings);
    fields_on_disorder(findings);
}

}  // namespace

Problem kernel_moments() {
    const double ratio = Model{}.smoothing_ratio;
    const double moment = std::abs(lattice_gradient_error(ratio));
    // 2 p SUM V grad W / rho, two components, on a side of 1 with 20 spacings
    const WendlandC2 kernel{ratio};
    const double gradient_noise = disordered_noise(ratio, disorder, [&](double x, double y) {
        return -x * kernel.slope_over_distance(std::hypot(x, y));
    });
    const double noise = 2 * std::sqrt(2.0) * gradient_noise * 20;
    const double divergence_noise = disordered_noise(ratio, disorder, [&](double x, double y) {
        return (stretching_x * x * x + stretching_y * y * y) / (stretching_x + stretching_y) *
               kernel.slope_over_distance(std::hypot(x, y));
    });
    Problem problem;
    problem.name = "kernel_moments";
    problem.title = "Moments of the kernel and gradients of known fields";
    problem.exact =
        "INT W dA = 1, INT x dW/dx dA = -1; a linear or quadratic pressure has the acceleration "
        "-grad(p)/rho, "
        "a linear velocity the density rate -rho div(v).";
    const std::string spacing = "dx / side of the square";
    problem.claims = {
        {"normalisation", "|INT W dA - 1|", "none", 1e-10, {}, "the integral is taken to 1e-11"},
        {"slope_moment", "|INT x dW/dx dA + 1|", "none", 1e-10, {}, "the integral is taken to 1e-11"},
        {"lattice_sum", "|SUM V W - 1| on a square lattice", "dx / h", 0.02, Window{4, 7},
         "the Fourier transform of W falls as k^-5 (its third derivative jumps at the centre), so does the "
         "error of "
         "the sum; the smaller waves of the edge of the support ride on it. Bound: 4 W^(2 pi/dx), about 1 % "
         "at h = 1.25 dx"},
        {"lattice_gradient", "|SUM V x dW/dx + 1| on a square lattice", "dx / h", 0.05, Window{4, 7},
         "the derivative of k W^(k) falls as k^-5 as well, with five times its factor"},
        {"linear_field", "rms difference of the acceleration from -grad(p)/rho, over the latter", spacing,
         1.01 * moment, Window{-0.1, 0.1},
         "the moment of the lattice at the scheme's h/dx, which no refinement at fixed h/dx changes: order "
         "0"},
        {"linear_field_as_predicted",
         "the same, from -grad(p)/rho times the moment of the lattice",
         spacing,
         1e-8,
         {},
         "rounding: pressures of 1e3 Pa come from rho0 c^2/7 = 1e6 Pa by a difference"},
        {"quadratic_field", "rms difference of the acceleration from -grad(p)/rho, over the latter", spacing,
         1.01 * moment, Window{-0.1, 0.1},
         "the second moments of grad W vanish on a lattice: as for the linear field, order 0"},
        {"divergence", "rms relative difference of the density rate from -rho div(v)", spacing, 1.01 * moment,
         Window{-0.1, 0.1}, "the same sum as for the linear field"},
        {"constant_field_disordered", "rms acceleration of a constant pressure, over p/(rho side)", spacing,
         1.3 * noise, Window{-1.15, -0.85},
         "SUM V grad W to first order in the displacements, computed from the second derivatives of W, and "
         "30 % for "
         "the higher orders; grows as 1/dx"},
        {"divergence_disordered", "rms relative difference of the density rate from -rho div(v)", spacing,
         1.3 * divergence_noise, Window{-0.1, 0.1}, "as for the constant field; order 0"},
    };
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
