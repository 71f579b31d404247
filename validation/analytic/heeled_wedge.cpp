// SPDX-License-Identifier: BSD-3-Clause
// Water entry of a wedge with two different faces at constant velocity: the search for the map, the pressure
// and the loads.
//
// The map (heeled_wedge_map.cpp) has four numbers besides the shape of its free surfaces. They follow from
// four conditions: both surfaces have the same strength K; far out, where the water is at rest, z = s t puts
// the origin at the same point seen from both sides (two conditions); the apex lies where its velocity has
// brought it. On a face, with q the relative velocity U - z towards the tip and l the distance from the tip,
//     p = integral of q dl from the tip - q^2/2.
#include "validation/analytic/heeled_wedge.hpp"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "solver/core/errors.hpp"
#include "validation/analytic/heeled_wedge_balance.hpp"
#include "validation/analytic/heeled_wedge_map.hpp"

namespace wetdeck {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::Vector4d;
using std::numbers::pi;

constexpr double coarse_step = 0.2, fine_step = 0.1;
constexpr double condition_error = 2e-9;
constexpr int most_iterations = 25;
constexpr double smallest_advance = 1.0 / 64;  // of the way from the symmetric wedge
constexpr double largest_suction_share = 0.02;
constexpr double loaded_share = 0.99;

std::array<double, 2> deadrise_of(const HeeledWedgeEntry& entry) {
    return {entry.deadrise_left, entry.deadrise_right};
}

/// Contact angle of a symmetric wedge, a fit good to 1 %.
double symmetric_contact_angle(double deadrise) {
    const double degrees = deadrise * 180 / pi;
    return deadrise * degrees * 2e-3 * (1.343 - 0.015667 * degrees + 1.367e-4 * degrees * degrees);
}

/// A map and the four conditions on its numbers: apex, still - apex, logarithms of the contact angles.
class Search {
  public:
    Search(const HeeledWedgeEntry& entry, double step) : entry_(entry), map_(deadrise_of(entry), step) {}

    HeeledWedgeMap& map() { return map_; }

    Vector4d conditions(const Vector4d& numbers) {
        const HeeledMapParameters parameters{
            numbers(0), numbers(0) + numbers(1), {std::exp(numbers(2)), std::exp(numbers(3))}};
        if (!(std::abs(parameters.apex) < 1 && std::abs(parameters.still) < 1)) {
            throw std::runtime_error("heeled wedge: the acceleration vanishes on a free surface");
        }
        map_.solve(parameters);
        std::array<double, 2> x{}, z{};  // of the apex, in the frame of each side
        for (const int side : both_sides) {
            const auto k = static_cast<std::size_t>(side);
            const double length = map_.face(side).length, deadrise = deadrise_of(entry_)[k];
            x[k] = -map_.surface(side).outer_x - length * std::cos(deadrise);
            z[k] = -map_.surface(side).outer_z - length * std::sin(deadrise);
        }
        const double depth = -(z[0] + z[1]) / 2;
        return {std::log(map_.surface(1).strength / map_.surface(0).strength), (x[0] + x[1]) / depth,
                (z[1] - z[0]) / depth, (x[1] - x[0]) / 2 / depth - entry_.horizontal};
    }

    /// Broyden's method; throws std::runtime_error where it does not end.
    Vector4d solve(Vector4d numbers) {
        constexpr double difference = 1e-4, largest_step = 0.3;
        Vector4d error = conditions(numbers);
        Eigen::Matrix4d slope;
        for (int j = 0; j < 4; ++j) {
            Vector4d moved = numbers;
            moved(j) += difference;
            slope.col(j) = (conditions(moved) - error) / difference;
        }
        for (int i = 0; error.norm() > condition_error; ++i) {
            Vector4d change = -slope.fullPivLu().solve(error);
            change *= std::min(1.0, largest_step / change.cwiseAbs().maxCoeff());
            const Vector4d next = conditions(numbers + change);
            if (i == most_iterations || !next.allFinite()) {
                throw std::runtime_error("heeled wedge: no map found");
            }
            slope += (next - error - slope * change) * change.transpose() / change.squaredNorm();
            numbers += change;
            error = next;
        }
        conditions(numbers);
        return numbers;
    }

  private:
    HeeledWedgeEntry entry_;
    HeeledWedgeMap map_;
};

/// Of the way from the symmetric wedge of the mean deadrise, entering vertically.
HeeledWedgeEntry partly(const HeeledWedgeEntry& entry, double part) {
    const double mean = (entry.deadrise_left + entry.deadrise_right) / 2;
    return {std::lerp(mean, entry.deadrise_left, part), std::lerp(mean, entry.deadrise_right, part),
            part * entry.horizontal};
}

/// The numbers of the map, followed from the symmetric wedge in steps that are halved where the search fails.
Search follow(const HeeledWedgeEntry& entry, Vector4d& numbers) {
    const double angle = std::log(symmetric_contact_angle((entry.deadrise_left + entry.deadrise_right) / 2));
    Search last(partly(entry, 0), coarse_step);
    numbers = last.solve(Vector4d(0, 0, angle, angle));
    Vector4d rate = Vector4d::Zero();
    for (double part = 0, advance = 0.25; part < 1;) {
        const double next_part = std::min(1.0, part + advance);
        try {
            Search next(partly(entry, next_part), coarse_step);
            next.map().begin_with(last.map());
            const Vector4d found = next.solve(numbers + rate * (next_part - part));
            rate = (found - numbers) / (next_part - part);
            numbers = found;
            part = next_part;
            last = next;
        } catch (const std::runtime_error&) {
            advance /= 2;
            if (advance < smallest_advance) throw;
        }
    }
    return last;
}

/// Pressure along a face and what follows from it.
void add_face(HeeledWedgeFace& result, const HeeledFaceFlow& flow, double contact_angle) {
    const ArrayXd& p = flow.pressure;
    const ArrayXd load = p * flow.length_rate * flow.step;
    result.contact_angle = contact_angle;
    result.wetted_length = flow.wetted_length;
    result.normal_force = load.sum();
    Index peak = 0;
    result.peak_pressure = 2 * p.maxCoeff(&peak);
    const ArrayXd distance = flow.wetted_length - flow.length;
    result.peak_distance = std::max(0.0, distance(peak));
    if (peak > 0 && peak + 1 < p.size() &&
        flow.relative_velocity(peak - 1) * flow.relative_velocity(peak + 1) < 0) {
        // q changes its sign between two nodes.
        const Index next =
            flow.relative_velocity(peak) * flow.relative_velocity(peak + 1) < 0 ? peak + 1 : peak - 1;
        const double here = flow.relative_velocity(peak), there = flow.relative_velocity(next);
        result.peak_distance = std::lerp(distance(peak), distance(next), here / (here - there));
    }
    double sum = 0;
    for (Index j = 0; j < p.size() && sum < (1 - loaded_share) * result.normal_force; ++j) {
        sum += load(j);
        result.loaded_length = distance(j);
    }
    for (Index j = p.size() - 1; j > peak && p(j) < 0; --j) {
        result.suction_force += load(j);
        result.suction_length = std::max(0.0, distance(j));
    }
    const double spacing = 1e-4 * flow.wetted_length;  // the nodes crowd at apex and tip
    double last = 0;
    for (Index j = p.size() - 1; j >= 0; --j) {
        if (distance(j) < last + spacing || distance(j) > flow.wetted_length - spacing) continue;
        result.pressure.x.push_back(last = distance(j));
        result.pressure.y.push_back(2 * p(j));
    }
    result.pressure.x.push_back(flow.wetted_length);
    result.pressure.y.push_back(0);
}

HeeledWedge evaluate(const HeeledWedgeEntry& entry, const HeeledWedgeMap& map) {
    HeeledWedge wedge;
    wedge.entry = entry;
    const std::array<double, 2> deadrise = deadrise_of(entry);
    const std::array<HeeledFaceFlow, 2> flow = heeled_face_flows(map, deadrise);
    for (const int side : both_sides) {
        const auto k = static_cast<std::size_t>(side);
        HeeledWedgeFace& face = side == 0 ? wedge.left : wedge.right;
        add_face(face, flow[k], map.parameters().contact_angle[k]);
        const double outwards = side == 0 ? -1 : 1;
        face.tip_x = entry.horizontal + outwards * face.wetted_length * std::cos(deadrise[k]);
        face.tip_z = face.wetted_length * std::sin(deadrise[k]) - 1;
        wedge.force_x -= outwards * face.normal_force * std::sin(deadrise[k]);
        wedge.force_y += face.normal_force * std::cos(deadrise[k]);
        wedge.moment +=
            outwards * flow[k].step *
            (flow[k].pressure * flow[k].length_rate * (flow[k].wetted_length - flow[k].length)).sum();
    }
    for (const HeeledWedgeFace& face : {wedge.left, wedge.right}) {
        wedge.suction_share = std::max(wedge.suction_share, -face.suction_force / face.normal_force);
    }
    const HeeledMomentumLoads loads = heeled_momentum_loads(map, deadrise, flow);
    wedge.momentum_force_x = loads.force_x;
    wedge.momentum_force_y = loads.force_y;
    wedge.momentum_moment =
        loads.moment - (entry.horizontal * loads.force_y + loads.force_x);  // apex at z = -1
    wedge.potential_jump = flow[1].relative_potential - flow[0].relative_potential;
    return wedge;
}

void check(const HeeledWedgeEntry& entry) {
    for (const double deadrise : deadrise_of(entry)) {
        const double degrees = deadrise * 180 / pi;
        if (!(degrees > 7.999 && degrees < 70.001)) {
            throw InputError(fmt::format(
                "face of {:.6g} degrees to the level, the solution of a heeled wedge covers 8 to 70",
                degrees));
        }
    }
    if (!std::isfinite(entry.horizontal))
        throw InputError("horizontal velocity of a heeled wedge is not finite");
}

std::string name_of(const HeeledWedgeEntry& entry) {
    return fmt::format("wedge with faces of {:.6g} and {:.6g} degrees, horizontal velocity {:.6g} V",
                       entry.deadrise_left * 180 / pi, entry.deadrise_right * 180 / pi, entry.horizontal);
}

}  // namespace

HeeledWedge heeled_wedge(const HeeledWedgeEntry& entry) {
    check(entry);
    std::optional<HeeledWedge> coarse, fine;
    try {
        Vector4d numbers;
        Search search = follow(entry, numbers);
        coarse = evaluate(entry, search.map());
        Search finer(entry, fine_step);
        finer.map().begin_with(search.map());
        finer.solve(numbers);
        fine = evaluate(entry, finer.map());
    } catch (const std::runtime_error& error) {
        throw InputError(
            fmt::format("{}: no flow attached to both faces was found ({})", name_of(entry), error.what()));
    }
    if (!(fine->suction_share <= largest_suction_share)) {
        throw InputError(
            fmt::format("{}: the suction of the flow around the apex would bear {:.2g} of the force, more "
                        "than {:.2g}; the water "
                        "separates there, which the attached flow does not describe",
                        name_of(entry), fine->suction_share, largest_suction_share));
    }
    const auto peak = [](const HeeledWedge& wedge) {
        return std::max(wedge.left.peak_pressure, wedge.right.peak_pressure);
    };
    fine->force_x_change = std::abs(fine->force_x - coarse->force_x);
    fine->force_y_change = std::abs(fine->force_y - coarse->force_y);
    fine->moment_change = std::abs(fine->moment - coarse->moment);
    fine->peak_change = std::abs(peak(*fine) / peak(*coarse) - 1);
    return *fine;
}

}  // namespace wetdeck
