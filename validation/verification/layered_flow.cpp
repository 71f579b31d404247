// SPDX-License-Identifier: BSD-3-Clause
// Two fluids of different viscosity between no-slip walls, one above the other: driven by the upper wall
// (Couette) or by a force along the channel (Poiseuille). The channel is periodic along the flow.
#include <cmath>
#include <numbers>

#include "validation/verification/numerics.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

constexpr double height = 1, interface = 0.5 * height, period = 0.4 * height;  // [m]
constexpr double fastest = 1;                                                  // exact largest speed [m/s]
constexpr double sound_speed = 20 * fastest;
constexpr double upper_kinematic_viscosity = 0.05 * height * fastest;
/// From the exact flow on, the errors of the steady one have to grow. The slowest mode decays at pi^2 nu /
/// H^2 in one fluid and at four times that in the upper one alone: after this time in H^2 / nu, 5 % of it is
/// left.
constexpr double duration = 0.3, duration_of_one_layer = 0.075, mean_from = 0.7;
constexpr double coarsest = height / 20;

/// Steady flow does not know the density. It follows the viscosity up to a factor, so that momentum does not
/// diffuse much faster in one fluid than in the other: the time to be steady is that of the slower one, the
/// step that of the faster.
struct Case {
    std::string name, words;
    double viscosity_ratio, density_ratio;  // lower over upper
    bool moving_wall;                       // or a force along the channel
};

const std::vector<Case>& cases() {
    static const std::vector<Case> list = {
        {"couette_1", "Couette flow, viscosities 1 to 1", 1, 1, true},
        {"couette_20", "Couette flow, viscosities 20 to 1", 20, 4, true},
        {"couette_1000", "Couette flow, viscosities 1000 to 1", 1000, 200, true},
        {"poiseuille_1", "Poiseuille flow, viscosities 1 to 1", 1, 1, false},
        {"poiseuille_20", "Poiseuille flow, viscosities 20 to 1", 20, 4, false},
        {"poiseuille_1000", "Poiseuille flow, viscosities 1000 to 1", 1000, 200, false}};
    return list;
}

/// mu_k u'' = -rho_k g in each layer, u = 0 below, u = wall above, u and mu u' continuous at the interface:
///     u = -g y^2 / (2 nu_1) + a y,   u = -g z^2 / (2 nu_2) + b z + wall with z = H - y.
class ExactFlow {
  public:
    explicit ExactFlow(const Case& c) {
        upper_density = water_density / c.density_ratio;
        upper_viscosity = upper_density * upper_kinematic_viscosity;
        lower_viscosity = c.viscosity_ratio * upper_viscosity;
        solve(c.moving_wall ? 0 : 1, c.moving_wall ? fastest : 0);
        if (c.moving_wall) return;
        double largest = 0;
        for (const double y : linspace(0, height, 2001)) largest = std::max(largest, speed(y));
        solve(fastest / largest, 0);
    }

    double speed(double y) const {
        if (y < interface) return y * (a_ - 0.5 * drive * y * water_density / lower_viscosity);
        const double z = height - y;
        return wall_speed + z * (b_ - 0.5 * drive * z * upper_density / upper_viscosity);
    }
    double fastest_below() const {
        double largest = 0;
        for (const double y : linspace(0, interface, 1001)) largest = std::max(largest, std::abs(speed(y)));
        return largest;
    }
    double interface_stress() const { return lower_viscosity * a_ - drive * water_density * interface; }
    /// Of the fluid on the upper wall.
    double wall_stress() const { return upper_viscosity * b_; }
    double steepest() const {  ///< slope, at a wall or on either side of the interface
        const double at_interface = interface_stress();
        return std::max({std::abs(a_), std::abs(b_), std::abs(at_interface / lower_viscosity),
                         std::abs(at_interface / upper_viscosity)});
    }

    double upper_density, upper_viscosity, lower_viscosity, drive = 0, wall_speed = 0;

  private:
    void solve(double drive_, double wall_speed_) {
        drive = drive_;
        wall_speed = wall_speed_;
        const double s = interface, t = height - interface, g = drive;
        const double nu_1 = lower_viscosity / water_density, nu_2 = upper_viscosity / upper_density;
        const double m = lower_viscosity / upper_viscosity;
        // b = t g / nu_2 - m (a - g s / nu_1) from the stress, then a from the velocity
        a_ = (wall_speed + 0.5 * g * (s * s / nu_1 + t * t / nu_2) + m * t * g * s / nu_1) / (s + m * t);
        b_ = t * g / nu_2 - m * (a_ - g * s / nu_1);
    }
    double a_ = 0, b_ = 0;
};

Simulation channel(const Case& c, const ExactFlow& exact, double dx) {
    // twice the dynamic pressure of either fluid, what disorder can suck; more drowns the upper one's stress
    const double background =
        std::max(water_density * std::pow(exact.fastest_below(), 2), exact.upper_density * fastest * fastest);
    Model model = two_phase_model(sound_speed, sound_speed, background);
    model.air.eos = {exact.upper_density, sound_speed, 7, background};
    model.viscosity = Viscosity::symmetric;
    model.water.viscosity = exact.lower_viscosity;
    model.air.viscosity = exact.upper_viscosity;
    model.dissipation = Dissipation::none;
    model.wall_dissipation = 0;
    model.wall_slip = WallSlip::no;
    model.periodic_x = true;
    model.gravity = {exact.drive, 0};
    // no wall holds the driving force, so that no pressure balances it
    model.hydrostatic_correction = false;
    model.wall_pressure = WallPressure::shepard;
    Setup setup(model, {{0, 0}, {period, height}}, dx, true);
    setup.fill(Phase::water, {{0, 0}, {period, interface}});
    setup.fill(Phase::air, {{0, interface}, {period, height}});
    for (FluidState& p : setup.fluid.state) p.vx = exact.speed(p.y);
    if (c.moving_wall) {
        for (WallState& w : setup.walls.state) w.vx = w.y > height ? exact.wall_speed : 0;
    }
    return setup.simulate();
}

/// Stress between the fluids: what the upper one gains beyond its drive, and what the upper wall takes.
double interface_stress(const Simulation& simulation) {
    const FluidParticles& fluid = simulation.fluid();
    const WallParticles& walls = simulation.walls();
    std::vector<double> ax(fluid.size()), ay(fluid.size()), fx(walls.size(), 0), fy(walls.size(), 0);
    PassInput in = simulation.inputs();
    in.acceleration_x = ax.data();
    in.acceleration_y = ay.data();
    in.wall_force_x = fx.data();
    in.wall_force_y = fy.data();
    in.fixed_walls = 0;  // these walls are meant
    const PairPasses loops = pair_passes(simulation.model(), simulation.instruction_set());
    loops.accelerations(in);
    loops.body_forces(in);
    double force = 0;
    for (std::size_t i = fluid.water; i < fluid.size(); ++i)
        force += fluid.mass[i] * (ax[i] - simulation.model().gravity.x());
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const WallState& w = walls.state[n];
        if (w.y > height && w.x >= 0 && w.x < period) force += fx[n];
    }
    return -force / period;
}

/// Means over time and along the channel, row by row.
struct Profile {
    explicit Profile(double dx)
        : rows(static_cast<std::size_t>(std::lround(height / dx))),
          count(rows, 0),
          height_sum(rows, 0),
          speed_sum(rows, 0) {}

    void sample(const Simulation& s) {
        for (const FluidState& p : s.fluid().state) {
            const double row = std::clamp(p.y / height * static_cast<double>(rows), 0.0, rows - 1.0);
            const auto k = static_cast<std::size_t>(row);
            count[k] += 1;
            height_sum[k] += p.y;
            speed_sum[k] += p.vx;
        }
        stress_sum += interface_stress(s);
        samples += 1;
    }

    std::size_t rows;
    std::vector<double> count, height_sum, speed_sum;
    double stress_sum = 0, samples = 0;
};

void run_case(Findings& findings, const Case& c) {
    const ExactFlow exact(c);
    VerificationFigure figure{c.words, "speed over the largest", "-", "height over H", "-", {}, {}};
    for (const double y : linspace(0, height, 201)) {
        figure.exact.x.push_back(exact.speed(y) / fastest);
        figure.exact.y.push_back(y / height);
    }
    const double end = (c.viscosity_ratio == 1 ? duration : duration_of_one_layer) * height * height /
                       upper_kinematic_viscosity;
    for (const double dx : findings.levels({coarsest, coarsest / 2, coarsest / 4})) {
        Simulation simulation = channel(c, exact, dx);
        Profile profile(dx);
        advance(simulation, end, [&](const Simulation& s) {
            if (s.time() > mean_from * end && s.steps() % 10 == 0) profile.sample(s);
        });
        double squares = 0, rows = 0;
        Curve line;
        for (std::size_t k = 0; k < profile.rows; ++k) {
            if (profile.count[k] == 0) continue;
            const double y = profile.height_sum[k] / profile.count[k];
            const double u = profile.speed_sum[k] / profile.count[k];
            squares += std::pow(u - exact.speed(y), 2);
            rows += 1;
            line.x.push_back(u / fastest);
            line.y.push_back(y / height);
        }
        findings.record("profile_" + c.name, dx / height, std::sqrt(squares / rows) / fastest);
        findings.record("stress_" + c.name, dx / height,
                        std::abs((profile.stress_sum / profile.samples - exact.interface_stress()) /
                                 exact.wall_stress()));
        figure.computed.push_back({"dx/H = " + std::to_string(dx).substr(0, 6), std::move(line)});
    }
    findings.figure(std::move(figure));
}

/// Viscous stress of even shear along a lattice whose rows slide over each other, over the nominal one: sums
/// over the rows and, as every offset comes, an integral along them, over the integral across as well.
double share_of_sliding_rows() {
    const double h = Model{}.smoothing_ratio;
    const WendlandC2 kernel{h};
    double sum = 0;
    for (int row = 1; row < kernel.support_radius(); ++row) {
        const double end = std::sqrt(kernel.support_radius() * kernel.support_radius() - row * row);
        sum += 4 * integral(
                       [&](double x) {
                           return kernel.slope_over_distance(std::hypot(x, row)) * x * x * row * row /
                                  std::hypot(x, row);
                       },
                       0, end);
    }
    const double whole = integral(
        [&](double r) { return std::numbers::pi / 4 * r * r * r * r * kernel.slope_over_distance(r); }, 0,
        kernel.support_radius());
    return sum / whole;
}

void run(Findings& findings) {
    for (const Case& c : cases()) run_case(findings, c);
    char text[800];
    std::snprintf(
        text, sizeof text,
        "Rows of particles slide over each other; the kernel's moment of such rows gives %.4f of the nominal "
        "viscosity at the scheme's h/dx, and no refinement changes that. Couette flow then has the right "
        "profile and too little stress (1.8 to 2.1 %% at 80 spacings), Poiseuille flow too much speed (1.1 "
        "to "
        "1.7 %%): with respect to the nominal viscosity neither converges. The background pressure is that "
        "of "
        "the flow: with 1000 Pa, two thousand times "
        "the stress of the upper fluid, the forces of disorder drown the stress at 1000 to 1: 58 %% off at "
        "20 spacings, 88 %% at 40.",
        share_of_sliding_rows());
    findings.note(text);
}

}  // namespace

Problem layered_flow() {
    Problem problem;
    problem.name = "layered_flow";
    problem.title = "Two layers between no-slip walls";
    problem.exact =
        "mu_k u'' = -rho_k g in each layer, u continuous and mu u' continuous at the interface, u that of "
        "the walls. "
        "Viscosities 1, 20 and 1000 to 1, densities 1, 4 and 200 to 1; driven by the upper wall at 1 m/s or "
        "by a force "
        "along the channel that gives 1 m/s. Errors grow from the exact flow until steady.";
    const std::string resolution = "dx / height H";
    const double missing = 1 - share_of_sliding_rows();
    for (const Case& c : cases()) {
        const ExactFlow exact(c);
        // four strips of one smoothing length: at both walls and on both sides of the interface
        const double strips = 4 * Model{}.smoothing_ratio * coarsest / height;
        const double slipped = 0.5 * coarsest * exact.steepest() / fastest * std::sqrt(strips);
        Claim profile{
            "profile_" + c.name,
            "rms difference of the rows' mean speed over the largest, " + c.words,
            resolution,
            slipped,
            Window{0.5, 2.5},
            "half a spacing of the steepest slope in strips of one smoothing length at the walls and the "
            "interface: wall and harmonic mean are right for pairs that lie evenly about the plane; first "
            "order"};
        if (!c.moving_wall) {
            profile.bound += missing;
            profile.order = {};
            profile.reason =
                "the same of the steepest slope, and the viscosity that sliding rows lack, 2.2 %, which "
                "stays: no "
                "order expected";
        }
        problem.claims.push_back(profile);
        problem.claims.push_back(
            {"stress_" + c.name,
             "error of the stress between the fluids over that on the upper wall, " + c.words,
             resolution,
             missing + 0.5 * coarsest / height,
             {},
             "the viscosity that sliding rows lack, 2.2 %, which stays, and half a spacing of the height: no "
             "order expected"});
    }
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification
