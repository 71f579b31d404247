// SPDX-License-Identifier: BSD-3-Clause
// Instructions that a thread executes, by the processor's own counter.
#pragma once

#include <cstdint>
#include <optional>

namespace wetdeck {

/// Counts the instructions of the calling thread outside the kernel from its construction on.
class InstructionCounter {
  public:
    InstructionCounter();
    ~InstructionCounter();
    InstructionCounter(const InstructionCounter&) = delete;
    InstructionCounter& operator=(const InstructionCounter&) = delete;

    /// So far; none where there is no counter, as in most virtual machines, or where the system forbids it
    /// (/proc/sys/kernel/perf_event_paranoid above 2).
    std::optional<std::uint64_t> count() const;

  private:
    int descriptor_;
};

}  // namespace wetdeck
