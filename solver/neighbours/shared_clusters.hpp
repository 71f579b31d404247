// SPDX-License-Identifier: BSD-3-Clause
// Work on all clusters of fluid particles, shared among threads.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>

#include "solver/neighbours/cluster.hpp"

namespace wetdeck {

/// The first cluster of a share that no thread has taken yet, on a cache line of its own.
struct alignas(64) NextCluster {
    std::size_t number = 0;
};

/// All clusters, in one share a thread.
struct SharedClusters {
    const Cluster* clusters = nullptr;
    const std::size_t* shares = nullptr;  ///< first cluster of each share, and an end mark
    NextCluster* next = nullptr;          ///< of each share
    int threads = 1;

    /// Calls work(cluster, thread) once for each cluster, a few clusters at a time. A thread takes those of
    /// its own share, so that neighbours in space stay with it from pass to pass; then what others have left,
    /// so that no more than a few wait for a thread whose core does something else.
    template <class Work>
    void for_each(Work work) const {
        constexpr std::size_t taken_at_once = 16;
        const int count = threads;
        for (int n = 0; n < count; ++n) next[n].number = shares[n];
#pragma omp parallel num_threads(count)
        {
            const int own = omp_get_thread_num();
            for (int turn = 0; turn < count; ++turn) {
                const int share = (own + turn) % count;
                const std::size_t end = shares[share + 1];
                std::atomic_ref<std::size_t> not_taken(next[share].number);
                for (;;) {
                    const std::size_t first = not_taken.fetch_add(taken_at_once, std::memory_order_relaxed);
                    if (first >= end) break;
                    const std::size_t last = std::min(first + taken_at_once, end);
                    for (std::size_t k = first; k < last; ++k) work(clusters[k], own);
                }
            }
        }
    }
};

/// Which clusters a sweep over the fluid takes, and how long they drift.
struct ClusterSweep {
    bool all = true;              ///< else those that rest are left out
    double drift = 0;             ///< [s]
    double drift_of_resting = 0;  ///< with the time for which they have been left out before [s]

    bool leaves_out(const Cluster& cluster) const { return !all && cluster.rests; }
    double drift_of(const Cluster& cluster) const { return cluster.rests ? drift_of_resting : drift; }
};

}  // namespace wetdeck
