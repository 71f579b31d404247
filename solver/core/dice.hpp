// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same on every machine, which the distributions of the standard library are not.
#pragma once

#include <cstdint>
#include <random>

namespace wetdeck {

/// Numbers drawn from a seed.
class Dice {
  public:
    /// The same seed gives the same numbers.
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    /// In [-size, size).
    double symmetric(double size) { return size * (2 * static_cast<double>(engine_() >> 11) * 0x1p-53 - 1); }

  private:
    std::mt19937_64 engine_;
};

}  // namespace wetdeck
