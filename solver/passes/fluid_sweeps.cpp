// SPDX-License-Identifier: BSD-3-Clause
// Sweeps over the fluid: which clusters they take, and the density at the end of a step.
#include "solver/passes/rates.hpp"

namespace wetdeck {

SharedClusters Rates::shared(const NeighbourList& list, const std::vector<std::size_t>& shares) const {
    return {list.clusters().data(), shares.data(), next_.data(), team_.size()};
}

ClusterSweep Rates::sweep(double drift, bool all) {
    const ClusterSweep sweep{all || !lets_rest(), drift, drift + left_out_};
    left_out_ = sweep.all ? 0 : sweep.drift_of_resting;
    return sweep;
}

void Rates::bring_up(Flow& flow) {
    if (left_out_ == 0) return;
    MixedFluid* const mixed = mixed_fluid();
    const double drift = left_out_;
    clusters().for_each([&](const Cluster& cluster, int) {
        if (!cluster.rests) return;
        for (std::size_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
            FluidState& p = flow.fluid.state[i];
            p.x += drift * p.vx;
            p.y += drift * p.vy;
            if (mixed) copy_motion(p, mixed->fixed_point(), mixed->data()[i]);
        }
    });
    left_out_ = 0;
}

DensityUpdate::Group Rates::density_update(const Flow& flow, std::size_t group, double dt,
                                           double substep_weight) const {
    const Model& model = setup_.model;
    const bool slow = group == 0, water = constants_.phase_of[group] == 0;
    DensityUpdate::Group update{water ? model.water.eos : model.air.eos, {}};
    DensityBounds& bounds = update.bounds;
    bounds.lowest =
        (water && !model.negative_pressure ? 1 : lowest_density_ratio) * update.eos.reference_density;
    const bool summed = !slow || substep_weight > 0;
    if (dt > 0 && water && model.full_kernel_sum > 0 && summed)
        bounds.kernel_sum = flow.fluid.kernel_sum.data();
    bounds.full_kernel_sum = model.full_kernel_sum;
    const double weight = model.gravity.norm() * setup_.particle_spacing;
    bounds.open =
        update.eos.reference_density * (1 + weight / (update.eos.sound_speed * update.eos.sound_speed));
    return update;
}

void Rates::update_density(Flow& flow, double dt, double substep_weight, const ClusterSweep& sweep) {
    DensityUpdate update;
    update.rate = flow.fluid.density_rate.data();
    update.mass = flow.fluid.mass.data();
    update.mixed = mixed_fluid();
    update.clusters = clusters();
    update.dt = dt;
    update.sweep = sweep;
    for (std::size_t group = 0; group < group_count; ++group)
        update.groups[group] = density_update(flow, group, dt, substep_weight);
    update.graded = setup_.graded();
    passes_.update_density(flow.fluid.state.data(), update);
}

}  // namespace wetdeck
