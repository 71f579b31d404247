// SPDX-License-Identifier: BSD-3-Clause
// The state of the fluid as pairs in mixed precision read it: positions as 32-bit fixed point, the rest in
// single precision, half a cache line a particle.
//
// A position is a whole number of units modulo 2^32. A unit is a power of two of a metre, the smallest with
// which 2^32 units hold the domain and four supports of the kernel on either side of it. Differences of
// neighbours are then exact and antisymmetric wherever they are, and no two places where particles may be
// are taken for one. In the middle between the domain and its next repetition is nowhere: a particle there is
// out of every support.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "solver/core/vec2.hpp"
#include "solver/particles/fluid.hpp"

namespace wetdeck {

/// A fluid particle in single precision; its numbers stand as in FluidState.
struct alignas(32) MixedState {
    std::uint32_t x = 0;  ///< position [units]
    std::uint32_t y = 0;  ///< position [units]
    float vx = 0;         ///< [m/s]
    float vy = 0;         ///< [m/s]
    float pressure = 0;   ///< [Pa]
    float volume = 0;     ///< [m^2]
    float density = 1;    ///< [kg/m^3]
    float fineness = 1;   ///< where spacings differ: the finest smoothing length over its own
};

/// The unit of positions.
struct FixedPoint {
    double per_metre = 1;  ///< units of a metre, a power of two

    /// `position` [m] in units, modulo 2^32. The product is exact, whether or not the processor adds in the
    /// same operation: all who convert a position find the same bits.
    std::uint32_t fixed(double position) const {
        return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(position * per_metre + unit_mantissa));
    }
    /// The same particle in single precision.
    MixedState operator()(const FluidState& p) const {
        return {fixed(p.x),
                fixed(p.y),
                static_cast<float>(p.vx),
                static_cast<float>(p.vy),
                static_cast<float>(p.pressure),
                static_cast<float>(p.volume),
                static_cast<float>(p.density),
                static_cast<float>(p.fineness)};
    }

    /// A sum with this number has the digits of one in its mantissa: the lowest is a one.
    static constexpr double unit_mantissa = 6755399441055744.0;  // 3 * 2^51
};

/// The fluid, and behind it its periodic images, in single precision.
class MixedFluid {
  public:
    /// @param domain          interior of the tank [m]
    /// @param support_radius  of the kernel [m]
    MixedFluid(Box domain, double support_radius);

    /// Copies `count` particles.
    void copy(const FluidState* fluid, std::size_t count, int threads);
    /// To be kept up by who moves particles.
    MixedState* data() { return state_.data(); }
    /// For who reads them.
    const MixedState* data() const { return state_.data(); }
    /// How positions are converted.
    const FixedPoint& fixed_point() const { return fixed_point_; }
    /// A particle without volume, out of every support.
    const MixedState& nowhere() const { return nowhere_; }
    /// Memory taken.
    std::size_t bytes() const { return state_.capacity() * sizeof(MixedState); }

  private:
    FixedPoint fixed_point_;
    MixedState nowhere_;
    std::vector<MixedState> state_;
};

/// What a kick and a drift change of a particle in single precision.
inline void copy_motion(const FluidState& from, FixedPoint fixed_point, MixedState& to) {
    to.x = fixed_point.fixed(from.x);
    to.y = fixed_point.fixed(from.y);
    to.vx = static_cast<float>(from.vx);
    to.vy = static_cast<float>(from.vy);
}

}  // namespace wetdeck
