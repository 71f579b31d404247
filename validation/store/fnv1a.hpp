// SPDX-License-Identifier: BSD-3-Clause
// FNV-1a, a hash of 64 bits that tells texts and files apart by accident only, not against malice.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace wetdeck::fnv1a {

inline constexpr std::uint64_t offset_basis = 0xcbf29ce484222325U, prime = 0x100000001b3U;

inline std::uint64_t of_bytes(std::string_view text) {
    std::uint64_t hash = offset_basis;
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * prime;
    return hash;
}

/// Over words of 64 bits, which is faster: the last word is filled up with zeros, and each product is folded
/// so that high bits count too.
inline std::uint64_t of_words(std::string_view bytes) {
    std::uint64_t hash = offset_basis;
    for (std::size_t place = 0; place < bytes.size(); place += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + place, std::min(sizeof word, bytes.size() - place));
        hash = (hash ^ word) * prime;
        hash ^= hash >> 32;
    }
    return hash;
}

}  // namespace wetdeck::fnv1a
