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

/// Factor on the weight of this cluster and on all its pairs but those with fast fluid, which count once.
inline double substep_weight(const PassInput& in, const Cluster& cluster) {
    return cluster.slow ? in.slow_weight : 1;
}

/// Whether a slow cluster only drifts in this step.
inline bool drifts(const PassInput& in, const Cluster& cluster) {
    return cluster.slow && in.slow_weight == 0;
}

/// Whether the pass has nothing to sum for this cluster: it drifts, and no fast fluid is near.
inline bool idle(const PassInput& in, const Cluster& cluster) {
    return drifts(in, cluster) && cluster.fluid_neighbours[1] == 0;
}

}  // namespace wetdeck::WETDECK_ISA
