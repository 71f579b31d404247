// SPDX-License-Identifier: BSD-3-Clause
// Water entry of a symmetric wedge at constant speed, solved by one nonlinear integral equation.
//
// The right half of the flow, in lengths over V t, is the image of the upper half of a plane tau = -r (free
// surface), 0 < tau < 1 (face, tip at 0, apex at 1), tau > 1 (axis). On straight walls and on the free
// surface alike the acceleration is tangential or normal, so Wagner's function, the integral of sqrt(w'') dz,
// maps the fluid on a triangle: w'' z_tau^2 = K tau^(-3/2) (tau - 1)^(-1) up to sign. The slope pi + delta of
// the free surface gives z_tau by a Cauchy integral. A particle of the free surface moves along it, (U - z) =
// -s along the tangent (s: arc length from the tip), and the derivative of that along the surface is the
// equation solved here,
//     s s_r delta_r = K r^(-3/2) (1 + r)^(-1).
// With l = log r and g = d(delta)/dl its unknown is g; K follows from the total turn of the surface, the
// contact angle from x - s -> 0 far out, the unit of length from the depth of the apex below the level there.
#include "validation/analytic/wedge_similarity.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "solver/core/errors.hpp"
#include "validation/analytic/anderson_mixing.hpp"
#include "validation/analytic/log_grid.hpp"

namespace wetdeck {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using std::numbers::pi;

// Ranges in log r and log(tau/(1 - tau)): what is cut off is below 1e-8 of the integrals from 2 to 70
// degrees.
constexpr double surface_begin = -45, surface_end = 25, face_begin = -45, step = 0.1;
constexpr Index surface_nodes = 701, face_nodes = 1501;
constexpr double equation_error = 1e-11;  // of log g; at this step the discretisation costs 1e-6
constexpr int most_iterations = 300;
constexpr double farthest_surface = 20;  // from the tip, of the points handed out, over V t

/// The free surface for a given contact angle, found by iteration, and what the far field says of the angle.
class FreeSurface {
  public:
    explicit FreeSurface(double deadrise)
        : beta_(deadrise),
          l_(ArrayXd::LinSpaced(surface_nodes, surface_begin, surface_end)),
          r_(l_.exp()),
          g_((0.5 * l_).exp() / (1 + r_).square()),
          kernel_(surface_nodes, step) {}

    void solve(double contact_angle) {
        mu_ = contact_angle;
        const double turn = pi - beta_ - mu_;
        const ArrayXd straight = (1 - beta_ / pi) * l_ + (beta_ / pi - 0.5) * (1 + r_).log();
        AndersonMixing mixing;
        for (int iteration = 0;; ++iteration) {
            g_ *= turn / (g_.sum() * step);
            s_l_ = (straight + kernel_.convolve(g_) / pi).exp();
            s_ = running_integral(s_l_, step, s_l_(0) * pi / mu_);  // s ~ r^(mu/pi) at the tip
            const ArrayXd rate = (0.5 * l_).exp() / ((1 + r_) * s_ * s_l_);
            strength_ = turn / (rate.sum() * step);
            const ArrayXd change = (strength_ * rate / g_).log();
            const double error = change.abs().maxCoeff();
            if (error < equation_error) break;
            if (!std::isfinite(error) || iteration == most_iterations) {
                throw std::runtime_error(
                    fmt::format("wedge of {:.6g} degrees: no free surface found", beta_ * 180 / pi));
            }
            g_ = mixing.next(g_.log(), change).exp();
        }
        // From outside inwards, where delta is small beside the growing s: g ~ r^(-3/2).
        const ArrayXd inwards = g_.reverse();
        delta_ = -running_integral(inwards, step, inwards(0) / 1.5).reverse();
    }

    /// log of the factor that the curved surface adds to |z_tau| at tau > 0 on the face.
    double face_factor(double log_tau) const { return step / pi * (g_ * (l_ - log_tau).exp().log1p()).sum(); }

    /// Far out, x minus arc length and z, both counted from the tip.
    double outer_x() const { return from_tip_outwards(delta_.cos() - 1); }
    double outer_z() const { return from_tip_outwards(delta_.sin()); }

    double beta() const { return beta_; }
    double mu() const { return mu_; }
    double strength() const { return strength_; }
    const ArrayXd& s() const { return s_; }
    const ArrayXd& s_l() const { return s_l_; }
    const ArrayXd& delta() const { return delta_; }

  private:
    double from_tip_outwards(const ArrayXd& rate) const {
        return rate(0) * s_(0) + step * ((rate * s_l_).sum() - 0.5 * rate(0) * s_l_(0));
    }

    double beta_;
    double mu_ = 0;
    double strength_ = 0;
    ArrayXd l_, r_, g_;
    ArrayXd s_, s_l_, delta_;
    LogKernel kernel_;
};

/// The face in eta = log(tau/(1 - tau)), from the tip (first node) to the apex.
struct Face {
    ArrayXd log_tau, log_rest;  ///< logarithms of tau and 1 - tau
    ArrayXd length_rate;        ///< |dz/d eta|
    double length = 0;

    explicit Face(const FreeSurface& surface)
        : log_tau(face_nodes), log_rest(face_nodes), length_rate(face_nodes) {
        const double power = surface.beta() / pi;
        for (Index j = 0; j < face_nodes; ++j) {
            const double eta = face_begin + static_cast<double>(j) * step;
            log_tau(j) = -std::log1p(std::exp(-eta));
            log_rest(j) = -std::log1p(std::exp(eta));
            length_rate(j) = std::exp((1 - power) * log_tau(j) + (power + 0.5) * log_rest(j) +
                                      surface.face_factor(log_tau(j)));
        }
        length = length_rate(0) * pi / surface.mu() + step * (length_rate.sum() - 0.5 * length_rate(0));
    }
};

/// x of the far surface minus its arc length, 0 for the right contact angle.
double far_field_error(const FreeSurface& surface) {
    return Face(surface).length * std::cos(surface.beta()) + surface.outer_x();
}

/// Secants for the contact angle.
void find_contact_angle(FreeSurface& surface) {
    // A fit of the result in degrees, good to 1 %; far from the root the iteration need not converge.
    const double degrees = surface.beta() * 180 / pi;
    double angle =
        surface.beta() * degrees * 2e-3 * (1.343 - 0.015667 * degrees + 1.367e-4 * degrees * degrees);
    const auto error_at = [&surface](double contact_angle) {
        surface.solve(contact_angle);
        return far_field_error(surface);
    };
    double before = 1.01 * angle, error_before = error_at(before);
    for (int i = 0; i < 20 && std::abs(angle - before) > 1e-9 * angle; ++i) {
        const double error = error_at(angle);
        const double next = angle - error * (angle - before) / (error - error_before);
        before = std::exchange(angle, next);
        error_before = error;
    }
    if (!(std::abs(angle - before) <= 1e-9 * angle)) {
        throw std::runtime_error(fmt::format("wedge of {:.6g} degrees: no contact angle found", degrees));
    }
    surface.solve(angle);
}

/// Pressure along the face, its maximum and its integral. The tangential velocity U runs from the speed of
/// the tip to that of the apex; dp = (U - z) dU towards the apex, p = 0 at the tip.
void add_pressure(WedgeSimilarity& wedge, const FreeSurface& surface, const Face& face, double unit) {
    const ArrayXd velocity_rate =
        surface.strength() * (0.5 * face.log_tau + face.log_rest).exp() / face.length_rate / unit;
    const ArrayXd length_rate = face.length_rate / unit;
    const ArrayXd length = running_integral(length_rate, step, length_rate(0) * pi / surface.mu());
    const ArrayXd velocity = running_integral(velocity_rate, step, 2 * velocity_rate(0));
    wedge.closure = length(face_nodes - 1) / velocity(face_nodes - 1) - 1;

    ArrayXd pressure = ArrayXd::Zero(face_nodes);
    double force = 0;
    for (Index j = 1; j < face_nodes; ++j) {
        const auto gradient = [&](Index k) { return (length(k) - velocity(k)) * velocity_rate(k); };
        pressure(j) = pressure(j - 1) + 0.5 * step * (gradient(j - 1) + gradient(j));
        force += 0.5 * step * (pressure(j - 1) * length_rate(j - 1) + pressure(j) * length_rate(j));
    }
    wedge.force_coefficient = 2 * std::cos(wedge.deadrise) * force;
    wedge.apex_pressure = 2 * pressure(face_nodes - 1);

    const ArrayXd height = (face.length / unit - length) * std::sin(wedge.deadrise) - 1;
    Index peak = 0;
    wedge.maximum_pressure = 2 * pressure.maxCoeff(&peak);
    wedge.maximum_pressure_height = -1;
    if (pressure(peak) > pressure(face_nodes - 1) * (1 + 1e-9)) {  // U - z changes its sign between two nodes
        const Index next = length(peak) - velocity(peak) > 0 ? peak + 1 : peak - 1;
        const double here = length(peak) - velocity(peak), there = length(next) - velocity(next);
        wedge.maximum_pressure_height = std::lerp(height(peak), height(next), here / (here - there));
    }
    const double spacing = 1e-4 * (wedge.tip_z + 1);  // the nodes crowd at apex and tip
    wedge.pressure = {{-1}, {wedge.apex_pressure}};
    for (Index j = face_nodes - 1; j >= 0; --j) {
        if (height(j) < wedge.pressure.x.back() + spacing || height(j) > wedge.tip_z - spacing) continue;
        wedge.pressure.x.push_back(height(j));
        wedge.pressure.y.push_back(2 * pressure(j));
    }
    wedge.pressure.x.push_back(wedge.tip_z);
    wedge.pressure.y.push_back(0);
}

/// Added mass of the wedge moving down at speed 1 with potential 0 on the free surface: with T = sqrt(tau)
/// the potential on the face is the integral of x'(T') log|(T - T')/(T + T')| dT'/pi, and twice its integral
/// over dx is the mass.
double added_mass(const FreeSurface& surface, const Face& face, double unit) {
    ArrayXd x_rate = face.length_rate * std::cos(surface.beta()) / unit;
    const double tip = x_rate(0);
    x_rate(0) *= 0.5;  // trapezoidal rule
    const ArrayXd root = (0.5 * face.log_tau).exp();
    double sum = 0;
    for (Index j = 0; j < face_nodes; ++j) {
        // |tau - tau'| from the side where it does not cancel.
        const ArrayXd& side = face.log_tau(j) < face.log_rest(j) ? face.log_tau : face.log_rest;
        ArrayXd ratio = (side - side(j)).expm1().abs() * std::exp(side(j)) / (root + root(j)).square();
        ratio(j) = std::exp(face.log_rest(j)) / 4 * step / (2 * pi);  // (dT/d eta)/(2 T), as in LogKernel
        sum += x_rate(j) * (x_rate * ratio.max(1e-300).log()).sum();
    }
    // Below the first node x' ~ exp(p eta): the kernel there is log tanh(|eta - eta'|/4), of integral -pi^2
    // and of first moment -7 zeta(3) to either side.
    constexpr double first_moment = 7 * 1.2020569031595942854;
    const double jet = tip * tip * (pi * pi / (2 * surface.mu() / pi) + first_moment);
    return 2 / pi * (jet - sum * step * step);
}

void add_surface(WedgeSimilarity& wedge, const FreeSurface& surface, double unit) {
    const auto from_tip = [&](const ArrayXd& rate) -> ArrayXd {
        return running_integral(rate * surface.s_l() / unit, step, rate(0) * surface.s()(0) / unit);
    };
    const ArrayXd x = wedge.tip_x + from_tip(surface.delta().cos());
    const ArrayXd z = wedge.tip_z + from_tip(surface.delta().sin());
    wedge.surface_x = {wedge.tip_x};
    wedge.surface_z = {wedge.tip_z};
    for (Index i = 0; i < surface_nodes && wedge.surface_x.back() < wedge.tip_x + farthest_surface; ++i) {
        wedge.surface_x.push_back(x(i));
        wedge.surface_z.push_back(z(i));
    }
}

}  // namespace

WedgeSimilarity wedge_similarity(double deadrise) {
    const double degrees = deadrise * 180 / pi;
    if (!(degrees > 1.999 && degrees < 70.001)) {
        throw InputError(fmt::format("deadrise {:.6g} degrees, the wedge solution covers 2 to 70", degrees));
    }
    FreeSurface surface(deadrise);
    find_contact_angle(surface);
    const Face face(surface);
    const double depth =
        face.length * std::sin(deadrise) + surface.outer_z();  // of the apex below the far level

    WedgeSimilarity wedge;
    wedge.deadrise = deadrise;
    wedge.contact_angle = surface.mu();
    wedge.tip_x = face.length / depth * std::cos(deadrise);
    wedge.tip_z = face.length / depth * std::sin(deadrise) - 1;
    add_pressure(wedge, surface, face, depth);
    add_surface(wedge, surface, depth);
    wedge.added_mass_coefficient = added_mass(surface, face, depth);
    return wedge;
}

double chine_wetting_penetration(const WedgeSimilarity& wedge, double half_beam) {
    constexpr double at_keel = 1e-3;  // of the penetration
    const double height_of_peak = 1 + wedge.maximum_pressure_height;
    if (height_of_peak < at_keel)
        throw InputError(
            "the largest pressure on a wedge of 45 degrees and more is at its keel, and tells not when the "
            "chines are wet: expected a smaller deadrise, or the curve heeled_wedge_force with heel=0");
    return half_beam * std::tan(wedge.deadrise) / height_of_peak;
}

}  // namespace wetdeck
