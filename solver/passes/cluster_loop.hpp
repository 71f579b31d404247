// SPDX-License-Identifier: BSD-3-Clause
// The loop over the clusters of fluid particles, shared among threads.
#pragma once

#include "solver/passes/pass_input.hpp"

namespace wetdeck::WETDECK_ISA {

/// Calls `work` for each cluster. A thread takes one share: neighbours in space stay with it from pass to
/// pass.
template <class Work>
void for_clusters(const PassInput& in, Work work) {
    const auto shares = static_cast<std::int64_t>(in.shares->size()) - 1;
#pragma omp parallel for schedule(static) num_threads(in.threads)
    for (std::int64_t n = 0; n < shares; ++n) {
        const auto share = static_cast<std::size_t>(n);
        for (std::size_t k = (*in.shares)[share]; k < (*in.shares)[share + 1]; ++k) work((*in.clusters)[k]);
    }
}

/// Factor on the pairs without air and on the weight of this cluster; pairs with air count once.
inline double substep_weight(const PassInput& in, const Cluster& cluster) {
    return cluster.phase == Phase::water ? in.water_weight : 1;
}

/// Whether the pass has nothing to sum for this cluster: water without air near, in a step of the air alone.
inline bool idle(const PassInput& in, const Cluster& cluster) {
    return cluster.phase == Phase::water && in.water_weight == 0 && cluster.fluid_neighbours[1] == 0;
}

}  // namespace wetdeck::WETDECK_ISA
