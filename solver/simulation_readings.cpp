// SPDX-License-Identifier: BSD-3-Clause
// What is read of a simulation without moving it: inputs of a pass, balance of forces, memory.
#include <vector>

#include "solver/simulation.hpp"

namespace wetdeck {
namespace {

/// Sets what passes read of these particles and lists.
void set_state(PassInput& in, const FluidParticles& fluid, const WallParticles& walls, NeighbourList& list) {
    in.fluid = list.listed(fluid);
    in.wall = walls.state.data();
    in.wall_mean = walls.mean.data();
    in.clusters = &list.clusters();
    in.shares = &list.shares();
    in.wall_clusters = &list.wall_clusters();
}

}  // namespace

PassInput Simulation::inputs() const {
    PassInput in = coefficients_;
    set_state(in, fluid_, walls_, list_);
    return in;
}

double Simulation::momentum_error() const {
    if (list_.with_walls_own_lists()) return momentum_error(inputs(), fluid_, walls_);
    // the reactions of the tank are summed from lists that this run does without
    FluidParticles fluid = fluid_;
    WallParticles walls = walls_;
    NeighbourList list(domain_, particle_spacing_, kernel_.support_radius(), 0, true, model_.periodic_x);
    list.place_fixed(walls);
    list.build(fluid, walls, loops_, threads_);
    PassInput in = coefficients_;
    set_state(in, fluid, walls, list);
    return momentum_error(in, fluid, walls);
}

double Simulation::momentum_error(PassInput in, const FluidParticles& fluid,
                                  const WallParticles& walls) const {
    std::vector<double> ax(fluid.size()), ay(fluid.size()), fx(walls.size(), 0), fy(walls.size(), 0);
    in.acceleration_x = ax.data();
    in.acceleration_y = ay.data();
    in.wall_force_x = fx.data();
    in.wall_force_y = fy.data();
    in.fixed_walls = 0;  // the reactions of the tank, too
    loops_.accelerations(in);
    loops_.body_forces(in);
    Vec2 sum = Vec2::Zero();
    double sizes = 0;
    const auto count = [&](Vec2 force) {
        sum += force;
        sizes += force.norm();
    };
    for (std::size_t i = 0; i < fluid.size(); ++i)
        count(fluid.mass[i] * (Vec2(ax[i], ay[i]) - model_.gravity));
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const double x = walls.state[n].x;  // walls run on beyond the ends of a periodic domain
        const bool inside = x >= domain_.low.x() && x < domain_.high.x();
        if (inside || !model_.periodic_x) count({fx[n], fy[n]});
    }
    return sizes > 0 ? sum.norm() / sizes : 0;
}

double Simulation::bytes_per_particle() const {
    const std::size_t own = sizeof(FluidState) + 5 * sizeof(double) + sizeof(std::uint32_t);
    const std::size_t wall =
        sizeof(WallState) + sizeof(WallMean) + 2 * sizeof(double) + sizeof(std::uint32_t);
    const auto count = static_cast<double>(fluid_.size());
    return static_cast<double>(own) + static_cast<double>(walls_.size() * wall + list_.bytes()) / count;
}

}  // namespace wetdeck
