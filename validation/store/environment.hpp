// SPDX-License-Identifier: BSD-3-Clause
// Choices that a user makes by environment variables.
#pragma once

#include <cstdlib>
#include <string>

namespace wetdeck {

/// The instruction set that WETDECK_SIMD names ("sse2", "avx2", "avx512"); empty: the best of this processor.
inline std::string instruction_set_from_environment() {
    const char* name = std::getenv("WETDECK_SIMD");
    return name ? name : "";
}

}  // namespace wetdeck
