// SPDX-License-Identifier: BSD-3-Clause
// How a simulation is computed, apart from the physics. Threads and instruction set change no more than the
// last digits of a result.
#pragma once

#include <string>

namespace wetdeck {

/// Threads, neighbour list and instruction set of a simulation.
struct Execution {
    int threads = 0;                   ///< 0: as many as OpenMP offers
    double skin = 0.2;                 ///< of the neighbour list, in smoothing lengths
    std::string instruction_set = {};  ///< "sse2", "avx2" or "avx512"; empty: the best of this processor
};

}  // namespace wetdeck
