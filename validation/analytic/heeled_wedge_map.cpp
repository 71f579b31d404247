// SPDX-License-Identifier: BSD-3-Clause
// Water entry of a wedge with two different faces at constant velocity: the conformal map.
//
// The flow, in lengths over V t, is the image of the lower half of a plane zeta; -1 and 1 are the tips of the
// jets, a is the apex, the faces lie between, the free surfaces outside. As for the symmetric wedge
// (wedge_similarity.cpp) the acceleration is tangential on a face, whose particles keep their velocity normal
// to it, and normal on the free surface, whose pressure is constant. So w'' z_zeta^2 (w: complex potential)
// is real on the faces and imaginary on the free surfaces, which with its behaviour at the tips and at
// infinity (dipole) leaves
//     w'' z_zeta^2 = K (zeta - c)/(zeta - a) (1 - zeta^2)^(-3/2).
// The pole is the flow around the apex: the relative velocity behaves as rho^(pi/gamma - 1) at the distance
// rho, gamma > pi being the angle of the fluid there. c = a is the flow that divides at the apex; the
// symmetric wedge has a = c = 0.
// The slope delta of the two free surfaces gives z_zeta by a Cauchy integral over d(delta). The particles
// move along the surface, U - z = -s along the outward tangent, and on both sides
//     s |z_zeta| d(delta)/d|zeta| = K (zeta - c)/(zeta - a) (zeta^2 - 1)^(-3/2).
// Unknown for each side is g = d(delta)/d(log r), r = |zeta| - 1; K follows from its total turn.
#include "validation/analytic/heeled_wedge_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "validation/analytic/anderson_mixing.hpp"

namespace wetdeck {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using std::numbers::pi;

// Ranges in log r and eta, as for the symmetric wedge: its r is a square at infinity.
constexpr double surface_begin = -45, surface_end = 13, face_begin = -45, face_end = 105;
constexpr double equation_error = 1e-10;  // of log g
constexpr int most_iterations = 400;

Index nodes(double begin, double end, double step) {
    return static_cast<Index>(std::lround((end - begin) / step)) + 1;
}

double outwards(int side) {
    return side == 0 ? -1 : 1;
}

}  // namespace

HeeledWedgeMap::HeeledWedgeMap(std::array<double, 2> deadrise, double step)
    : deadrise_(deadrise),
      step_(step),
      l_(ArrayXd::LinSpaced(nodes(surface_begin, surface_end, step), surface_begin, surface_end)),
      r_(l_.exp()),
      kernel_(l_.size(), step) {
    across_.resize(l_.size(), l_.size());
    for (Index j = 0; j < l_.size(); ++j) across_.col(j) = (2 + r_ + r_(j)).log() * step;
    for (HeeledSurface& surface : surfaces_) surface.turn_rate = (0.5 * l_).exp() / (1 + r_).pow(3.5);
}

void HeeledWedgeMap::begin_with(const HeeledWedgeMap& other) {
    for (const int side : both_sides) {
        const ArrayXd& from = other.surface(side).turn_rate;
        ArrayXd& to = surfaces_[static_cast<std::size_t>(side)].turn_rate;
        for (Index i = 0; i < to.size(); ++i) {
            const double place = (l_(i) - other.l_(0)) / other.step_;
            const Index k = std::clamp<Index>(static_cast<Index>(place), 0, from.size() - 2);
            const double part = place - static_cast<double>(k);
            to(i) = std::exp((1 - part) * std::log(from(k)) + part * std::log(from(k + 1)));
        }
    }
}

/// Lengths and strength for the present turn rates; the change of log g that the equation asks for.
ArrayXd HeeledWedgeMap::update(int side) {
    const auto own = static_cast<std::size_t>(side), other = 1 - own;
    HeeledSurface& surface = surfaces_[own];
    const double turn = pi - deadrise_[own] - parameters_.contact_angle[own];
    const double apex = outwards(side) * parameters_.apex, still = outwards(side) * parameters_.still;
    const ArrayXd fixed = (1 - deadrise_[own] / pi) * l_ +
                          (parameters_.contact_angle[other] / pi - 1) * (2 + r_).log() +
                          (deadrise_[0] + deadrise_[1]) / pi * (1 - apex + r_).log();
    const ArrayXd curved =
        kernel_.convolve(surface.turn_rate) + (across_ * surfaces_[other].turn_rate.matrix()).array();
    surface.length_rate = (fixed + curved / pi).exp();
    surface.length = running_integral(surface.length_rate, step_,
                                      surface.length_rate(0) * pi / parameters_.contact_angle[own]);
    const ArrayXd rate = (1 - still + r_) / (1 - apex + r_) * (0.5 * l_).exp() /
                         ((2 + r_).pow(1.5) * surface.length * surface.length_rate);
    surface.strength = turn / (rate.sum() * step_);
    return (surface.strength * rate / surface.turn_rate).log();
}

void HeeledWedgeMap::solve(const HeeledMapParameters& parameters) {
    parameters_ = parameters;
    const Index n = l_.size();
    AndersonMixing mixing;
    ArrayXd unknown(2 * n), change(2 * n);
    for (int iteration = 0;; ++iteration) {
        for (const int side : both_sides) {
            const auto k = static_cast<std::size_t>(side);
            ArrayXd& g = surfaces_[k].turn_rate;
            g *= (pi - deadrise_[k] - parameters.contact_angle[k]) / (g.sum() * step_);
        }
        for (const int side : both_sides) {
            change.segment(side * n, n) = update(side);
            unknown.segment(side * n, n) = surface(side).turn_rate.log();
        }
        const double error = change.abs().maxCoeff();
        if (error < equation_error) break;
        if (!std::isfinite(error) || iteration == most_iterations) {
            throw std::runtime_error("heeled wedge: no free surface found");
        }
        unknown = mixing.next(unknown, change).exp();
        for (const int side : both_sides) {
            surfaces_[static_cast<std::size_t>(side)].turn_rate = unknown.segment(side * n, n);
        }
    }
    for (HeeledSurface& surface : surfaces_) {
        // From outside inwards, where delta is small beside the growing s: g ~ r^(-3).
        const ArrayXd inwards = surface.turn_rate.reverse();
        surface.slope = -running_integral(inwards, step_, inwards(0) / 3).reverse();
        const auto from_tip = [&](const ArrayXd& rate) {
            return rate(0) * surface.length(0) +
                   step_ * ((rate * surface.length_rate).sum() - 0.5 * rate(0) * surface.length_rate(0));
        };
        surface.outer_x = from_tip(surface.slope.cos() - 1);
        surface.outer_z = from_tip(surface.slope.sin());
    }
}

HeeledFace HeeledWedgeMap::face(int side) const {
    const auto own = static_cast<std::size_t>(side), other = 1 - own;
    const double apex = outwards(side) * parameters_.apex, still = outwards(side) * parameters_.still;
    const double width = 1 - apex;
    const Index n = nodes(face_begin, face_end, step_);
    HeeledFace face;
    face.length_rate.resize(n);
    face.velocity_rate.resize(n);
    for (Index j = 0; j < n; ++j) {
        const double eta = face_begin + static_cast<double>(j) * step_;
        const double part_u = -std::log1p(std::exp(-eta)), part_v = -std::log1p(std::exp(eta));
        const double log_u = std::log(width) + part_u, log_v = std::log(width) + part_v;  // from tip, apex
        const double u = std::exp(log_u), v = std::exp(log_v);
        const double far = 2 - u;  // from the other tip
        const double curved = step_ * ((surfaces_[own].turn_rate * (l_ - log_u).exp().log1p()).sum() +
                                       (surfaces_[other].turn_rate * (far + r_).log()).sum());
        const double log_rate = (1 - deadrise_[own] / pi) * log_u +
                                (parameters_.contact_angle[other] / pi - 1) * std::log(far) +
                                (deadrise_[0] + deadrise_[1]) / pi * log_v + part_v + curved / pi;
        face.length_rate(j) = std::exp(log_rate);
        face.velocity_rate(j) =
            (v + apex - still) * std::exp(0.5 * log_u + 2 * part_v - log_v - log_rate) / std::pow(far, 1.5);
    }
    face.length = face.length_rate(0) * pi / parameters_.contact_angle[own] +
                  step_ * (face.length_rate.sum() - 0.5 * face.length_rate(0));
    return face;
}

}  // namespace wetdeck
