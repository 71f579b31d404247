// SPDX-License-Identifier: BSD-3-Clause
// How a simulation is computed, apart from the physics. Threads change no bit of a result, the instruction
// set no more than its last digits. In mixed precision pairs of fluid particles are computed in single
// precision.
#pragma once

#include <string>

namespace wetdeck {

/// Of the sums over pairs of fluid particles. State, walls, bodies and integration are always in double
/// precision.
enum class Precision { double_precision, mixed };

/// Threads, neighbour list, instruction set and precision of a simulation.
struct Execution {
    int threads = 0;              ///< at most; 0: as many as OpenMP offers
    bool fewer_when_busy = true;  ///< whether threads are left out that others keep waiting (core/team.hpp)
    double skin = 0;              ///< of the neighbour list, in smoothing lengths; 0: chosen as the run goes
    std::string instruction_set = {};  ///< "sse2", "avx2" or "avx512"; empty: the best of this processor
    Precision precision = Precision::double_precision;  ///< of the sums over pairs
};

}  // namespace wetdeck
