// SPDX-License-Identifier: BSD-3-Clause
#include "solver/passes/pair_loop.hpp"

#include <cstdlib>
#include <string>

#include "solver/core/errors.hpp"
#include "solver/passes/instruction_sets.hpp"

namespace wetdeck {

PairLoops pair_loops(const Model& model, const char* instruction_set) {
    struct Choice {
        const char* name;
        bool supported;
        PairLoops (*choose)(const Model&);
    };
    const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                            __builtin_cpu_supports("avx512vl");
    const Choice best_first[] = {{"avx512", has_avx512, avx512::choose_pair_loops},
                                 {"avx2", has_avx2, avx2::choose_pair_loops},
                                 {"sse2", true, sse2::choose_pair_loops}};
    if (!instruction_set) instruction_set = std::getenv("WETDECK_SIMD");
    for (const Choice& choice : best_first) {
        if (instruction_set ? std::string(instruction_set) != choice.name : !choice.supported) continue;
        if (!choice.supported)
            throw InputError(std::string("this processor does not support ") + choice.name);
        PairLoops loops = choice.choose(model);
        loops.instruction_set = choice.name;
        return loops;
    }
    throw InputError("unknown instruction set '" + std::string(instruction_set) +
                     "', expected sse2, avx2 or avx512");
}

std::vector<std::size_t> equal_shares(const std::vector<Cluster>& clusters, int threads, bool only_air) {
    const auto pairs = [only_air](const Cluster& c) {
        if (only_air && c.phase == Phase::water) return std::size_t{c.fluid_neighbours[1]} + 1;
        return std::size_t{c.fluid_neighbours[0]} + c.fluid_neighbours[1] + c.wall_neighbours;
    };
    std::size_t total = 0;
    for (const Cluster& c : clusters) total += pairs(c);
    const auto count = static_cast<std::size_t>(threads);
    std::vector<std::size_t> shares{0};
    std::size_t sum = 0;
    for (std::size_t n = 0; n < clusters.size(); ++n) {
        sum += pairs(clusters[n]);
        while (shares.size() < count && sum * count >= total * shares.size()) shares.push_back(n + 1);
    }
    shares.resize(count + 1, clusters.size());
    return shares;
}

}  // namespace wetdeck
