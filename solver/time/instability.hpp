// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "solver/core/vec2.hpp"

namespace wetdeck {

/// Speeds beyond this multiple of the sound speed end a run; with the bound on densities that keeps the step,
/// C h/(c + v), from creeping towards zero.
inline constexpr double highest_mach_number = 10;

/// Why a run cannot go on.
struct Instability {
    double time = 0;                        ///< [s]
    std::uint64_t step = 0;                 ///< steps done by then
    std::optional<std::uint32_t> particle;  ///< id; none where a body is in trouble
    Vec2 position = Vec2::Zero();           ///< of the particle or of the body [m]
    std::string quantity;                   ///< what left its range, with its value

    /// One sentence for a person.
    std::string describe() const;
};

}  // namespace wetdeck
