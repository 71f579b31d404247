// SPDX-License-Identifier: BSD-3-Clause
// What this machine could do at best: measured ceilings that the passes are compared with.
#pragma once

#include <cstddef>

#include "solver/simulation.hpp"

namespace wetdeck {

/// Neighbours that a pass takes in per second, all threads together, when nothing but its arithmetic is in
/// the way. One neighbour of a cluster is computed with all eight particles of the cluster at once.
struct ArithmeticLimit {
    double density = 0, momentum = 0;  ///< [1/s]
};

/// The solver's own density and momentum passes over a sample of the clusters of the present state, each
/// repeated until all it reads is in the first-level cache: the same instructions in the same mix of phases
/// and walls, without the traffic of the list. The fastest of many bursts of about a millisecond counts,
/// since other work on the machine can only slow one down.
ArithmeticLimit arithmetic_limit(const Simulation& simulation, int threads);

/// Bandwidth [B/s] of the triad a = b + s c over three arrays of `bytes` together; 24 bytes count per element
/// (what a store reads first does not). Where the arrays fit into a cache it is the bandwidth of that cache.
double triad_bandwidth(std::size_t bytes, int threads);

/// Neighbours in the lists of all clusters of fluid.
double listed_neighbours(const Simulation& simulation);

}  // namespace wetdeck
