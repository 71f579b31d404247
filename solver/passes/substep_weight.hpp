// SPDX-License-Identifier: BSD-3-Clause
// How often a cluster counts in a step of the fast fluid.
#pragma once

#include "solver/passes/pass_input.hpp"

namespace wetdeck::WETDECK_ISA {

/// Factor on the weight of this cluster and on all its pairs but those with fast fluid, which count once.
inline double substep_weight(const PassInput& in, const Cluster& cluster) {
    return cluster.slow ? in.slow_weight : 1;
}

/// Whether a slow cluster only drifts in this step.
inline bool drifts(const PassInput& in, const Cluster& cluster) {
    return cluster.slow && in.slow_weight == 0;
}

/// Whether the pass has nothing to sum for this cluster.
inline bool idle(const PassInput& in, const Cluster& cluster) {
    return in.slow_weight == 0 && cluster.rests;
}

}  // namespace wetdeck::WETDECK_ISA
