// SPDX-License-Identifier: BSD-3-Clause
// FNV-1a, 64 bit: tells texts and files apart against accident, not against malice.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace wetdeck {

inline constexpr std::uint64_t fnv1a_basis = 0xcbf29ce484222325U, fnv1a_prime = 0x100000001b3U;

inline std::uint64_t fnv1a(std::string_view text) {
    std::uint64_t hash = fnv1a_basis;
    for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * fnv1a_prime;
    return hash;
}

/// Over words of 64 bits, which is faster: the last word is filled up with zeros, and each product is folded
/// so that high bits count too.
inline std::uint64_t fnv1a_of_words(std::string_view bytes) {
    std::uint64_t hash = fnv1a_basis;
    for (std::size_t place = 0; place < bytes.size(); place += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + place, std::min(sizeof word, bytes.size() - place));
        hash = (hash ^ word) * fnv1a_prime;
        hash ^= hash >> 32;
    }
    return hash;
}

}  // namespace wetdeck
