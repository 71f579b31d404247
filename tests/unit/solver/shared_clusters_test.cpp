// SPDX-License-Identifier: BSD-3-Clause
// Work on clusters that threads share: each cluster once, and nobody waits for a thread that is held up.
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <numeric>
#include <thread>

#include "solver/neighbours/shared_clusters.hpp"

using namespace wetdeck;

namespace {

/// Clusters that say by `first` which they are.
std::vector<Cluster> numbered(std::size_t count) {
    std::vector<Cluster> clusters(count);
    for (std::size_t n = 0; n < count; ++n) clusters[n].first = static_cast<std::uint32_t>(n);
    return clusters;
}

}  // namespace

TEST_CASE("Each cluster is worked on once, whatever the shares", "[parallel]") {
    const int threads = GENERATE(1, 2, 3, 7);
    const std::size_t count = GENERATE(0, 1, 15, 16, 17, 1000);
    const std::vector<Cluster> clusters = numbered(count);
    std::vector<std::size_t> shares(static_cast<std::size_t>(threads) + 1, count);
    shares[0] = 0;
    if (threads > 2) shares[1] = shares[2] = count / 3;  // one of them empty
    std::vector<NextCluster> next(static_cast<std::size_t>(threads));
    const SharedClusters shared{clusters.data(), shares.data(), next.data(), threads};
    std::vector<std::atomic<int>> visits(count);
    for (int pass = 1; pass <= 2; ++pass) {
        shared.for_each([&](const Cluster& c, int thread) {
            if (thread >= 0 && thread < threads) ++visits[c.first];
        });
        for (const std::atomic<int>& n : visits) REQUIRE(n == pass);
    }
}

TEST_CASE("Threads that are done take the work of one that is held up", "[parallel]") {
    const std::size_t count = 400, taken_at_once = 16;
    const std::vector<Cluster> clusters = numbered(count);
    const std::vector<std::size_t> shares{0, count / 2, count};
    std::vector<NextCluster> next(2);
    std::atomic<std::size_t> by_the_other = 0;
    bool waited = false;
    SharedClusters{clusters.data(), shares.data(), next.data(), 2}.for_each([&](const Cluster&, int thread) {
        if (thread == 1) {
            ++by_the_other;
            return;
        }
        using Clock = std::chrono::steady_clock;
        const auto end = Clock::now() + std::chrono::seconds(waited ? 0 : 20);
        waited = true;
        while (by_the_other < count - taken_at_once && Clock::now() < end) std::this_thread::yield();
    });
    CHECK(by_the_other >= count - taken_at_once);  // all, where the first one comes too late
}
