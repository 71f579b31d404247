// SPDX-License-Identifier: BSD-3-Clause
#include "validation/benchmark/machine_limit.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

namespace wetdeck {
namespace {

constexpr std::size_t sampled_clusters = 64, repeats_in_place = 32;
constexpr int bursts = 40;

double neighbours_of(const Cluster& cluster) {
    return cluster.fluid_neighbours[0] + cluster.fluid_neighbours[1] + cluster.wall_neighbours;
}

double neighbours_of(const std::vector<Cluster>& clusters) {
    return std::accumulate(clusters.begin(), clusters.end(), 0.0,
                           [](double sum, const Cluster& cluster) { return sum + neighbours_of(cluster); });
}

/// Wall seconds of the fastest of many calls.
template <class Work>
double fastest(int calls, const Work& work) {
    double best = 1e300;
    for (int call = 0; call < calls; ++call) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const auto end = std::chrono::steady_clock::now();
        best = std::min(best, std::chrono::duration<double>(end - start).count());
    }
    return best;
}

}  // namespace

ArithmeticLimit arithmetic_limit(const Simulation& simulation, int threads) {
    const std::vector<Cluster>& all = simulation.neighbours().clusters();
    const std::size_t stride = std::max<std::size_t>(1, all.size() / sampled_clusters);
    std::vector<Cluster> sample;
    for (std::size_t n = 0; n < all.size(); n += stride)
        sample.insert(sample.end(), repeats_in_place, all[n]);

    const std::size_t size = simulation.fluid().size();
    std::vector<double> density_rate(size), cover(size), acceleration_x(size), acceleration_y(size);
    PassInput in = simulation.inputs();
    const std::vector<std::size_t> shares = equal_shares(sample, threads);
    std::vector<NextCluster> next(static_cast<std::size_t>(threads));
    in.clusters = {sample.data(), shares.data(), next.data(), threads};
    in.density_rate = density_rate.data();
    if (simulation.model().full_kernel_sum > 0) in.kernel_sum = cover.data();
    in.acceleration_x = acceleration_x.data();
    in.acceleration_y = acceleration_y.data();
    in.threads = threads;
    const PairPasses loops = pair_passes(simulation.model(), simulation.instruction_set(),
                                         simulation.execution().precision, simulation.graded());
    const double work = neighbours_of(sample);
    return {work / fastest(bursts, [&] { loops.density_rates(in); }),
            work / fastest(bursts, [&] { loops.accelerations(in); })};
}

double triad_bandwidth(std::size_t bytes, int threads) {
    constexpr double least_bytes_per_burst = 64e6;
    const auto size = static_cast<std::int64_t>(std::max<std::size_t>(bytes / (3 * sizeof(double)), 512));
    std::vector<double> first(static_cast<std::size_t>(size), 0), second(first.size(), 1),
        third(first.size(), 2);
    double* a = first.data();
    const double *b = second.data(), *c = third.data();
    const double moved = 24.0 * static_cast<double>(size);
    const int rounds = static_cast<int>(std::max(1.0, least_bytes_per_burst / moved));
    const double seconds = fastest(10, [&] {
#pragma omp parallel num_threads(threads)
        for (int round = 0; round < rounds; ++round) {
            const double scale = 1.0 + round;
#pragma omp for schedule(static) nowait
            for (std::int64_t i = 0; i < size; ++i) a[i] = b[i] + scale * c[i];
        }
    });
    return moved * rounds / seconds;
}

double listed_neighbours(const Simulation& simulation) {
    return neighbours_of(simulation.neighbours().clusters());
}

}  // namespace wetdeck
