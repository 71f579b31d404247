// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/linear_tank.hpp"

#include <cmath>

#include "validation/verification/boundary_elements.hpp"

namespace wetdeck::verification {
namespace {

/// Of linear theory: rho g B of heave; rho g B T GM of roll, GM = T / 2 + B^2 / (12 T) - T for a mass centre
/// on the waterline.
double restoring_coefficient(const StillTank& tank, const FloatingBox& box, Mode mode) {
    const double weight = tank.density * tank.gravity * box.beam;
    if (mode == Mode::heave) return weight;
    const double metacentric_height = box.beam * box.beam / (12 * box.draught) - 0.5 * box.draught;
    return weight * box.draught * metacentric_height;
}

}  // namespace

LinearTank::LinearTank(const StillTank& tank, const FloatingBox& box, const FreeMotion& motion, int cells)
    : gravity_(tank.gravity),
      inertia_(motion.inertia),
      restoring_(restoring_coefficient(tank, box, motion.mode)) {
    const double panel = box.draught / cells, left = 0.5 * (tank.width - box.beam), right = left + box.beam;
    const auto count = [&](double length) { return static_cast<int>(std::lround(length / panel)); };
    std::vector<Panel> panels;
    const double level = tank.depth, keel = level - box.draught;
    append_panels(panels, {tank.width, level}, {right, level}, count(tank.width - right));
    append_panels(panels, {left, level}, {0, level}, count(left));
    const auto surface = static_cast<Eigen::Index>(panels.size());
    append_panels(panels, {right, level}, {right, keel}, cells);
    append_panels(panels, {right, keel}, {left, keel}, count(box.beam));
    append_panels(panels, {left, keel}, {left, level}, cells);
    const auto wet = static_cast<Eigen::Index>(panels.size()) - surface;
    append_panels(panels, {0, level}, {0, 0}, count(level) / 2);
    append_panels(panels, {0, 0}, {tank.width, 0}, count(tank.width) / 2);
    append_panels(panels, {tank.width, 0}, {tank.width, level}, count(level) / 2);
    const Eigen::MatrixXd solution = mixed_solution(panels, surface);
    Eigen::VectorXd share(wet), length_share(wet);  // of the motion's velocity that is normal to a panel
    const Vec2 centre(0.5 * tank.width, level);
    for (Eigen::Index k = 0; k < wet; ++k) {
        const Panel& p = panels[static_cast<std::size_t>(surface + k)];
        const Vec2 n = p.normal(), arm = p.middle() - centre;
        share[k] = motion.mode == Mode::heave ? n.y() : arm.x() * n.y() - arm.y() * n.x();
        length_share[k] = share[k] * p.length();
    }
    slope_of_potential_ = solution.topLeftCorner(surface, surface);
    slope_of_motion_ = solution.block(0, surface, surface, wet) * share;
    load_of_potential_ = tank.density * length_share.transpose() * solution.block(surface, 0, wet, surface);
    added_inertia = tank.density * length_share.dot(solution.block(surface, surface, wet, wet) * share);
}

Curve LinearTank::release(double start, double end) const {
    const Eigen::Index n = slope_of_motion_.size();
    Eigen::VectorXd state = Eigen::VectorXd::Zero(2 * n + 2);  // e, f, q, q'
    state[2 * n] = start;
    const auto rates = [&](const Eigen::VectorXd& z) {
        Eigen::VectorXd rate(2 * n + 2);
        rate.head(n) = slope_of_potential_ * z.segment(n, n) + slope_of_motion_ * z[2 * n + 1];
        rate.segment(n, n) = -gravity_ * z.head(n);
        rate[2 * n] = z[2 * n + 1];
        rate[2 * n + 1] = (gravity_ * load_of_potential_.dot(z.head(n)) - restoring_ * z[2 * n]) /
                          (inertia_ + added_inertia);
        return rate;
    };
    constexpr double step = 0.004;  // the shortest waves, two panels long, turn by less than one
    Curve displacement{{0}, {start}};
    for (int k = 1; k * step <= end; ++k) {
        const Eigen::VectorXd a = rates(state), b = rates(state + 0.5 * step * a),
                              c = rates(state + 0.5 * step * b), d = rates(state + step * c);
        state += step / 6 * (a + 2 * b + 2 * c + d);
        displacement.x.push_back(k * step);
        displacement.y.push_back(state[2 * n]);
    }
    return displacement;
}

}  // namespace wetdeck::verification
