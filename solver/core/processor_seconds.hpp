// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace wetdeck {

/// Processor time of all threads of this process since it began [s].
inline double processor_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace wetdeck
