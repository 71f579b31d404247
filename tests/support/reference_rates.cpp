// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/reference_rates.hpp"

#include <algorithm>
#include <cmath>

#include "solver/physics/density_bounds.hpp"
#include "solver/physics/wendland_c2.hpp"
#include "solver/physics/wetting.hpp"

namespace wetdeck::samples {
namespace {

const Material& material(const Model& model, Phase phase) {
    return phase == Phase::water ? model.water : model.air;
}

/// What a side of a pair weighs in the mean of velocities; in that of pressures the other side weighs that.
double weight(Mean mean, const Material& side) {
    if (mean == Mean::density_weighted) return side.eos.reference_density;
    if (mean == Mean::impedance_weighted) return side.impedance();
    return 1;
}

/// 2ab/(a+b), and what the guard puts in its place.
double guarded_mean(const Model& model, double a, double b, bool meaningful) {
    if (model.mean_guard == MeanGuard::division || meaningful) return a + b == 0 ? 0 : 2 * a * b / (a + b);
    return model.mean_guard == MeanGuard::same_sign_zero ? 0 : 0.5 * (a + b);
}

/// One ordered pair of fluid particles; e points from the left one to the right one.
struct Pair {
    const Model& model;
    const FluidState &left, &right;
    const Material &left_material, &right_material;
    bool with_air;

    Vec2 offset() const { return left.position() - right.position(); }
    double distance() const { return offset().norm(); }
    Vec2 e() const { return -offset() / distance(); }
    double u_left() const { return left.velocity().dot(e()); }
    double u_right() const { return right.velocity().dot(e()); }
    double left_impedance() const { return left_material.impedance(); }
    double right_impedance() const { return right_material.impedance(); }
    double mean_density() const {
        return harmonic_mean(left_material.eos.reference_density, right_material.eos.reference_density);
    }
    double mean_impedance() const { return harmonic_mean(left_impedance(), right_impedance()); }

    /// Eq. (10), without the hydrostatic part of the jump where the model says so.
    double u_star() const {
        double jump = left.pressure - right.pressure;
        if (model.hydrostatic_correction) {
            const double density =
                0.5 * (left_material.eos.reference_density + right_material.eos.reference_density);
            jump -= density * model.gravity.dot(offset());
        }
        return mean_velocity().dot(e()) + model.pressure_diffusion * jump / (2 * star_impedance());
    }

    /// The mean of rho c in u*.
    double star_impedance() const {
        const double density_ratio = left.density / left_material.eos.reference_density;
        if (model.impedance_mean == ImpedanceMean::arithmetic)
            return density_ratio * 0.5 * (left_impedance() + right_impedance());
        return 2 / (1 / (left.density * left_material.eos.sound_speed) +
                    1 / (right.density * right_material.eos.sound_speed));
    }

    double harmonic(double a, double b, bool meaningful) const {
        return guarded_mean(model, a, b, meaningful);
    }

    Vec2 mean_velocity() const {
        const Vec2 l = left.velocity(), r = right.velocity();
        if (model.velocity_mean == Mean::harmonic)
            return {harmonic(l.x(), r.x(), l.x() * r.x() > 0), harmonic(l.y(), r.y(), l.y() * r.y() > 0)};
        const double a = weight(model.velocity_mean, left_material);
        const double b = weight(model.velocity_mean, right_material);
        return (a * l + b * r) / (a + b);
    }

    double mean_pressure() const {
        if (model.pressure_mean == Mean::harmonic)
            return harmonic(left.pressure, right.pressure, left.pressure > 0 && right.pressure > 0);
        const double a = weight(model.pressure_mean, left_material);
        const double b = weight(model.pressure_mean, right_material);
        return (b * left.pressure + a * right.pressure) / (a + b);
    }

    double dissipation(double jump) const {
        if (model.dissipation == Dissipation::none) return 0;
        DissipationLimiter limiter{0.5 * mean_impedance(), 0, 1};
        if (model.dissipation == Dissipation::low_dissipation) {
            limiter.slope_over_speed = with_air ? 0 : model.dissipation_slope / left_material.eos.sound_speed;
            limiter.floor = with_air ? model.air_dissipation : 0;
        }
        return riemann_dissipation(jump, limiter);
    }

    /// Eq. (13)
    double viscous_pressure(double jump, double smoothing_length) const {
        if (model.viscosity == Viscosity::none) return 0;
        if (left_material.viscosity <= 0 || right_material.viscosity <= 0) return 0;
        if (model.viscosity == Viscosity::approaching && jump <= 0) return 0;
        const double viscosity = harmonic_mean(left_material.viscosity, right_material.viscosity);
        return viscosity_lambda(model.viscosity) * viscosity * jump / smoothing_length;
    }

    /// Eq. (14)
    double switch_pressure(double jump) const {
        if (!model.dissipation_switch || std::max(left.impact, right.impact) == 0) return 0;
        return 0.5 * mean_density() * switch_velocity() * jump;
    }

    double switch_velocity() const {
        if (model.switch_velocity == SwitchVelocity::modulus)
            return 0.5 * (left.velocity() + right.velocity()).norm();
        if (model.switch_velocity == SwitchVelocity::harmonic)
            return std::abs(harmonic(u_left(), u_right(), u_left() * u_right() > 0));
        return std::abs(0.5 * (u_left() + u_right()));
    }

    double p_star(double smoothing_length) const {
        const double jump = u_left() - u_right();
        return mean_pressure() + dissipation(jump) + viscous_pressure(jump, smoothing_length) +
               switch_pressure(jump);
    }
};

Pair pair_of(const FluidParticles& fluid, std::size_t i, std::size_t j, const Model& model) {
    const bool with_air = fluid.phase(i) == Phase::air || fluid.phase(j) == Phase::air;
    return {model,
            fluid.state[i],
            fluid.state[j],
            material(model, fluid.phase(i)),
            material(model, fluid.phase(j)),
            with_air};
}

bool sees_mean_pressure(const Model& model, Phase phase) {
    return model.wall_pressure == WallPressure::shepard ||
           (model.wall_pressure == WallPressure::shepard_water && phase == Phase::water);
}

/// |dW/dr|
double kernel_slope(const WendlandC2& kernel, double distance) {
    return kernel.slope_over_distance(distance) * distance;
}

/// Smoothing lengths: one for all, or that of each particle.
struct Lengths {
    double finest;           ///< spacing [m]
    double smoothing_ratio;  ///< smoothing length over spacing
    bool graded;

    double of(const FluidState& p) const { return smoothing_ratio * finest / (graded ? p.fineness : 1); }
    double of_wall(double fineness) const { return smoothing_ratio * finest / fineness; }
    /// Of a pair of particles with these smoothing lengths: their harmonic mean.
    static WendlandC2 kernel(double a, double b) { return {2 * a * b / (a + b)}; }
};

Vec2 place(const WallState& wall) {
    return {wall.x, wall.y};
}
Vec2 normal(const WallState& wall) {
    return {wall.nx, wall.ny};
}
Vec2 tangent(const WallState& wall) {
    return {-wall.ny, wall.nx};
}

/// Eq. (19): the mean of what each fluid particle near sees behind the face, Eq. (17), and of its velocity.
WallMean shepard_mean(const WallState& wall, double own_length, double own_sum, double wetness,
                      const FluidParticles& fluid, const Model& model, const Lengths& lengths) {
    const Vec2 drive = Vec2(wall.ax, wall.ay) - model.gravity;
    double pressure = 0, weights = 0, kernel_sum = 0;
    Vec2 velocity = Vec2::Zero();
    for (std::size_t f = 0; f < fluid.size(); ++f) {
        if (fluid.phase(f) == Phase::air && model.wall_pressure != WallPressure::shepard) continue;
        const FluidState& p = fluid.state[f];
        const Vec2 offset = p.position() - place(wall);
        if (offset.dot(normal(wall)) < 0) continue;  // belongs to the other side of a thin body
        const double kernel = Lengths::kernel(own_length, lengths.of(p)).value(offset.norm());
        const double w = lengths.graded ? kernel / (p.fineness * p.fineness) : kernel;
        pressure +=
            w * one_sided_pressure(p.pressure, p.density, offset.x(), offset.y(), drive.x(), drive.y());
        velocity += w * p.velocity();
        kernel_sum += kernel * p.volume;
        weights += w;
    }
    if (weights == 0) return {0, 0, 0, 0};
    return {pressure / weights, velocity.x() / weights, velocity.y() / weights,
            next_wetness(wetness, covered_share(kernel_sum, own_sum))};
}

/// One fluid particle's sums over the walls.
struct WallSums {
    double compression = 0;  ///< SUM V F (v - v_w) . e of the reversed velocity [1/s]
    Vec2 push = Vec2::Zero();
    double distance = 0;  ///< from the nearest face, in spacings
};

WallSums wall_sums(const FluidParticles& fluid, std::size_t i, const WallParticles& walls, const Rates& rates,
                   const Model& model, const Lengths& lengths) {
    const FluidState& p = fluid.state[i];
    const Material& side = material(model, fluid.phase(i));
    WallSums sums;
    double stretching = 0, wet = 0, room = 0, nearest = model.smoothing_ratio, closest = 1e300;
    for (std::size_t w = 0; w < walls.size(); ++w) {
        const WallState& wall = walls.state[w];
        const Vec2 offset = p.position() - place(wall), velocity = p.velocity() - Vec2(wall.vx, wall.vy);
        const double spacing = lengths.finest / walls.fineness[w];
        const WendlandC2 kernel = Lengths::kernel(lengths.of(p), lengths.of_wall(walls.fineness[w]));
        if (offset.norm() >= kernel.support_radius()) continue;
        const Vec2 e = -offset.normalized(), n = normal(wall), t = tangent(wall);
        const double slope = spacing * spacing * kernel_slope(kernel, offset.norm());
        const bool edge = n.norm() == 0;
        const double one_sided = one_sided_pressure(p.pressure, p.density, offset.x(), offset.y(),
                                                    wall.ax - model.gravity.x(), wall.ay - model.gravity.y());
        const double star = model.wall_pressure_jump ? model.pressure_diffusion * (p.pressure - one_sided) /
                                                           (2 * p.density * side.eos.sound_speed)
                                                     : 0;
        const double felt = model.wall_velocity == WallVelocity::own ? 0.5 : 1;
        sums.compression +=
            slope * (edge ? felt * velocity.dot(e) - star : (felt * velocity.dot(n) + star) * n.dot(e));
        const double open = spacing * spacing * kernel.value(offset.norm()) * (1 - walls.own_sum[w]);
        room += open;
        wet += open * rates.wall[w].wetness;
        if (offset.norm() < closest) {  // its face is the particle's own
            closest = offset.norm();
            nearest = (edge ? closest : offset.dot(n)) / spacing;
        }
        const bool in_front = offset.dot(n) > 0;
        if (in_front) {
            stretching += slope * (p.velocity() - Vec2(rates.wall[w].vx, rates.wall[w].vy)).dot(t) * t.dot(e);
        }

        const bool sees_mean = in_front && sees_mean_pressure(model, fluid.phase(i));
        const double behind = sees_mean ? rates.wall[w].pressure : one_sided;
        const DissipationLimiter limiter{side.impedance(), model.wall_dissipation / side.eos.sound_speed, 0};
        const double mean = model.wall_pair_mean == WallPairMean::harmonic
                                ? guarded_mean(model, p.pressure, behind, p.pressure > 0 && behind > 0)
                                : 0.5 * (p.pressure + behind);
        const double approach = edge ? 0 : in_front ? -velocity.dot(n) : velocity.dot(n);
        double p_star = mean + riemann_dissipation(approach, limiter);
        const double jump = 2 * velocity.dot(e);
        if (model.wall_slip == WallSlip::no && model.viscosity != Viscosity::none &&
            (model.viscosity == Viscosity::symmetric || jump > 0)) {
            p_star += viscosity_lambda(model.viscosity) * side.viscosity * jump / kernel.smoothing_length;
        }
        sums.push -= slope * p_star * e;
    }
    sums.distance = nearest - 0.5;
    const bool alone = fluid.water == fluid.size() && !model.periodic_x;
    if (model.wall_wetting && alone && room > 0 && !(sums.distance < touching_distance))
        sums.compression *= wet / room;
    if (model.wall_velocity == WallVelocity::mirrored && fluid.phase(i) == Phase::water) {
        sums.compression += 0.5 * stretching_share(sums.distance) * stretching;
    }
    return sums;
}

}  // namespace

Rates reference_rates(const FluidParticles& fluid, const WallParticles& walls, const Model& model,
                      double particle_spacing, bool graded) {
    const Lengths lengths{particle_spacing, model.smoothing_ratio, graded};
    Rates rates;
    for (std::size_t w = 0; w < walls.size(); ++w)
        rates.wall.push_back(shepard_mean(walls.state[w], lengths.of_wall(walls.fineness[w]),
                                          walls.own_sum[w], walls.mean[w].wetness, fluid, model, lengths));
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        WallSums sums = wall_sums(fluid, i, walls, rates, model, lengths);
        const double own = lengths.of(fluid.state[i]);
        for (std::size_t j = 0; j < fluid.size(); ++j) {
            if (j == i) continue;
            const Pair pair = pair_of(fluid, i, j, model);
            const WendlandC2 kernel = Lengths::kernel(own, lengths.of(fluid.state[j]));
            const double slope = fluid.state[j].volume * kernel_slope(kernel, pair.distance());
            sums.compression += slope * (pair.u_left() - pair.u_star());
            sums.push -= slope * pair.p_star(kernel.smoothing_length) * pair.e();
        }
        const Vec2 here = fluid.state[i].position();
        double cover = 0;
        for (const FluidState& p : fluid.state)
            cover += p.volume * Lengths::kernel(own, lengths.of(p)).value((here - p.position()).norm());
        for (std::size_t w = 0; w < walls.size(); ++w) {
            const double spacing = particle_spacing / walls.fineness[w];
            cover += spacing * spacing *
                     Lengths::kernel(own, lengths.of_wall(walls.fineness[w]))
                         .value((here - place(walls.state[w])).norm());
        }
        if (sums.distance < touching_distance) cover = touching_kernel_sum + std::max(0.0, -sums.distance);
        rates.kernel_sum.push_back(cover);
        const double density = fluid.state[i].density;
        rates.density.push_back(2 * density * sums.compression);
        rates.acceleration_x.push_back(2 / density * sums.push.x() + model.gravity.x());
        rates.acceleration_y.push_back(2 / density * sums.push.y() + model.gravity.y());
    }
    return rates;
}

double difference(const std::vector<double>& found, const std::vector<double>& expected, std::size_t first,
                  std::size_t last) {
    double worst = 0, scale = 0;
    for (std::size_t i = first; i < last; ++i) {
        worst = std::max(worst, std::abs(found[i] - expected[i]));
        scale = std::max(scale, std::abs(expected[i]));
    }
    return worst / scale;
}

Vec2 reference_pair_force(const FluidParticles& fluid, std::size_t i, std::size_t j, const Model& model,
                          double particle_spacing) {
    const WendlandC2 kernel{model.smoothing_ratio * particle_spacing};
    const Pair pair = pair_of(fluid, i, j, model);
    return 2 * pair.left.volume * pair.right.volume * pair.p_star(kernel.smoothing_length) *
           kernel_slope(kernel, pair.distance()) * pair.e();
}

}  // namespace wetdeck::samples
