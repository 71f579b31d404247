// SPDX-License-Identifier: BSD-3-Clause
// The kernel of a pair. Where particles differ in their smoothing lengths it has the harmonic mean of both,
//     1/h_ij = (1/h_i + 1/h_j) / 2,
// which needs no division: with the finenesses f = h_finest / h, h_ij = h_finest / f_ij, f_ij = (f_i + f_j)
// / 2. Both sides of a pair find the same kernel, so that their forces stay equal and opposite.
#pragma once

#include "solver/passes/simd/lanes.hpp"

namespace wetdeck::WETDECK_ISA {

/// The kernel of pairs that all have the finest smoothing length. Both shapes count in units of what
/// WendlandC2::normalisation() and slope_factor() make of them.
template <class Number>
struct UniformKernel {
    double inverse_h;  ///< [1/m], or one over the unit of distances

    WETDECK_INLINE Number shape(Number distance) const { return WendlandC2::shape(distance, inverse_h); }
    WETDECK_INLINE Number gradient_shape(Number distance) const {
        return WendlandC2::gradient_shape(distance, inverse_h);
    }
    /// Of what is inversely proportional to the smoothing length.
    static constexpr double fineness = 1;
    /// Volume of a boundary particle over that of the finest.
    static constexpr double wall_volume = 1;
};

/// The kernel of pairs of one mean fineness each.
template <class Number>
struct GradedKernel {
    double inverse_h;        ///< of the finest
    Number fineness;         ///< of the pair
    double wall_volume = 1;  ///< of the boundary particle of the pair, over that of the finest

    WETDECK_INLINE Number shape(Number distance) const {
        return fineness * fineness * WendlandC2::shape(distance, inverse_h * fineness);
    }
    WETDECK_INLINE Number gradient_shape(Number distance) const {
        const Number square = fineness * fineness;
        return square * square * WendlandC2::gradient_shape(distance, inverse_h * fineness);
    }
};

/// Chooses the kernel of each pair of a cluster.
template <bool graded, class Number>
struct PairKernels {
    double inverse_h;      ///< of the finest
    Number half_fineness;  ///< of the cluster, halved; unused where all spacings are equal

    /// @param unit  of distances [m]
    template <class Fluid>
    WETDECK_INLINE PairKernels(const PassInput& in, double unit, const Fluid& cluster)
        : inverse_h(unit / in.kernel.smoothing_length), half_fineness(0.5 * cluster.fineness) {}

    template <class Neighbour>
    WETDECK_INLINE auto with(const Neighbour& j) const {
        if constexpr (graded)
            return GradedKernel<Number>{inverse_h, half_fineness + 0.5 * j.fineness};
        else
            return UniformKernel<Number>{inverse_h};
    }
    WETDECK_INLINE auto with_wall(const PassInput& in, std::uint32_t index) const {
        if constexpr (graded) {
            const double f = in.wall_fineness[index];
            return GradedKernel<Number>{inverse_h, half_fineness + 0.5 * f, 1 / (f * f)};
        } else {
            return UniformKernel<Number>{inverse_h};
        }
    }
};

}  // namespace wetdeck::WETDECK_ISA
