// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's entry for the target that WETDECK_FUZZ_TARGET names.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto target = wetdeck::fuzz::targets().at(WETDECK_FUZZ_TARGET);
    target({reinterpret_cast<const char*>(data), size});
    return 0;
}
