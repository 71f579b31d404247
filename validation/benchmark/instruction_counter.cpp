// SPDX-License-Identifier: BSD-3-Clause
#include "validation/benchmark/instruction_counter.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace wetdeck {

InstructionCounter::InstructionCounter() {
    perf_event_attr event{};
    event.type = PERF_TYPE_HARDWARE;
    event.size = sizeof event;
    event.config = PERF_COUNT_HW_INSTRUCTIONS;
    event.exclude_kernel = 1;
    event.exclude_hv = 1;
    descriptor_ = static_cast<int>(syscall(SYS_perf_event_open, &event, 0, -1, -1, 0));
}

InstructionCounter::~InstructionCounter() {
    if (descriptor_ >= 0) close(descriptor_);
}

std::optional<std::uint64_t> InstructionCounter::count() const {
    std::uint64_t value = 0;
    if (descriptor_ < 0 || read(descriptor_, &value, sizeof value) != sizeof value) return std::nullopt;
    return value;
}

}  // namespace wetdeck
