// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's entry for the target that WETDECK_FUZZ_TARGET names.
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto target = wetdeck::fuzz::targets().at(WETDECK_FUZZ_TARGET);
    // The end of a child process in which a reader is tried is no finding: its parent reports it.
    [[maybe_unused]] static const int registered =
        ::pthread_atfork(nullptr, nullptr, [] { __sanitizer_set_death_callback(nullptr); });
    target({reinterpret_cast<const char*>(data), size});
    return 0;
}
