// SPDX-License-Identifier: BSD-3-Clause
#include "solver/neighbours/cluster.hpp"

namespace wetdeck {

std::vector<std::size_t> equal_shares(const std::vector<Cluster>& clusters, int threads, Pairs pairs) {
    const auto work = [pairs](const Cluster& c) {
        if (pairs == Pairs::with_fast && c.slow) return std::size_t{c.fluid_neighbours[1]} + 1;
        return std::size_t{c.fluid_neighbours[0]} + c.fluid_neighbours[1] + c.wall_neighbours;
    };
    std::size_t total = 0;
    for (const Cluster& c : clusters) total += work(c);
    const auto count = static_cast<std::size_t>(threads);
    std::vector<std::size_t> shares{0};
    std::size_t sum = 0;
    for (std::size_t n = 0; n < clusters.size(); ++n) {
        sum += work(clusters[n]);
        while (shares.size() < count && sum * count >= total * shares.size()) shares.push_back(n + 1);
    }
    shares.resize(count + 1, clusters.size());
    return shares;
}

}  // namespace wetdeck
