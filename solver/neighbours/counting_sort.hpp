// SPDX-License-Identifier: BSD-3-Clause
// Sorting by small whole numbers: the cells of particles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace wetdeck {

/// Order of `keys` under a stable counting sort; `start` receives the first position of each key and an end
/// mark.
inline void counting_sort(std::span<const std::uint32_t> keys, std::size_t key_count,
                          std::vector<std::uint32_t>& start, std::vector<std::uint32_t>& order) {
    start.assign(key_count + 1, 0);
    for (const std::uint32_t key : keys) ++start[key + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    order.resize(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) order[start[keys[i]]++] = static_cast<std::uint32_t>(i);
    std::copy_backward(start.begin(), start.end() - 1, start.end());
    start[0] = 0;
}

}  // namespace wetdeck
